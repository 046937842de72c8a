#pragma once
// Numbers and nodes out of a parsed glTF file, with every range checked.

#include <filesystem>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "engine/vector.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft::demo {

/// Pictures in it are not read. Errors name the file: it cannot be read, or is no glTF file.
[[nodiscard]] Result<tinygltf::Model> load_gltf(const std::filesystem::path& file);

/// All numbers of an accessor, `components` an element, normalised where it says so. Error: another number of
/// components, sparse, or beyond its buffer.
[[nodiscard]] Result<std::vector<double>> gltf_numbers(const tinygltf::Model& model, int accessor,
                                                       int components);

/// Of a primitive with so many vertices, of the material `name`. Error: it is not of triangles, or has an
/// index of no vertex.
[[nodiscard]] Result<std::vector<Triangle>> gltf_triangles(const tinygltf::Model& model,
                                                           const tinygltf::Primitive& primitive,
                                                           std::size_t vertices, const std::string& name);

/// A node's own place: translation, rotation, scale.
struct NodePlace {
    Vector3 translation = Vector3::Zero();
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
    Vector3 scale = Vector3::Ones();
};

[[nodiscard]] std::vector<NodePlace> gltf_places(const tinygltf::Model& model);
/// Of each node; -1: it has none. Error: a node that is its own ancestor.
[[nodiscard]] Result<std::vector<int>> gltf_parents(const tinygltf::Model& model);
/// From each node's axes to the World's, by gltf_parents().
[[nodiscard]] std::vector<Eigen::Affine3f> gltf_globals(const std::vector<NodePlace>& places,
                                                        const std::vector<int>& parents);

/// The first animation, or none. Of splines only the points that they go through count.
class GltfAnimation {
  public:
    /// Error: times or values that are not what the format asks for.
    [[nodiscard]] static Result<GltfAnimation> create(const tinygltf::Model& model);
    [[nodiscard]] double duration() const { return duration_; }  ///< [s]
    void pose(double time, std::vector<NodePlace>& places) const;

  private:
    struct Track {
        std::size_t node;
        char kind;  // of the path: t, r or s
        bool steps;
        std::vector<double> times, values;
        std::size_t components;
    };
    std::vector<Track> tracks_;
    double duration_ = 0;
};

}  // namespace weft::demo
