#pragma once
// Whether what a save holds is what a World can come to. A right checksum does not say so: whoever changes a
// save can make that, too. What a step finds things by has to be in its range, and what it computes with has
// to be numbers; that the motion is physical nobody asks.

#include <cstddef>

#include "cloth/simulation/simulation.h"
#include "cloth/store/save_format.h"
#include "weft/error.h"

namespace weft {

/// Of the World's own part. Precondition: as many bytes are there as that takes here.
[[nodiscard]] Result<void> check_world_part(const WorldState& here, const SaveReader& reader);
/// Of a shape that was deformed, behind its head.
[[nodiscard]] Result<void> check_shape_part(std::size_t number, const ShapeHead& head,
                                            const SaveReader& reader);
/// Of a cloth, behind its head, which fits the one here. Precondition: as many bytes are there as that says.
[[nodiscard]] Result<void> check_cloth_part(std::size_t number, const ClothHead& head, const ClothState& here,
                                            const SaveReader& reader);

}  // namespace weft
