#include "demo/gltf/gltf_model.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "demo/gltf/gltf_buffers.h"
#include "demo/gltf/gltf_fields.h"
#include "demo/number_json.h"

namespace weft {
namespace {

constexpr double most_float = std::numeric_limits<float>::max();
constexpr std::size_t most_zeros = std::size_t{1} << 20;  // elements of an accessor that has no bytes

/// Index of the key's text among `names`; none, and an error, for any other text.
template <std::size_t n>
std::optional<std::size_t> choice(const GltfFields& from, const char* key,
                                  const std::array<std::string_view, n>& names) {
    const auto found = std::ranges::find(names, from.text(key));
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string all;
    for (const std::string_view name : names) all.append(all.empty() ? "" : ", ").append(name);
    from.must(key, "one of " + all);
    return std::nullopt;
}

Vector3 vector_of(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::Vector3d>(numbers.data()).cast<float>();
}

class ModelReader {
  public:
    ModelReader(const GltfFields& file, std::vector<std::vector<unsigned char>> buffers) : file_(file) {
        model_.buffers = std::move(buffers);
    }

    GltfModel read() {
        for (const GltfFields& each : file_.objects("bufferViews")) model_.views.push_back(view(each));
        for (const GltfFields& each : file_.objects("accessors")) model_.accessors.push_back(accessor(each));
        for (const GltfFields& each : file_.objects("nodes")) model_.nodes.push_back(node(each));
        link_nodes();
        for (const GltfFields& each : file_.objects("textures"))
            pictures_.push_back(each.index("source", file_.size("images")));
        for (const GltfFields& each : file_.objects("materials")) model_.materials.push_back(material(each));
        for (const GltfFields& each : file_.objects("meshes")) model_.meshes.push_back(mesh(each));
        for (const GltfFields& each : file_.objects("skins")) model_.skins.push_back(skin(each));
        if (const auto animations = file_.objects("animations"); !animations.empty())
            read_animation(animations.front());
        return std::move(model_);
    }

  private:
    GltfView view(const GltfFields& from) const {
        GltfView view;
        view.buffer = from.needed_index("buffer", model_.buffers.size());
        view.offset = from.whole("byteOffset", 0);
        view.bytes = from.whole("byteLength", 0);
        view.stride = from.whole("byteStride", 0, 252);
        if (view.buffer >= model_.buffers.size()) return view;
        const std::size_t available = model_.buffers[view.buffer].size();
        if (view.offset > available || view.bytes > available - view.offset)
            from.complain("has " + std::to_string(view.bytes) + " bytes from byte " +
                          std::to_string(view.offset) + " on; its buffer has " + std::to_string(available));
        return view;
    }

    GltfAccessor accessor(const GltfFields& from) const {
        constexpr std::array<std::string_view, 7> shapes{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                         "MAT2",   "MAT3", "MAT4"};
        constexpr std::array<std::size_t, 7> components{1, 2, 3, 4, 4, 9, 16};
        GltfAccessor accessor;
        accessor.view = from.index("bufferView", file_.size("bufferViews"));
        accessor.offset = from.whole("byteOffset", 0);
        accessor.count = from.whole("count", 0);
        accessor.normalised = from.flag("normalized");
        accessor.components = components[choice(from, "type", shapes).value_or(0)];
        accessor.type = component_type(from);
        if (accessor.view) check_range(from, accessor, *accessor.view);
        if (from.has("sparse")) accessor.sparse = sparse(from.object("sparse"), accessor);
        if (accessor.sparse && !accessor.view && accessor.count > most_zeros)
            from.complain("has " + std::to_string(accessor.count) +
                          " elements and no bufferView; there may be " + std::to_string(most_zeros));
        return accessor;
    }

    static GltfType component_type(const GltfFields& from) {
        const std::size_t type = from.whole("componentType", 0);
        if (type >= 5120 && type <= 5126 && type != 5124) return static_cast<GltfType>(type);
        from.must("componentType", "5120, 5121, 5122, 5123, 5125 or 5126");
        return GltfType::f32;
    }

    GltfSparse sparse(const GltfFields& from, const GltfAccessor& of) const {
        const GltfFields indices = from.object("indices"), values = from.object("values");
        GltfSparse sparse;
        sparse.count = from.whole("count", 0, of.count);
        sparse.index_view = indices.needed_index("bufferView", file_.size("bufferViews"));
        sparse.index_offset = indices.whole("byteOffset", 0);
        sparse.index_type = component_type(indices);
        sparse.value_view = values.needed_index("bufferView", file_.size("bufferViews"));
        sparse.value_offset = values.whole("byteOffset", 0);
        check_range(indices,
                    {.offset = sparse.index_offset, .count = sparse.count, .type = sparse.index_type},
                    sparse.index_view);
        check_range(values,
                    {.offset = sparse.value_offset,
                     .count = sparse.count,
                     .type = of.type,
                     .components = of.components},
                    sparse.value_view);
        return sparse;
    }

