#pragma once
// Checks that a save's values are ones that a World can reach. The checksum does not suffice: whoever changes
// a save can compute it anew. Indices must be in range, and values finite and within limits; whether the
// motion is physical is not checked.

#include <cstddef>
#include <string>

#include "cloth/simulation/simulation.h"
#include "cloth/store/save_format.h"
#include "weft/error.h"

namespace weft {

/// Checks the World's own part. Precondition: all bytes of that part are there.
[[nodiscard]] Result<void> check_world_part(const Simulation& here, const SaveReader& reader);
/// Checks the part of a deformed shape, which follows its head.
[[nodiscard]] Result<void> check_shape_part(std::size_t number, const ShapeHead& head,
                                            const SaveReader& reader);
/// Checks the part of a cloth, which follows its head and has the shares of `bodies`. Preconditions: the head
/// fits the cloth here, and all bytes that it announces are there.
[[nodiscard]] Result<void> check_cloth_part(const std::string& cloth, const ClothHead& head,
                                            const ClothState& here, std::size_t bodies,
                                            const SaveReader& reader);

}  // namespace weft
