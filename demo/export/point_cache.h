#pragma once
// Sequences of a mesh's positions in one file, in the format PC2, which Blender's Mesh Cache modifier and
// others read.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

#include "weft/error.h"
#include "weft/types.h"

namespace weft::demo {

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

}  // namespace weft::demo
