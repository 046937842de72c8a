#pragma once
// Meshes, skins and motion from glTF 2.0 files, for hosts without an importer of their own: weft::gltf.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/error.h"
#include "weft/mesh.h"
#include "weft/types.h"

namespace weft {

/// A picture of a material, as it is in the file.
struct GltfPicture {
    std::string name;  ///< the file that the URI names, or the picture's own name
    /// Encoded, as PNG or JPEG by the format. Empty: its data cannot be read, or all pictures with it are
    /// more than 1 GiB.
    std::vector<unsigned char> bytes{};
};

/// A node that moves vertices of a skin.
struct GltfJoint {
    std::string name;          ///< may be empty
    std::int32_t parent = -1;  ///< nearest ancestor that is a joint, always an earlier one; -1: none
    Vec3 rest{};               ///< position in the rest pose [m]
};

/// A primitive of triangles, where its node puts it.
struct GltfPart {
    std::string material;          ///< name of its material; empty: none
    std::optional<Vec3> colour{};  ///< base colour of its material, linear RGB from 0 to 1
    /// Picture that multiplies the base colour, in GltfAsset::pictures().
    std::optional<std::size_t> picture{};
    /// Positions in the rest pose, +Y up [m], triangles, and the texture coordinates that the picture uses,
    /// else the first, where the file has some, as they are there (v runs downwards).
    Mesh mesh{};
    std::vector<Vec3> bound{};    ///< the file's own positions of a part with a skin; empty without
    std::vector<Vec3> colours{};  ///< linear RGB of each vertex; empty: none
    /// Joints that move each vertex: 4, 8, 12 or 16; 0: the part has no skin.
    std::size_t influences = 0;
    std::vector<std::uint32_t> joints{};  ///< indices into GltfAsset::joints(), `influences` a vertex
    std::vector<float> weights{};  ///< as many, at least 0; they sum to 1, or to 0 where the file has none
};

/// A primitive of triangles that is faulty, and is missing among the parts.
struct GltfLeftOut {
    std::size_t mesh = 0, primitive = 0;  ///< meshes[mesh].primitives[primitive] of the file
    std::size_t node = 0;                 ///< nodes[node] of the file, which has the mesh
    std::string material;                 ///< name of its material; empty: none
    /// The fault: names the primitive by number and material, its wrong value, and what would be right.
    Error fault{};
    /// The finite ones of the file's own positions, which tell what the primitive touches.
    std::vector<Vec3> positions{};
};

/// A transform as a matrix of four columns, one after the other, as graphics interfaces take it.
using GltfMatrix = std::array<float, 16>;

/// The parts, joints and motion of a file. Copies share the motion.
class GltfAsset {
  public:
    /// Reads .gltf and .glb, told apart by their first bytes, and the buffers that they name, 2 GiB at most:
    /// lists, strips and fans of triangles of all nodes, sparse accessors, all skins, the first animation
    /// and, if Weft was built with it, Draco's compression. Of materials it reads the base colour and its
    /// picture, untransformed. Lines, points, morph targets, cameras and other textures are ignored; scales
    /// of nodes apply, shear of matrices is ignored. Any bytes are safe to read. A primitive whose own data
    /// are faulty is left out: see left_out(). Errors name the file and the value: what cannot be read or is
    /// no glTF 2, an extension that hides the data, a value of the JSON that is of the wrong kind or out of
    /// its range, more vertices than a mesh may have, no primitive but faulty ones.
    [[nodiscard]] static Result<GltfAsset> load(const std::filesystem::path& file);
    /// Returns true if load() reads KHR_draco_mesh_compression.
    [[nodiscard]] static bool reads_draco();

    [[nodiscard]] const std::vector<GltfPart>& parts() const { return parts_; }
    /// Faulty primitives: indices of no vertex, numbers that are not finite, attributes of another length
    /// than the positions, compressed data that cannot be decoded. What is left out may be part of what is
    /// wanted: a host compares the materials' names, or refuses the file where this is not empty.
    [[nodiscard]] const std::vector<GltfLeftOut>& left_out() const { return left_out_; }
    [[nodiscard]] const std::vector<GltfJoint>& joints() const { return joints_; }
    /// The pictures of the parts' materials, whose pixels a host decodes.
    [[nodiscard]] const std::vector<GltfPicture>& pictures() const { return pictures_; }
    /// All parts as one mesh in the rest pose; it has texture coordinates where all parts have.
    [[nodiscard]] Mesh mesh() const;

    /// Length of the first animation [s]; 0 without one.
    [[nodiscard]] double duration() const;
    /// Nodes or channels of the animation, whichever are more: the time of pose() is in proportion.
    [[nodiscard]] std::size_t pose_size() const;
    /// Writes one matrix a joint, which takes points from the rest pose to the pose at `time` [s], held at
    /// both ends of the animation: a vertex comes to the sum of weight * matrix * rest position, and a
    /// joint to matrix * rest. Error: the span's size is not that of joints(); a node comes to stand beyond
    /// 10^5 m. The call allocates.
    [[nodiscard]] Result<void> pose(double time, std::span<GltfMatrix> joints) const;

  private:
    struct Motion;
    friend class GltfAssetReader;

    std::vector<GltfPart> parts_;
    std::vector<GltfLeftOut> left_out_;
    std::vector<GltfJoint> joints_;
    std::vector<GltfPicture> pictures_;
    std::shared_ptr<const Motion> motion_;
};

}  // namespace weft
