#pragma once
// Numbers, triangles, transforms and motion from a glTF model.

#include <span>
#include <string>
#include <vector>

#include "demo/gltf/gltf_model.h"
#include "weft/mesh.h"

namespace weft {

/// All numbers of an accessor, `components` an element, normalised where the accessor says so. Error: another
/// number of components, an accessor with neither a view nor sparse elements, sparse elements out of order or
/// range, a number that is not finite.
[[nodiscard]] Result<std::vector<double>> gltf_numbers(const GltfModel& model, std::size_t accessor,
                                                       std::size_t components);

/// All numbers of an accessor as indices below `size`. Error: as above, or a number that is no such index.
[[nodiscard]] Result<std::vector<std::uint32_t>> gltf_indices(const GltfModel& model, std::size_t accessor,
                                                              std::size_t components, std::size_t size);

/// The triangles of a primitive with `vertices` vertices, all wound alike. Those of strips and fans that have
/// two equal corners are left out: they only join strips. Error: the primitive is not of triangles, or has an
/// index of no vertex.
[[nodiscard]] Result<std::vector<Triangle>> gltf_triangles(const GltfModel& model,
                                                           const GltfPrimitive& primitive,
                                                           std::size_t vertices);

/// Vertices and triangles of all parts so far.
struct GltfSize {
    std::size_t vertices = 0, triangles = 0;
};

/// Adds a part's size, and refuses one by which all are larger than a mesh may be (mesh_limits.h), which a
/// small file can ask for by naming one accessor many times.
[[nodiscard]] Result<void> count_part(std::size_t vertices, std::size_t triangles, GltfSize& all);

/// Error: a vertex farther out than cloth may be (coordinates.h).
[[nodiscard]] Result<void> check_places(std::span<const Vec3> positions);

/// The finite positions of a faulty primitive; none where they cannot be read.
[[nodiscard]] std::vector<Vec3> finite_positions(const GltfModel& model, const GltfPrimitive& primitive);

[[nodiscard]] std::vector<NodePlace> gltf_places(const GltfModel& model);
/// Transforms from each node's axes to the World's. Error: a node farther out than cloth may be
/// (coordinates.h), or whose product of scales no float can hold.
[[nodiscard]] Result<std::vector<Eigen::Affine3f>> gltf_globals(const GltfModel& model,
                                                                const std::vector<NodePlace>& places);

/// The file's first animation, or an empty one. Splines are replaced by lines between their key values.
class GltfAnimation {
  public:
    /// Error: times or values that are not what the format asks for, or more than 2^26 of them.
    [[nodiscard]] static Result<GltfAnimation> create(const GltfModel& model);
    [[nodiscard]] double duration() const { return duration_; }  ///< [s]
    void pose(double time, std::vector<NodePlace>& places) const;

  private:
    struct Track {
        std::size_t node;
        GltfTrack::Path path;
        bool steps;
        std::vector<double> times, values;
        std::size_t components;
    };
    [[nodiscard]] static Result<Track> read_track(const GltfModel& model, const GltfTrack& from);

    std::vector<Track> tracks_;
    double duration_ = 0;
};

}  // namespace weft
