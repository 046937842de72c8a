#pragma once
// A scene's cloths in all frames, as files for other programs.

#include <optional>

#include "demo/export/point_cache.h"
#include "demo/export/usd_text.h"
#include "demo/scene_simulation.h"

namespace weft::demo {

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
