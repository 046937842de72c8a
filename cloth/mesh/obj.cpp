#include <array>
#include <cerrno>
#include <charconv>
#include <exception>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <tiny_obj_loader.h>

#include "cloth/mesh/obj_lines.h"
#include "cloth/mesh/topology.h"
#include "engine/error_text.h"
#include "weft/mesh.h"

namespace weft {

namespace {

constexpr std::uint32_t none = ~0u;

/// The file's own arrays, with indices counted from 0.
struct Content {
    struct Corner {
        std::uint32_t position;
        std::uint32_t texcoord;  ///< or `none`
    };

    std::vector<Vec3> positions;
    std::vector<Vec2> texcoords;
    std::vector<std::array<Corner, 3>> triangles;
    std::uint32_t triangulated_faces = 0;
    bool has_texcoords = false;  ///< on any corner
};

/// OBJ counts from 1, or from -1 backwards; 0 stands for no index. Precondition: check_obj found the index in
/// range.
std::uint32_t from_zero(int index, std::size_t so_far) {
    if (index == 0) return none;
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : static_cast<std::int64_t>(so_far) + index);
}

void append_face(Content& content, std::span<const tinyobj::index_t> face) {
    const auto corner = [&](const tinyobj::index_t& index) {
        const Content::Corner result{from_zero(index.vertex_index, content.positions.size()),
                                     from_zero(index.texcoord_index, content.texcoords.size())};
        content.has_texcoords |= result.texcoord != none;
        return result;
    };
    for (std::size_t i = 2; i < face.size(); ++i)
        content.triangles.push_back({corner(face[0]), corner(face[i - 1]), corner(face[i])});
    content.triangulated_faces += face.size() > 3;
}

/// tinyobj scales digits by powers of ten that leave a double's range before the number itself does: "0e999".
Result<void> check_scaled(const Content& content, const std::string& file) {
    const auto overflow = [&](const char* keyword, std::size_t index) {
        return Error{ErrorCode::malformed_file,
                     file + ": \"" + keyword + "\" line " + std::to_string(index + 1) +
                         " of its kind has an exponent that cannot be read; write the "
                         "number without it"};
    };
    for (std::size_t i = 0; i < content.positions.size(); ++i)
        if (!is_finite(content.positions[i])) return overflow("v", i);
    for (std::size_t i = 0; i < content.texcoords.size(); ++i)
        if (!is_finite({content.texcoords[i].x, content.texcoords[i].y, 0})) return overflow("vt", i);
    return {};
}

Result<Content> parse(std::string text, const std::string& file) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* user, float x, float y, float z, float) {
        static_cast<Content*>(user)->positions.push_back({x, y, z});
    };
    callbacks.texcoord_cb = [](void* user, float x, float y, float) {
        static_cast<Content*>(user)->texcoords.push_back({x, y});
    };
    callbacks.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
        append_face(*static_cast<Content*>(user), {corners, static_cast<std::size_t>(count)});
    };

    Content content;
    std::istringstream stream(std::move(text));
    std::string problem;
    if (!tinyobj::LoadObjWithCallback(stream, callbacks, &content, nullptr, nullptr, &problem))
        return Error{ErrorCode::malformed_file, file + ": " + problem};
    if (Result<void> scaled = check_scaled(content, file); !scaled) return scaled.error();
    return content;
}

/// Gives each pair of position and texture coordinate a vertex. Vertex i is the file's `v` line i, whether a
/// corner uses it or not; further texture coordinates at one position get vertices after all of these, in
/// order of use.
class VertexSplitter {
  public:
    VertexSplitter(std::span<const Vec2> texcoords, Mesh& mesh)
        : source_(texcoords),
          mesh_(mesh),
          used_(mesh.positions.size(), false),
          next_(mesh.positions.size(), none) {
        mesh.texcoords.resize(mesh.positions.size());
    }

    std::uint32_t vertex_of(const Content::Corner& corner) {
        const Vec2 texcoord = corner.texcoord == none ? Vec2{} : source_[corner.texcoord];
        std::uint32_t vertex = corner.position;
        if (!used_[vertex]) {
            used_[vertex] = true;
            mesh_.texcoords[vertex] = texcoord;
            return vertex;
        }
        while (mesh_.texcoords[vertex].x != texcoord.x || mesh_.texcoords[vertex].y != texcoord.y) {
            if (next_[vertex] == none) next_[vertex] = append(corner.position, texcoord);
            vertex = next_[vertex];
        }
        return vertex;
    }

  private:
    std::uint32_t append(std::uint32_t position, const Vec2& texcoord) {
        const Vec3 copy = mesh_.positions[position];
        mesh_.positions.push_back(copy);
        mesh_.texcoords.push_back(texcoord);
        next_.push_back(none);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    std::span<const Vec2> source_;
    Mesh& mesh_;
    std::vector<bool> used_;           // of the file's vertices: by a corner so far
    std::vector<std::uint32_t> next_;  // of all vertices: the next one at the same position, or `none`
};

Mesh build_mesh(Content content, bool texcoords_are_pattern) {
    Mesh mesh;
    mesh.positions = std::move(content.positions);
    mesh.triangles.reserve(content.triangles.size());
    VertexSplitter splitter(content.texcoords, mesh);
    for (const auto& [a, b, c] : content.triangles) {
        const std::uint32_t first = splitter.vertex_of(a), second = splitter.vertex_of(b);
        mesh.triangles.push_back({first, second, splitter.vertex_of(c)});
    }
    if (!content.has_texcoords) mesh.texcoords.clear();
    if (texcoords_are_pattern) mesh.pattern = mesh.texcoords;
    return mesh;
}

std::string system_message() {
    return std::generic_category().message(errno);
}

Result<std::string> read_text(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return Error{ErrorCode::file_not_found, file.string() + ": is a directory; name an OBJ file"};
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    if (stream) content << stream.rdbuf();
    if (!stream.is_open() || stream.bad())
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be read: " + system_message()};
    std::string text = std::move(content).str();
    if (text.empty())
        return Error{ErrorCode::malformed_file, file.string() + ": is empty; an OBJ file has v and f lines"};
    return text;
}

Result<Mesh> load(const std::filesystem::path& file, const ObjOptions& options, ObjReport* report) {
    const Result<std::string> text = read_text(file);
    if (!text) return text.error();
    Result<CheckedObj> checked = check_obj(*text, file.string(), options.texcoords_are_pattern);
    if (!checked) return checked.error();
    Result<Content> content = parse(std::move(checked->text), file.string());
    if (!content) return content.error();
    if (report != nullptr) *report = {checked->ignored_lines, content->triangulated_faces};
    return build_mesh(std::move(*content), options.texcoords_are_pattern);
}

/// Nine significant digits tell any two floats apart.
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
    stream << text << std::flush;
    if (!stream)
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be written: " + system_message() +
                                                    "; name a file in a folder that exists"};
    return {};
}

/// Runs `act`, and turns what the standard library throws into an error.
template <class Action>
auto without_exceptions(const std::filesystem::path& file, const Action& act) -> decltype(act()) {
    try {
        return act();
    } catch (const std::exception&) {
        return Error{ErrorCode::out_of_memory, file.string() + ": out of memory"};
    }
}

}  // namespace

Result<Mesh> load_obj(const std::filesystem::path& file, const ObjOptions& options, ObjReport* report) {
    return without_exceptions(file, [&] { return load(file, options, report); });
}

Result<void> save_obj(const std::filesystem::path& file, const Mesh& mesh) {
    return without_exceptions(file, [&] { return save(file, mesh); });
}

}  // namespace weft
