#pragma once
// Numbers and nodes out of a parsed glTF file, with every range checked.

#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "engine/vector.h"
#include "weft/error.h"

namespace weft::demo {

/// All numbers of an accessor, `components` an element, normalised where it says so. Error: another number of
/// components, sparse, or beyond its buffer.
[[nodiscard]] Result<std::vector<double>> gltf_numbers(const tinygltf::Model& model, int accessor,
                                                       int components);

/// A node's own place: translation, rotation, scale.
struct NodePlace {
    Vector3 translation = Vector3::Zero();
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
    Vector3 scale = Vector3::Ones();
};

[[nodiscard]] std::vector<NodePlace> gltf_places(const tinygltf::Model& model);
/// Of each node; -1: it has none.
[[nodiscard]] std::vector<int> gltf_parents(const tinygltf::Model& model);
/// From each node's axes to the World's. Precondition: parents lead to nodes without one.
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
