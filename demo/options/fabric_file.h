#pragma once
// Fabrics by name or from JSON files.

#include <filesystem>
#include <string>

#include "weft/weft.h"

namespace weft::demo {

/// Reads a fabric from either of two kinds of file, told apart by their keys:
///
/// Weft's own files have the fields of Fabric, in their units; fields left out have Fabric's defaults:
///
///     {"areal_density": 0.2, "warp": 400, "weft": 400, "shear": 100, "bending": 2e-5, "damping": 2e-4,
///      "stiffening": 0, "bending_ratio": 1}
///
/// Files of Wang, O'Brien and Ramamoorthi ("Data-Driven Elastic Models for Cloth", SIGGRAPH 2011) have
/// "density" [kg/m^2], "stretching": six samples of c11, c12, c22, c33 [N/m], and "bending": five curvatures
/// in each of three directions [N m]. They become a Fabric as fabrics.h says: lateral contraction (c12), and
/// how stiffness changes with strain and curvature, are left out.
///
/// MeasuredStretch::stiffening takes warp, weft and stiffening from how the samples grow with strain. The
/// first row is of cloth near rest, the second and the last of 1/6 of strain along each axis, and stiffness
/// is linear between (as ARCSim reads the files). Stiffness is by Green's strain, E = e + e^2 / 2, so the
/// tension of uniaxial stretch is c(e) E (1 + e). K e (1 + stiffening e) is fitted to this tension, with one
/// stiffening for both axes. The residual is at most 1.1 % of the tension at 1/6 for the three wovens, 1.9 %
/// for the jacket, 2.2 to 6.4 % for the other five; MeasuredStretch::constant is 21 to 61 % off there.
/// Stiffening is 2 to 4 for wovens and pile, 1.5 to 116 for the rest. A sheet whose shear passes warp or weft
/// near rest, as soft knits have it, is stiffer there than it should be (see Fabric): meshes are not.
///
/// Errors name the file and the key, and say which values are valid.
enum class MeasuredStretch { constant, stiffening };
[[nodiscard]] Result<Fabric> load_fabric(const std::filesystem::path& file,
                                         MeasuredStretch stretch = MeasuredStretch::constant);

/// Finds a fabric by a name of fabrics(), or reads a file that ends in ".json". "stiffening:" before a
/// measured file selects MeasuredStretch::stiffening.
[[nodiscard]] Result<Fabric> find_fabric(const std::string& name_or_file);

}  // namespace weft::demo
