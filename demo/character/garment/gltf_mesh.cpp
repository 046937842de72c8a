#include "demo/character/garment/gltf_mesh.h"

#include "demo/character/garment/gltf_data.h"

namespace weft::demo {
namespace {

/// Lines and points are no cloth.
bool has_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == -1 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
}

Result<void> add_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                           const Eigen::Affine3f& place, Mesh& to) {
    const std::string name = std::to_string(primitive.material);
    const auto found = primitive.attributes.find("POSITION");
    if (found == primitive.attributes.end())
        return Error{ErrorCode::malformed_file, "the primitive of material " + name + " has no POSITION"};
    const auto positions = gltf_numbers(model, found->second, 3);
    if (!positions) return positions.error();
    const auto triangles = gltf_triangles(model, primitive, positions->size() / 3, name);
    if (!triangles) return triangles.error();
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const auto& [a, b, c] : *triangles) to.triangles.push_back({first + a, first + b, first + c});
    for (std::size_t i = 0; i < positions->size(); i += 3)
        to.positions.push_back(to_vec3(place * Vector3(static_cast<float>((*positions)[i]),
                                                       static_cast<float>((*positions)[i + 1]),
                                                       static_cast<float>((*positions)[i + 2]))));
    return {};
}

Result<Mesh> mesh_of(const tinygltf::Model& model) {
    const auto parents = gltf_parents(model);
    if (!parents) return parents.error();
    const std::vector<Eigen::Affine3f> places = gltf_globals(gltf_places(model), *parents);
    Mesh mesh;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const auto which = static_cast<std::size_t>(model.nodes[n].mesh);
        if (model.nodes[n].mesh < 0 || which >= model.meshes.size()) continue;
        for (const tinygltf::Primitive& each : model.meshes[which].primitives) {
            if (!has_triangles(each)) continue;
            if (auto added = add_primitive(model, each, places[n], mesh); !added) return added.error();
        }
    }
    if (mesh.triangles.empty())
        return Error{ErrorCode::invalid_mesh, "no node has a mesh of triangles; cloth needs some"};
    return mesh;
}

}  // namespace

bool is_gltf(const std::filesystem::path& file) {
    return file.extension() == ".gltf" || file.extension() == ".glb";
}

bool has_skin(const std::filesystem::path& file) {
    const auto model = load_gltf(file);
    return model && !model->skins.empty() && !model->skins.front().joints.empty();
}

Result<Mesh> read_gltf_mesh(const std::filesystem::path& file) {
    const auto model = load_gltf(file);
    if (!model) return model.error();
    auto mesh = mesh_of(*model);
    if (!mesh) return Error{mesh.error().code, file.string() + ": " + mesh.error().message};
    return mesh;
}

}  // namespace weft::demo
