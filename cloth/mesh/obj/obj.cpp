#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <exception>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "cloth/mesh/obj/obj_parser.h"
#include "cloth/mesh/topology/topology.h"
#include "engine/memory/without_exceptions.h"
#include "weft/mesh.h"

namespace weft {

namespace {

using Corner = ObjContent::Corner;

/// The largest file that is read. The largest mesh takes less.
constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 33;

/// All corners of the triangles, by positions: those of position i are [offsets[i], offsets[i + 1]) of
/// `corners`, ascending.
struct CornersByPosition {
    std::vector<std::uint32_t> offsets, corners;
};

CornersByPosition sort_by_position(const ObjContent& content) {
    CornersByPosition result;
    result.offsets.assign(content.positions.size() + 1, 0);
    result.corners.resize(3 * content.triangles.size());
    for (const auto& triangle : content.triangles)
        for (const Corner& corner : triangle) ++result.offsets[corner.position + 1];
    for (std::size_t i = 1; i < result.offsets.size(); ++i) result.offsets[i] += result.offsets[i - 1];
    std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for (std::uint32_t c = 0; c < result.corners.size(); ++c)
        result.corners[next[content.triangles[c / 3][c % 3].position]++] = c;
    return result;
}

Vec2 texcoord_of(const ObjContent& content, std::uint32_t corner) {
    const std::uint32_t texcoord = content.triangles[corner / 3][corner % 3].texcoord;
    return texcoord == Corner::none ? Vec2{} : content.texcoords[texcoord];
}

/// For each corner the first that has the same position and texture coordinate; corners are counted three to
/// a triangle.
std::vector<std::uint32_t> first_alike(const ObjContent& content) {
    CornersByPosition by_position = sort_by_position(content);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const Vec2 p = texcoord_of(content, a), q = texcoord_of(content, b);
        return std::tie(p.x, p.y, a) < std::tie(q.x, q.y, b);
    };
    std::vector<std::uint32_t> first(by_position.corners.size());
    for (std::size_t i = 0; i + 1 < by_position.offsets.size(); ++i) {
        const auto row =
            std::span(by_position.corners)
                .subspan(by_position.offsets[i], by_position.offsets[i + 1] - by_position.offsets[i]);
        std::ranges::sort(row, before);
        for (std::size_t k = 0; k < row.size(); ++k) {
            const bool same = k > 0 && [&] {
                const Vec2 p = texcoord_of(content, row[k - 1]), q = texcoord_of(content, row[k]);
                return p.x == q.x && p.y == q.y;
            }();
            first[row[k]] = same ? first[row[k - 1]] : row[k];
        }
    }
    return first;
}

/// Gives each pair of position and texture coordinate a vertex. Vertex i is the file's `v` line i, whether a
/// corner uses it or not; further texture coordinates at one position get vertices after all of these, in
/// order of use.
Mesh build_mesh(ObjContent content, bool texcoords_are_pattern) {
    const std::vector<std::uint32_t> first = first_alike(content);
    Mesh mesh;
    mesh.positions = std::move(content.positions);
    mesh.triangles.resize(content.triangles.size());
    mesh.texcoords.resize(mesh.positions.size());
    std::vector<bool> used(mesh.positions.size(), false);
    const auto new_vertex = [&](std::uint32_t corner) {
        const std::uint32_t position = content.triangles[corner / 3][corner % 3].position;
        const Vec2 texcoord = texcoord_of(content, corner);
        if (!used[position]) {
            used[position] = true;
            mesh.texcoords[position] = texcoord;
            return position;
        }
        const Vec3 copy = mesh.positions[position];
        mesh.positions.push_back(copy);
        mesh.texcoords.push_back(texcoord);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    };
    for (std::uint32_t c = 0; c < first.size(); ++c)
        mesh.triangles[c / 3][c % 3] =
            first[c] == c ? new_vertex(c) : mesh.triangles[first[c] / 3][first[c] % 3];
    if (!content.has_texcoords) mesh.texcoords.clear();
    if (texcoords_are_pattern) mesh.pattern = mesh.texcoords;
    return mesh;
}

std::string system_message() {
    return std::generic_category().message(errno);
}

Error unreadable(const std::string& file) {
    return {ErrorCode::file_not_found, file + ": cannot be read: " + system_message()};
}

Result<void> check_file(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return Error{ErrorCode::file_not_found, file.string() + ": is a directory; name an OBJ file"};
    if (!std::filesystem::is_regular_file(file, ignored)) return {};
    const std::uintmax_t bytes = std::filesystem::file_size(file, ignored);
    if (!ignored && bytes > most_bytes)
        return Error{ErrorCode::malformed_file, file.string() + ": has " + std::to_string(bytes) +
                                                    " bytes; an OBJ file may have at most " +
                                                    std::to_string(most_bytes)};
    return {};
}

Result<Mesh> load(const std::filesystem::path& file, const ObjOptions& options, ObjReport* report) {
    if (Result<void> checked = check_file(file); !checked) return checked.error();
    const std::string name = file.string();
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return unreadable(name);
    std::optional<Result<ObjContent>> read;
    // The stream's buffer may throw this where reading fails.
    ignoring<std::ios_base::failure>([&] {
        read = stream.rdbuf()->sgetc() == std::ifstream::traits_type::eof()
                   ? Error{ErrorCode::malformed_file, name + ": is empty; an OBJ file has v and f lines"}
                   : parse_obj(stream, name, options.texcoords_are_pattern);
    });
    if (!read) return unreadable(name);
    Result<ObjContent>& content = *read;
    if (!content) return content.error();
    const ObjReport noticed{content->ignored_lines, content->triangulated_faces, content->crossing_faces,
                            content->touching_faces};
    Mesh mesh = build_mesh(*std::move(content), options.texcoords_are_pattern);
    if (report != nullptr) *report = noticed;
    return mesh;
}

/// Appends a number with nine significant digits, which distinguish any two floats.
void append_number(std::string& text, float value) {
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                       std::chars_format::general, std::numeric_limits<float>::max_digits10);
    text.append(1, ' ').append(digits.data(), written.ptr);
}

