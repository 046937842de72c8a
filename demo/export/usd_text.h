#pragma once
// Sequences of a mesh in one text file of Universal Scene Description (.usda), as Blender, Houdini, Maya,
// Unreal and usdview read it.

#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "weft/error.h"
#include "weft/mesh.h"

namespace weft::demo {

/// A file of one mesh, +Y up, in metres, and its material. Points and normals have a time sample for each
/// frame.
/// Numbers have nine digits, by which floats read back the same.
class UsdText {
  public:
    /// Writes what does not change. Texture coordinates are written if the mesh has some. `colour` is linear
    /// RGB, `roughness` from 0 to 1, `rate` in frames a second. Error: the file cannot be written.
    [[nodiscard]] static Result<UsdText> create(const std::filesystem::path& file, const Mesh& mesh,
                                                const Vec3& colour, float roughness, double rate);

    /// Appends a frame. Error: the number of points is not create()'s; the file cannot be written.
    [[nodiscard]] Result<void> add(std::span<const Vec3> points);
    /// Appends the normals and the number of frames. Error: the file cannot be written.
    [[nodiscard]] Result<void> close();

  private:
    UsdText(const std::filesystem::path& file, const Mesh& mesh);
    void write_head(const Mesh& mesh, const Vec3& colour, float roughness, double rate);
    [[nodiscard]] std::filesystem::path normals_file() const { return file_.string() + ".normals"; }
    [[nodiscard]] Result<void> written() const;

    std::filesystem::path file_;
    std::ofstream stream_;
    std::fstream normals_;  // the other time samples, which the file has after all points
    std::vector<Triangle> triangles_;
    std::size_t points_ = 0;
    std::streamoff end_at_ = 0;  // of the last frame's number in the file [bytes]
    int frames_ = 0;
};

}  // namespace weft::demo
