#include "demo/character/garment/gltf_mesh.h"

#include "weft/gltf.h"

namespace weft::demo {

bool is_gltf(const std::filesystem::path& file) {
    return file.extension() == ".gltf" || file.extension() == ".glb";
}

bool has_skin(const std::filesystem::path& file) {
    const auto asset = GltfAsset::load(file);
    return asset && !asset->joints().empty();
}

Result<Mesh> read_gltf_mesh(const std::filesystem::path& file) {
    const auto asset = GltfAsset::load(file);
    if (!asset) return asset.error();
    if (!asset->left_out().empty()) {  // all of the file is the garment
        const Error& fault = asset->left_out().front().fault;
        return Error{fault.code, file.string() + ": " + fault.message};
    }
    Mesh mesh = asset->mesh();
    if (!mesh.triangles.empty()) return mesh;
    return Error{ErrorCode::invalid_mesh,
                 file.string() + ": no node has a mesh of triangles; cloth needs some"};
}

}  // namespace weft::demo