    /// Complains of elements that do not lie within a view. A view that is not there has been complained of.
    void check_range(const GltfFields& from, const GltfAccessor& accessor, std::size_t of_view) const {
        if (of_view >= model_.views.size()) return;
        const GltfView& view = model_.views[of_view];
        const std::size_t element = bytes_of(accessor.type) * accessor.components;
        const std::size_t stride = view.stride == 0 ? element : view.stride;
        if (stride < element)
            from.complain("has elements of " + std::to_string(element) + " bytes; its view has one every " +
                          std::to_string(stride));
        if (accessor.count == 0 && accessor.offset <= view.bytes) return;
        const bool fits = accessor.count <= view.bytes && accessor.offset <= view.bytes &&
                          (accessor.count - 1) * stride + element <= view.bytes - accessor.offset;
        if (!fits)
            from.complain("has " + std::to_string(accessor.count) + " elements of " +
                          std::to_string(element) + " bytes, one every " + std::to_string(stride) +
                          ", from byte " + std::to_string(accessor.offset) + " on; its view has " +
                          std::to_string(view.bytes) + " bytes");
    }

    GltfNode node(const GltfFields& from) const {
        GltfNode node;
        node.name = from.text("name");
        node.mesh = from.index("mesh", file_.size("meshes"));
        node.skin = from.index("skin", file_.size("skins"));
        if (const auto matrix = from.numbers("matrix", 16); !matrix.empty()) {
            node.place = place_of_matrix(matrix);
            return node;
        }
        const auto translation = from.numbers("translation", 3), scale = from.numbers("scale", 3);
        if (!translation.empty()) node.place.translation = vector_of(translation);
        if (!scale.empty()) node.place.scale = vector_of(scale);
        if (const auto q = from.numbers("rotation", 4); !q.empty()) {
            const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
            if (!(rotation.norm() > 1e-6)) from.must("rotation", "a quaternion of length 1");
            node.place.rotation = rotation.normalized().cast<float>();
        }
        return node;
    }

    static NodePlace place_of_matrix(const std::vector<double>& columns) {
        const Eigen::Map<const Eigen::Matrix4d> matrix(columns.data());
        NodePlace place;
        place.translation = matrix.block<3, 1>(0, 3).cast<float>();
        Eigen::Matrix3d axes = matrix.block<3, 3>(0, 0);
        for (int i = 0; i < 3; ++i) {
            const double length = std::clamp(axes.col(i).norm(), 1e-6, most_float);
            place.scale[i] = static_cast<float>(length);
            axes.col(i) /= length;
        }
        place.rotation = Eigen::Quaterniond(axes).normalized().cast<float>();
        return place;
    }

    /// Finds parents, and an order of nodes in which parents come first. Nodes of a cycle have no such order.
    void link_nodes() {
        std::vector<GltfNode>& nodes = model_.nodes;
        std::vector<std::vector<std::size_t>> children;
        for (const GltfFields& each : file_.objects("nodes"))
            children.push_back(each.indices("children", nodes.size()));
        for (std::size_t n = 0; n < nodes.size(); ++n)
            for (const std::size_t child : children[n]) {
                if (nodes[child].parent)
                    file_.complain("has node " + std::to_string(child) + " as a child of both node " +
                                   std::to_string(*nodes[child].parent) + " and node " + std::to_string(n));
                nodes[child].parent = n;
            }
        std::vector<std::size_t>& order = model_.parents_first;
        for (std::size_t n = 0; n < nodes.size(); ++n)
            if (!nodes[n].parent) order.push_back(n);
        for (std::size_t k = 0; k < order.size() && order.size() <= nodes.size(); ++k)
            order.insert(order.end(), children[order[k]].begin(), children[order[k]].end());
        if (order.size() == nodes.size()) return;
        std::vector<bool> reached(nodes.size(), false);
        for (const std::size_t n : order) reached[n] = true;
        const auto in_cycle = std::ranges::find(reached, false) - reached.begin();
        file_.complain("has node " + std::to_string(in_cycle) +
                       ", which is its own ancestor or has one that is");
    }

    GltfMaterial material(const GltfFields& from) const {
        constexpr std::size_t last_set = 7;
        GltfMaterial material;
        material.name = from.text("name");
        const GltfFields shading = from.object("pbrMetallicRoughness");
        const GltfFields texture = shading.object("baseColorTexture");
        if (const auto index = texture.index("index", pictures_.size())) material.picture = pictures_[*index];
        material.texcoords = texture.whole("texCoord", 0, last_set);
        const auto c = shading.numbers("baseColorFactor", 4);
        const auto part = [&](std::size_t k) { return static_cast<float>(std::clamp(c[k], 0.0, 1.0)); };
        if (!c.empty()) material.colour = Vec3{part(0), part(1), part(2)};
        return material;
    }

