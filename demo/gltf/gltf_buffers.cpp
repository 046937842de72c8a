#include "demo/gltf/gltf_buffers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <utility>

#include "cloth/mesh/mesh_limits.h"
#include "demo/gltf/gltf_fields.h"

#ifdef WEFT_DRACO
#include <draco/compression/decode.h>
#endif

namespace weft {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 31;
static_assert(std::endian::native == std::endian::little, "glTF files are little-endian");

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

/// The value of a base64 digit; 64: it is none.
constexpr std::array<unsigned char, 256> base64_digits = [] {
    std::array<unsigned char, 256> values{};
    values.fill(64);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char>(digits[i])] = static_cast<unsigned char>(i);
    return values;
}();

/// Decodes base64 (RFC 4648); none for text that is not base64.
std::optional<GltfBytes> decode_base64(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    GltfBytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int waiting = 0;
    for (const char c : text) {
        const std::uint32_t digit = base64_digits[static_cast<unsigned char>(c)];
        if (digit == 64) return std::nullopt;
        bits = bits << 6 | digit;
        waiting += 6;
        if (waiting < 8) continue;
        waiting -= 8;
        bytes.push_back(static_cast<unsigned char>(bits >> waiting));
    }
    return bytes;
}

/// Decodes escapes such as "%20"; other percent signs stand for themselves.
std::string decode_percent(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* const from = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(from, from + 2, byte, 16).ptr == from + 2) {
            decoded += static_cast<char>(byte);
            i += 2;
        } else {
            decoded += uri[i];
        }
    }
    return decoded;
}

Result<GltfBytes> read_uri(const std::string& uri, const std::filesystem::path& folder) {
    if (!uri.starts_with("data:")) return read_bytes(folder / decode_percent(uri));
    constexpr std::string_view encoding = ";base64,";
    const std::size_t begin = uri.find(encoding);
    auto bytes = begin == uri.npos ? std::nullopt
                                   : decode_base64(std::string_view(uri).substr(begin + encoding.size()));
    if (!bytes) return gltf_error("\"" + uri.substr(0, 40) + "...\" is no data in base64");
    return *std::move(bytes);
}

Result<GltfBytes> load_buffer(const GltfFields& buffer, bool is_first, const std::filesystem::path& folder,
                              std::optional<std::string_view> binary) {
    const std::string uri = buffer.text("uri");
    if (!uri.empty()) return read_uri(uri, folder);
    if (is_first && binary) return GltfBytes(binary->begin(), binary->end());
    return gltf_error("there is no uri, and no binary chunk that it could be");
}

}  // namespace

Result<GltfBytes> read_bytes(const std::filesystem::path& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed))
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be read; name a file"};
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    if (failed || size > most_bytes)
        return gltf_error(file.string() + ": has more than " + std::to_string(most_bytes) + " bytes");
    GltfBytes bytes(static_cast<std::size_t>(size));
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream) return Error{ErrorCode::file_not_found, file.string() + ": cannot be read"};
    return bytes;
}

Result<GltfContainer> open_container(const GltfBytes& bytes) {
    constexpr std::size_t head = 12, chunk_head = 8;
    constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!rest.starts_with("glTF")) return GltfContainer{rest, {}};
    if (rest.size() < head) return gltf_error("is cut off within its first 12 bytes");
    if (const std::uint32_t version = word_at(rest, 4); version != 2)
        return gltf_error("is of version " + std::to_string(version) + " of GLB; it must be of 2");
    if (const std::uint32_t length = word_at(rest, 8); length > rest.size())
        return gltf_error("has " + std::to_string(rest.size()) + " bytes of the " + std::to_string(length) +
                          " that it says");
    rest = rest.substr(0, word_at(rest, 8));
    rest.remove_prefix(std::min(head, rest.size()));
    GltfContainer found;
    for (bool is_first = true; rest.size() >= chunk_head; is_first = false) {
        const std::uint32_t length = word_at(rest, 0), kind = word_at(rest, 4);
        rest.remove_prefix(chunk_head);
        if (length > rest.size())
            return gltf_error("has a chunk of " + std::to_string(length) + " bytes where " +
                              std::to_string(rest.size()) + " are left");
        if (is_first && kind != json_chunk) return gltf_error("begins with another chunk than JSON");
        if (is_first) found.json = rest.substr(0, length);
        if (!is_first && kind == binary_chunk && !found.binary) found.binary = rest.substr(0, length);
        rest.remove_prefix(length);
    }
    return found;
}

Result<std::vector<GltfBytes>> load_buffers(const GltfFields& file, const std::filesystem::path& folder,
                                            std::optional<std::string_view> binary) {
    std::vector<GltfBytes> buffers;
    std::size_t all = 0;
    for (const GltfFields& buffer : file.objects("buffers")) {
        const std::string name = "buffers[" + std::to_string(buffers.size()) + "]";
        const std::size_t length = buffer.whole("byteLength", 0, most_bytes);
        auto bytes = load_buffer(buffer, buffers.empty(), folder, binary);
        if (!bytes) return Error{bytes.error().code, name + ": " + bytes.error().message};
        if (bytes->size() < length)
            return gltf_error(name + ".byteLength is " + std::to_string(length) + "; there are " +
                              std::to_string(bytes->size()) + " bytes");
        bytes->resize(length);
        all += length;
        if (all > most_bytes) return gltf_error(name + ": with it, buffers have more than 2 GiB");
        buffers.push_back(*std::move(bytes));
    }
    return buffers;
}

std::vector<GltfPicture> load_pictures(const GltfFields& file, const std::filesystem::path& folder,
                                       const GltfModel& model) {
    // Many pictures of a small file may name the same bytes.
    constexpr std::size_t most_picture_bytes = std::size_t{1} << 30;
    std::vector<GltfPicture> pictures;
    std::size_t all = 0;
    for (const GltfFields& image : file.objects("images")) {
        GltfPicture picture{.name = image.text("name")};
        const std::string uri = image.text("uri");
        const auto view = image.index("bufferView", model.views.size());
        if (!uri.empty()) {
            auto bytes = read_uri(uri, folder);
            if (bytes) picture.bytes = *std::move(bytes);
            if (!uri.starts_with("data:")) picture.name = decode_percent(uri);
        } else if (view && *view < model.views.size() &&
                   model.views[*view].bytes <= most_picture_bytes - all) {
            const GltfView& of = model.views[*view];
            const unsigned char* const first = model.buffers[of.buffer].data() + of.offset;
            picture.bytes.assign(first, first + of.bytes);
        }
        if (picture.bytes.size() > most_picture_bytes - all) picture.bytes = {};
        all += picture.bytes.size();
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

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
