#include "demo/character/garment/gltf_mesh.h"

#include "demo/character/garment/gltf_data.h"

namespace weft::demo {
namespace {

Result<void> add_primitive(const GltfModel& model, const GltfPrimitive& primitive,
                           const Eigen::Affine3f& place, Mesh& to) {
    const std::string name = primitive.material ? std::to_string(*primitive.material) : "none";
    const auto found = primitive.attribute("POSITION");
    if (!found)
        return Error{ErrorCode::malformed_file, "the primitive of material " + name + " has no POSITION"};
    const auto numbers = gltf_numbers(model, *found, 3);
    if (!numbers) return numbers.error();
    const std::size_t vertices = numbers->size() / 3;
    const auto triangles = gltf_triangles(model, primitive, vertices, name);
    if (!triangles) return triangles.error();
    std::vector<Vec3> positions;
    for (std::size_t v = 0; v < vertices; ++v) {
        const Vector3 own = Eigen::Map<const Eigen::Vector3d>(numbers->data() + 3 * v).cast<float>();
        positions.push_back(to_vec3(place * own));
    }
    if (auto added = add_part(positions, *triangles, to); !added)
        return Error{added.error().code, "the primitive of material " + name + ": " + added.error().message};
    return {};
}

Result<Mesh> mesh_of(const GltfModel& model) {
    const auto places = gltf_globals(model, gltf_places(model));
    if (!places) return places.error();
    Mesh mesh;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (!model.nodes[n].mesh) continue;
        for (const GltfPrimitive& each : model.meshes[*model.nodes[n].mesh]) {
            if (!each.is_of_triangles) continue;  // lines and points are no cloth
            if (auto added = add_primitive(model, each, (*places)[n], mesh); !added) return added.error();
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
