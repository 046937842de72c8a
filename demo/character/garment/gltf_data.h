#pragma once
// Numbers, triangles, places and motion out of a glTF file.

#include <span>
#include <string>
#include <vector>

#include "demo/character/garment/gltf_model.h"
#include "weft/mesh.h"

namespace weft::demo {

/// All numbers of an accessor, `components` an element, normalised where it says so. Error: another number of
/// components, sparse, without a view, a number that is not finite.
[[nodiscard]] Result<std::vector<double>> gltf_numbers(const GltfModel& model, std::size_t accessor,
                                                       std::size_t components);

/// Likewise whole numbers below `size`. Error: another type or number, as well.
[[nodiscard]] Result<std::vector<std::uint32_t>> gltf_indices(const GltfModel& model, std::size_t accessor,
                                                              std::size_t components, std::size_t size);

/// The triangles of a primitive with so many vertices, of the material `name`. Error: it is not of triangles,
/// or has an index of no vertex.
[[nodiscard]] Result<std::vector<Triangle>> gltf_triangles(const GltfModel& model,
                                                           const GltfPrimitive& primitive,
                                                           std::size_t vertices, const std::string& name);

/// Adds a part to a mesh. Error: a vertex farther out than cloth may be (coordinates.h); more vertices or
/// triangles than a mesh may have (mesh_limits.h), as a small file may ask for that names one accessor many
/// times.
[[nodiscard]] Result<void> add_part(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                    Mesh& to);

[[nodiscard]] std::vector<NodePlace> gltf_places(const GltfModel& model);
/// From each node's axes to the World's. Error: a node farther out than cloth may be
/// (coordinates.h), or whose scales multiply to what no float holds.
[[nodiscard]] Result<std::vector<Eigen::Affine3f>> gltf_globals(const GltfModel& model,
                                                                const std::vector<NodePlace>& places);

/// The first animation, or none. Of splines only the points that they go through count.
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

}  // namespace weft::demo
