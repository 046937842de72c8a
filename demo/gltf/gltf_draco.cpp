#include "demo/gltf/gltf_draco.h"

#include <algorithm>

#include "demo/gltf/gltf_fields.h"

#ifdef WEFT_DRACO
#include <draco/compression/decode.h>

#include "cloth/mesh/mesh_limits.h"
#endif

namespace weft {
namespace {

// The limit is on all buffers together, since many primitives may name the same compressed data.
constexpr std::size_t most_decoded_bytes = std::size_t{1} << 31;

std::size_t bytes_of(const std::vector<std::vector<unsigned char>>& buffers) {
    std::size_t bytes = 0;
    for (const auto& each : buffers) bytes += each.size();
    return bytes;
}

}  // namespace

#ifdef WEFT_DRACO

const bool has_draco = true;

namespace {

/// Appends packed values as a buffer of their own. Returns the number of their accessor.
template <class T>
std::size_t append(GltfModel& model, const std::vector<T>& values, GltfType type, std::size_t components) {
    const auto* const first = reinterpret_cast<const unsigned char*>(values.data());
    model.buffers.emplace_back(first, first + values.size() * sizeof(T));
    model.views.push_back({.buffer = model.buffers.size() - 1, .bytes = values.size() * sizeof(T)});
    model.accessors.push_back({.view = model.views.size() - 1,
                               .count = values.size() / components,
                               .type = type,
                               .components = components});
    return model.accessors.size() - 1;
}

/// Values of all points. None: not of these components, or some cannot be converted.
std::optional<std::vector<float>> values_of(const draco::PointAttribute& attribute, std::size_t points,
                                            std::size_t components) {
    const bool is_whole = attribute.is_mapping_identity() || attribute.indices_map_size() >= points;
    if (!is_whole || attribute.num_components() != static_cast<int>(components)) return std::nullopt;
    std::vector<float> values(points * components);
    for (std::size_t p = 0; p < points; ++p) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(p)));
        if (index.value() >= attribute.size() ||
            !attribute.ConvertValue(index, static_cast<std::int8_t>(components), &values[p * components]))
            return std::nullopt;
    }
    return values;
}

Result<void> decode(GltfModel& model, GltfPrimitive& primitive) {
    const GltfView view = model.views[primitive.compressed->view];
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(model.buffers[view.buffer].data()) + view.offset, view.bytes);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) return gltf_error("are none of Draco's: " + decoded.status().error_msg_string());
    const draco::Mesh& mesh = *decoded.value();
    if (mesh.num_points() > most_vertices || mesh.num_faces() > most_triangles)
        return gltf_error("have more vertices or triangles than a mesh may have");
    for (const auto& [name, id] : primitive.compressed->attributes) {
        const auto to = std::ranges::find(primitive.attributes, name, [](const auto& a) { return a.first; });
        const auto* const from = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (to == primitive.attributes.end() || from == nullptr)
            return gltf_error("have no attribute " + std::to_string(id) + ", which is " + name);
        const std::size_t components = model.accessors[to->second].components;
        const auto values = values_of(*from, mesh.num_points(), components);
        if (!values)
            return gltf_error("have other components than the " + std::to_string(components) + " of " + name);
        to->second = append(model, *values, GltfType::f32, components);
    }
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f)))
            corners.push_back(corner.value());
    primitive.indices = append(model, corners, GltfType::u32, 1);
    primitive.triangles = GltfTriangles::list;
    return {};
}

}  // namespace

#else

const bool has_draco = false;

namespace {

Result<void> decode(GltfModel& model, const GltfPrimitive& primitive) {
    for (const auto& [name, accessor] : primitive.attributes)
        if (!model.accessors[accessor].view && !model.accessors[accessor].sparse)
            return gltf_error("are compressed by Draco, which this build of Weft lacks; export it without");
    return {};
}

}  // namespace

#endif

Result<void> decode_draco(GltfModel& model) {
    for (std::size_t m = 0; m < model.meshes.size(); ++m)
        for (GltfPrimitive& primitive : model.meshes[m]) {
            if (!primitive.compressed) continue;
            if (auto decoded = decode(model, primitive); !decoded)
                primitive.fault = gltf_error("its data " + decoded.error().message);
            if (bytes_of(model.buffers) > most_decoded_bytes)
                return gltf_error("meshes[" + std::to_string(m) +
                                  "] has, with those before it, more than 2 GiB of decoded data");
        }
    return {};
}

}  // namespace weft