void append_corner(std::string& text, std::uint32_t vertex, bool has_texcoords) {
    const std::string number = std::to_string(vertex + 1);
    text.append(1, ' ').append(number);
    if (has_texcoords) text.append(1, '/').append(number);
}

std::string obj_text(const Mesh& mesh) {
    const std::vector<Vec2>& texcoords = mesh.texcoords.empty() ? mesh.pattern : mesh.texcoords;
    std::string text;
    for (const Vec3& p : mesh.positions) {
        text += 'v';
        for (const float coordinate : {p.x, p.y, p.z}) append_number(text, coordinate);
        text += '\n';
    }
    for (const Vec2& p : texcoords) {
        text += "vt";
        for (const float coordinate : {p.x, p.y}) append_number(text, coordinate);
        text += '\n';
    }
    for (const Triangle& triangle : mesh.triangles) {
        text += 'f';
        for (const std::uint32_t vertex : triangle) append_corner(text, vertex, !texcoords.empty());
        text += '\n';
    }
    return text;
}

Result<void> save(const std::filesystem::path& file, const Mesh& mesh) {
    if (Result<void> valid = check_mesh(mesh); !valid) return valid;
    const std::string text = obj_text(mesh);
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    ignoring<std::ios_base::failure>([&] {
        // By default a stream swallows std::bad_alloc.
        if constexpr (has_exceptions) stream.exceptions(std::ios_base::badbit);
        stream << text << std::flush;
    });
    if (!stream)
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be written: " + system_message() +
                                                    "; name a file in a folder that exists"};
    return {};
}

}  // namespace

Result<Mesh> load_obj(const std::filesystem::path& file, const ObjOptions& options, ObjReport* report) {
    return without_exceptions([&] { return load(file, options, report); });
}

Result<void> save_obj(const std::filesystem::path& file, const Mesh& mesh) {
    return without_exceptions([&] { return save(file, mesh); });
}

}  // namespace weft
