#pragma once
// A scene's cloths in all frames, as files for other programs.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>

#include "demo/export/usd_text.h"
#include "demo/scene_simulation.h"
#include "weft/error.h"
#include "weft/types.h"
#include "weft/world.h"

namespace weft::demo {

/// Positions of a mesh in the format PC2, which Blender's Mesh Cache modifier and others read.
/// Little-endian: "POINTCACHE2" and a zero, version 1, number of points, first frame, frames per sample,
/// number of samples; then each sample's points as three floats.
class PointCache {
  public:
    /// Error: the file cannot be written; more than 2^31 - 1 points.
    [[nodiscard]] static Result<PointCache> create(const std::filesystem::path& file, std::size_t points);

    /// Appends a sample. Error: the number of points is not create()'s; the file cannot be written.
    [[nodiscard]] Result<void> add(std::span<const Vec3> points);
    /// Writes the number of samples into the file's header. Error: the file cannot be written.
    [[nodiscard]] Result<void> close();

  private:
    PointCache(std::filesystem::path file, std::ofstream stream, std::size_t points);
    [[nodiscard]] Result<void> written() const;

    std::filesystem::path file_;
    std::ofstream stream_;
    std::size_t points_ = 0;
    std::int32_t samples_ = 0;
};

/// A scene's cloths in all frames, as files for other programs.
enum class SequenceFormat : std::uint8_t {
    obj,  ///< frame_000000.obj and so on
    usd,  ///< sequence.usda: one mesh with all frames, normals and a material
    pc2,  ///< sequence.obj, the first frame, and sequence.pc2, the positions of its vertices in all frames
};

/// Writes all cloths of a scene as one mesh, +Y up, in metres, with the vertices in the order of the scene's
/// meshes, split at seams as these are.
class Sequence {
  public:
    /// Begins with the present state as frame 0. Error: a file in the folder cannot be written.
    [[nodiscard]] static Result<Sequence> begin(const Simulation& simulation, SequenceFormat format,
                                                const std::filesystem::path& folder);
    /// Appends the next frame.
    [[nodiscard]] Result<void> add(const Simulation& simulation);
    [[nodiscard]] Result<void> end();

  private:
    Sequence(SequenceFormat format, std::filesystem::path folder)
        : format_(format), folder_(std::move(folder)) {}
    [[nodiscard]] Result<void> write(const Mesh& mesh);

    SequenceFormat format_;
    std::filesystem::path folder_;
    std::optional<PointCache> cache_;
    std::optional<UsdText> usd_;
    int frame_ = 0;
};

}  // namespace weft::demo
