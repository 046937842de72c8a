#include "tests/fuzz/readers/reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace weft::fuzz {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    must(stream.good(), file.string() + " cannot be written");
}

void check_error(const Error& error, const std::string& file_name) {
    constexpr std::size_t longest = 800;
    must(error.message.size() > file_name.size() && error.message.size() <= longest,
         "a refusal of " + std::to_string(error.message.size()) +
             " characters: " + error.message.substr(0, longest));
    must(error.message.find(file_name) != std::string::npos,
         "a refusal that names no file: " + error.message);
}

void check_mesh(const Mesh& mesh, const std::string& of) {
    for (const Vec3& p : mesh.positions)
        must(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
             of + " has a position that is not finite");
    for (const Vec2& p : mesh.texcoords)
        must(std::isfinite(p.x) && std::isfinite(p.y), of + " has a texture coordinate that is not finite");
    must(!mesh.triangles.empty(), of + " has no triangles");
    for (const Triangle& t : mesh.triangles)
        must(std::ranges::max(t) < mesh.positions.size(),
             of + " has a triangle of a vertex that is not there");
    for (const std::size_t count : {mesh.texcoords.size(), mesh.pattern.size()})
        must(count == 0 || count == mesh.positions.size(), of + " has coordinates for some of its vertices");
}

void check_finite(std::span<const Vec4> values, const std::string& of) {
    for (const Vec4& v : values)
        must(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w),
             of + " is not finite");
}

Mesh tube(std::uint32_t columns, std::uint32_t rows) {
    Mesh mesh;
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const float u = static_cast<float>(c) / static_cast<float>(columns),
                        angle = 2 * std::numbers::pi_v<float> * u;
            const float v = static_cast<float>(r) / static_cast<float>(rows - 1);
            mesh.positions.push_back({0.2f * std::cos(angle), 0.2f * std::sin(angle), 0.5f + 0.5f * v});
            mesh.texcoords.push_back({u, v});
        }
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
            mesh.triangles.push_back({a, b, b + columns});
            mesh.triangles.push_back({a, b + columns, a + columns});
        }
    return mesh;
}

}  // namespace weft::fuzz
