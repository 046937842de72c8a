#pragma once
// Fabrics by name or from JSON files.

#include <filesystem>
#include <string>

#include "weft/weft.h"

namespace weft::demo {

/// Reads a fabric from either of two kinds of file, told apart by their keys:
///
/// Weft's own has the fields of Fabric, in their units; those left out have Fabric's defaults:
///
///     {"areal_density": 0.2, "warp": 400, "weft": 400, "shear": 100, "bending": 2e-5, "damping": 2e-4}
///
/// Those of Wang, O'Brien and Ramamoorthi ("Data-Driven Elastic Models for Cloth", SIGGRAPH 2011) have
/// "density" [kg/m^2], "stretching": six samples of c11, c12, c22, c33 [N/m], and "bending": five curvatures
/// in each of three directions [N m]. They become a Fabric as fabrics.h says. That is the cloth near rest:
/// lateral contraction (c12), and how stiffness changes with strain and curvature, are left out.
///
/// Errors name the file and the key, and say what would be right.
[[nodiscard]] Result<Fabric> load_fabric(const std::filesystem::path& file);

/// A name of fabrics(), or a file that ends in ".json".
[[nodiscard]] Result<Fabric> find_fabric(const std::string& name_or_file);

}  // namespace weft::demo