    std::vector<GltfPrimitive> mesh(const GltfFields& from) const {
        constexpr std::size_t triangles = 4, most = 6, most_ids = std::size_t{1} << 32;
        std::vector<GltfPrimitive> primitives;
        for (const GltfFields& each : from.objects("primitives")) {
            GltfPrimitive primitive;
            primitive.attributes = each.named_indices("attributes", model_.accessors.size());
            primitive.indices = each.index("indices", model_.accessors.size());
            primitive.material = each.index("material", model_.materials.size());
            const std::size_t mode = each.whole("mode", triangles, most);
            if (mode >= triangles) primitive.triangles = static_cast<GltfTriangles>(mode);
            const GltfFields extensions = each.object("extensions");
            if (constexpr auto draco = "KHR_draco_mesh_compression"; extensions.has(draco))
                primitive.compressed =
                    GltfCompressed{extensions.object(draco).needed_index("bufferView", model_.views.size()),
                                   extensions.object(draco).named_indices("attributes", most_ids)};
            primitives.push_back(std::move(primitive));
        }
        return primitives;
    }

    GltfSkin skin(const GltfFields& from) const {
        GltfSkin skin{from.indices("joints", model_.nodes.size()),
                      from.index("inverseBindMatrices", model_.accessors.size())};
        if (!skin.inverse_binds || *skin.inverse_binds >= model_.accessors.size()) return skin;
        const std::size_t matrices = model_.accessors[*skin.inverse_binds].count;
        if (matrices < skin.joints.size())
            from.complain("has " + std::to_string(skin.joints.size()) + " joints and " +
                          std::to_string(matrices) + " inverse bind matrices; it needs one for each joint");
        return skin;
    }

    /// Channels without a node and channels of morph targets are ignored.
    void read_animation(const GltfFields& from) {
        constexpr std::array<std::string_view, 4> paths{"translation", "rotation", "scale", "weights"};
        constexpr std::array<std::string_view, 3> between{"LINEAR", "STEP", "CUBICSPLINE"};
        const std::vector<GltfFields> samplers = from.objects("samplers");
        std::set<std::pair<std::size_t, std::size_t>> seen;
        for (const GltfFields& channel : from.objects("channels")) {
            const GltfFields target = channel.object("target");
            const auto node = target.index("node", model_.nodes.size());
            const std::size_t which = channel.needed_index("sampler", samplers.size());
            if (!node || which >= samplers.size()) continue;
            const std::size_t path = choice(target, "path", paths).value_or(3);
            const GltfFields& sampler = samplers[which];
            GltfTrack track;
            track.times = sampler.needed_index("input", model_.accessors.size());
            track.values = sampler.needed_index("output", model_.accessors.size());
            if (sampler.has("interpolation"))
                track.between =
                    static_cast<GltfTrack::Between>(choice(sampler, "interpolation", between).value_or(0));
            if (path == 3) continue;
            if (!seen.emplace(*node, path).second)
                channel.complain("is the second for the " + std::string(paths[path]) + " of node " +
                                 std::to_string(*node));
            track.node = *node;
            track.path = static_cast<GltfTrack::Path>(path);
            model_.animation.push_back(track);
        }
    }

    const GltfFields& file_;
    std::vector<std::optional<std::size_t>> pictures_;  // of textures
    GltfModel model_;
};

/// Complains of extensions without which the file's meshes cannot be read. Those of materials do not matter.
void check_extensions(const GltfFields& file) {
    for (const std::string& name : file.texts("extensionsRequired"))
        if (name.find("meshopt_compression") != name.npos || name.find("mesh_gpu_instancing") != name.npos ||
            (!has_draco && name.find("draco") != name.npos))
            file.complain("requires " + name + ", which cannot be read; export it without");
}

Result<GltfModel> read_model(const GltfContainer& container, const std::filesystem::path& folder) {
    const auto json = demo::parse_json<nlohmann::json>(container.json);
    if (!json)
        return Error{ErrorCode::malformed_file, "is no glTF file: it is no JSON, or is nested more than " +
                                                    std::to_string(demo::deepest_json) + " deep"};
    std::optional<Error> error;
    const GltfFields file(*json, "", error);
    const GltfFields asset = file.object("asset");
    if (!asset.text("version").starts_with("2.")) asset.must("version", "\"2.0\"");
    if (error) return *error;
    check_extensions(file);
    if (error) return *error;
    auto buffers = load_buffers(file, folder, container.binary);
    if (error) return *error;
    if (!buffers) return buffers.error();
    GltfModel model = ModelReader(file, *std::move(buffers)).read();
    if (error) return *error;
    model.pictures = load_pictures(file, folder, model);
    if (error) return *error;
    if (auto decoded = decode_draco(model); !decoded) return decoded.error();
    return model;
}

}  // namespace

std::size_t bytes_of(GltfType type) {
    return type == GltfType::i8 || type == GltfType::u8     ? 1
           : type == GltfType::i16 || type == GltfType::u16 ? 2
                                                            : 4;
}

std::optional<std::size_t> GltfPrimitive::attribute(const std::string& name) const {
    const auto found = std::ranges::find(attributes, name, &std::pair<std::string, std::size_t>::first);
    return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

Result<GltfModel> read_gltf_model(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file);
    if (!bytes) return bytes.error();
    const auto in_file = [&](const Error& error) {
        return Error{error.code, file.string() + ": " + error.message};
    };
    const auto container = open_container(*bytes);
    if (!container) return in_file(container.error());
    auto model = read_model(*container, file.parent_path());
    if (!model) return in_file(model.error());
    return model;
}

}  // namespace weft
