#pragma once
// Named fabrics, each with the source of its figures.
//
// Wang, O'Brien and Ramamoorthi measured ten fabrics ("Data-Driven Elastic Models for Cloth", SIGGRAPH 2011);
// those named below have these figures. warp, weft: means of their six samples of stretch, the stiffer one
// called warp, as in denim with elastane in its weft. shear: the mean of those of their samples that are
// positive, as a stiffness per angle: denim's 69 N/m is near the 84 to 191 of a KES tester. bending: a
// quarter of the mean over their three directions and five curvatures. They fitted the hinge of Bridson et
// al. 2003, whose energy for small angles, k l^2 theta^2 / (8 (A + A')), is a plate's with B = k / 4; denim's
// 18 uN m are then within the tester's 14 to 22. None of the sources measured damping: all fabrics have the
// default.

#include <span>

#include "weft/export.h"
#include "weft/settings.h"

namespace weft {

struct NamedFabric {
    const char* name;
    Fabric fabric;
    const char* source;  ///< source of the figures, and which of them are guesses
};

// clang-format off
/// All named fabrics, the least stiff in bending first:
///
/// | name         | kg/m^2 | warp, weft N/m | shear N/m | bending uN m | figures from                   |
/// |--------------|--------|----------------|-----------|--------------|--------------------------------|
/// | cotton       | .092   | 1675, 338      | 40 *      | 2.2          | a voile; unpublished           |
/// | light-jacket | .113   | 296, 115       | 31        | 4.7          | Wang et al., tango-red-jet-set |
/// | t-shirt      | .187   | 281, 84        | 34        | 5.4          | Wang et al., gray-interlock    |
/// | tablecloth   | .128   | 2126, 2090     | 40        | 7.8          | Wang et al., white-dots-on-blk |
/// | silk         | .106   | 588, 1035      | 30 *      | 13           | a cupro lining; unpublished    |
/// | flag         | .079   | 6571, 3560     | 150 *     | 17           | a polyester dobby; unpublished |
/// | denim        | .324   | 1048, 223      | 69        | 18           | Wang et al., 11oz-black-denim  |
/// | trousers     | .220   | 2129, 2094     | 59        | 43           | Wang et al., royal-target      |
/// | leather      | .560   | 7000, 7000     | 2800 *    | 290 *        | no source: 0.7 mm of 10 MPa    |
///
/// Figures marked * are guesses. Fabric::stiffening is 0. Where Wang et al. measured how stiffness grows with
/// strain, this table has the stiffening, and the stiffness near rest that belongs to it. The fit goes up to
/// a strain of 1/6; the error is the greatest one over the tension there:
///
/// | name         | stiffening | warp, weft N/m | error | constants' error |
/// |--------------|------------|----------------|-------|------------------|
/// | light-jacket | 12.5       | 163, 31        | .019  | .28 to .42       |
/// | t-shirt      | 76         | 36, 4          | .033  | .45 to .48       |
/// | tablecloth   | 2.25       | 1979, 1942     | .003  | .22              |
/// | denim        | 2.5        | 949, 206       | .011  | .21 to .24       |
/// | trousers     | 2          | 2033, 1997     | .004  | .21 to .22       |
// clang-format on
[[nodiscard]] WEFT_API std::span<const NamedFabric> fabrics() noexcept;

}  // namespace weft
