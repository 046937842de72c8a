#pragma once
// The parts of a glTF 2.0 file that a character or a garment is made of. Every index leads to something, and
// every range lies within its buffer.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/vector.h"
#include "weft/error.h"
#include "weft/gltf.h"

namespace weft {

/// The format's numbers for types of components.
enum class GltfType : std::uint16_t { i8 = 5120, u8, i16, u16, u32 = 5125, f32 };

struct GltfView {
    std::size_t buffer = 0, offset = 0, bytes = 0;
    std::size_t stride = 0;  ///< [bytes]; 0: elements are packed
};

/// Elements of an accessor that differ from those of its view, or from 0 without a view.
struct GltfSparse {
    std::size_t count = 0;
    std::size_t index_view = 0, index_offset = 0;  ///< of the elements' indices, packed
    GltfType index_type = GltfType::u32;
    std::size_t value_view = 0, value_offset = 0;  ///< of the elements, packed
};

[[nodiscard]] std::size_t bytes_of(GltfType type);

struct GltfAccessor {
    std::optional<std::size_t> view{};  ///< none: its values are elsewhere, by an extension, or 0
    std::size_t offset = 0;             ///< in the view [bytes]
    std::size_t count = 0;              ///< elements
    GltfType type = GltfType::f32;
    std::size_t components = 1;  ///< of an element, 1 to 16
    bool normalised = false;
    std::optional<GltfSparse> sparse{};
};

/// A node's local transform: scale, then rotation, then translation.
struct NodePlace {
    Vector3 translation = Vector3::Zero();
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
    Vector3 scale = Vector3::Ones();
};

struct GltfNode {
    std::string name;
    NodePlace place;
    std::optional<std::size_t> parent, mesh, skin;
};

/// How corners follow one another; the format's numbers.
enum class GltfTriangles : std::uint8_t { list = 4, strip, fan };

/// Data compressed by Draco.
struct GltfCompressed {
    std::size_t view = 0;
    std::vector<std::pair<std::string, std::size_t>> attributes;  ///< names and Draco's unique ids
};

struct GltfPrimitive {
    std::vector<std::pair<std::string, std::size_t>> attributes;  ///< names and accessors
    std::optional<std::size_t> indices, material;
    std::optional<GltfTriangles> triangles;  ///< none: points or lines
    std::optional<GltfCompressed> compressed;
    std::optional<Error> fault;  ///< compressed data could not be decoded: the attributes have no numbers

    [[nodiscard]] std::optional<std::size_t> attribute(const std::string& name) const;
};

struct GltfMaterial {
    std::string name;
    std::optional<Vec3> colour;          ///< linear RGB, 0 to 1
    std::optional<std::size_t> picture;  ///< of the base colour, in GltfModel::pictures
    std::size_t texcoords = 0;           ///< set of coordinates that the picture uses: TEXCOORD_0 ...
};

struct GltfSkin {
    std::vector<std::size_t> joints;           ///< nodes, all different
    std::optional<std::size_t> inverse_binds;  ///< accessor
};

struct GltfTrack {
    enum class Path : std::uint8_t { translation, rotation, scale };
    enum class Between : std::uint8_t { linear, step, spline };
    std::size_t node = 0;
    Path path = Path::translation;
    Between between = Between::linear;
    std::size_t times = 0, values = 0;  ///< accessors
};

struct GltfModel {
    std::vector<std::vector<unsigned char>> buffers;
    std::vector<GltfView> views;
    std::vector<GltfAccessor> accessors;
    std::vector<GltfNode> nodes;
    std::vector<std::size_t> parents_first;  ///< all nodes, each after its parent
    std::vector<std::vector<GltfPrimitive>> meshes;
    std::vector<GltfMaterial> materials;
    std::vector<GltfPicture> pictures;
    std::vector<GltfSkin> skins;
    std::vector<GltfTrack> animation;  ///< tracks of the first one, at most one for each node and path
};

/// Reads .gltf and .glb, told apart by their first bytes, and the buffers and pictures that they name.
/// Cameras and lights are ignored. Errors name the file and the value: what cannot be read or is no glTF 2, a
/// value of the wrong kind or out of its range, an index that leads nowhere, a range beyond its buffer, a
/// node that has two parents or is its own ancestor.
[[nodiscard]] Result<GltfModel> read_gltf_model(const std::filesystem::path& file);

}  // namespace weft
