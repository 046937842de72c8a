#include "cloth/mesh/obj/obj_parser.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "cloth/mesh/mesh_limits.h"
#include "cloth/mesh/obj/obj_lines.h"
#include "cloth/mesh/obj/triangulate.h"
#include "cloth/mesh/obj/words.h"

namespace weft {

namespace {

using Corner = ObjContent::Corner;

std::string quoted(std::string_view token) {
    constexpr std::size_t longest = 40;
    return std::string("\"").append(token.substr(0, longest)) + (token.size() > longest ? "...\"" : "\"");
}

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
/// std::from_chars, which libc++ before 20 does not have for floats: by strtod, which reads the decimal point
/// of the process's locale.
std::from_chars_result parse_double(std::string_view token, double& value) {
    const bool is_plain = token.find_first_not_of("0123456789.eE+-") == token.npos && !token.starts_with('+');
    if (!is_plain || token.empty()) return {token.data(), std::errc::invalid_argument};
    std::string text(token);
    if (const auto point = text.find('.'); point != text.npos)
        text.replace(point, 1, std::localeconv()->decimal_point);
    const std::size_t longer = text.size() - token.size();
    char* end = nullptr;
    errno = 0;
    value = std::strtod(text.c_str(), &end);
    const auto used = static_cast<std::size_t>(end - text.c_str());
    if (used == 0) return {token.data(), std::errc::invalid_argument};
    const bool is_whole = used == text.size(), is_denormal = value != 0 && std::isfinite(value);
    return {token.data() + (is_whole ? used - longer : 0),
            errno == ERANGE && !is_denormal ? std::errc::result_out_of_range : std::errc{}};
}
#else
std::from_chars_result parse_double(std::string_view token, double& value) {
    return std::from_chars(token.data(), token.data() + token.size(), value);
}
#endif

std::optional<float> parse_coordinate(std::string_view token) {
    if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
    double value = 0;
    const auto [end, code] = parse_double(token, value);
    if (code != std::errc{} || end != token.data() + token.size()) return std::nullopt;
    if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) return std::nullopt;
    return static_cast<float>(value);
}

std::optional<std::int64_t> parse_index(std::string_view token) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (code != std::errc{} || end != token.data() + token.size()) return std::nullopt;
    return value;
}

std::uint32_t to_corner_index(std::int64_t from_zero) {
    return static_cast<std::uint32_t>(std::min<std::int64_t>(from_zero, Corner::none));
}

/// Whether the outline comes to one position twice. Reorders its corners.
bool touches_itself(std::span<Vec3> outline) {
    const auto place = [](const Vec3& p) { return std::tie(p.x, p.y, p.z); };
    std::ranges::sort(outline, {}, place);
    return std::ranges::adjacent_find(outline, {}, place) != outline.end();
}

/// Checks of the elements of one kind. Indices may point forward. Each forward index that is the largest so
/// far is stored with its line: the first index out of range is one of them.
class Elements {
  public:
    Elements(const char* keyword, const char* name, std::size_t most)
        : keyword_(keyword), name_(name), most_(most) {}

    /// Call this after each line of the kind, with the number of lines so far.
    [[nodiscard]] Result<void> check_count(const ObjLines& lines, std::size_t count) const {
        if (count <= most_) return {};
        return lines.error("there are more than " + std::to_string(most_) + " \"" + keyword_ +
                           "\" lines; a mesh may have so many");
    }

    /// Converts an index counted from 1, or from -1 backwards, to one counted from 0.
    [[nodiscard]] Result<std::uint32_t> from_zero(const ObjLines& lines, std::string_view corner,
                                                  std::int64_t index, std::size_t so_far) {
        const auto available = static_cast<std::int64_t>(so_far);
        if (index == 0)
            return lines.error("corner " + quoted(corner) + " has " + name_ +
                               " index 0; they are counted from 1");
        if (index < -available)
            return lines.error("corner " + quoted(corner) + " has " + name_ + " index " +
                               std::to_string(index) + "; the file has " + std::to_string(so_far) +
                               " before this line");
        if (index < 0) return to_corner_index(available + index);
        if (index > available && (forward_.empty() || index > forward_.back().index))
            forward_.push_back({index, lines.line()});
        return to_corner_index(index - 1);
    }

    /// Call this at the end of the file, with the number of elements.
    [[nodiscard]] Result<void> check_forward(const ObjLines& lines, std::size_t total) const {
        const auto missing = std::ranges::find_if(
            forward_, [&](const Forward& f) { return f.index > static_cast<std::int64_t>(total); });
        if (missing == forward_.end()) return {};
        return lines.error_at(missing->line, std::string("a corner has ") + name_ + " index " +
                                                 std::to_string(missing->index) + "; the file has " +
                                                 std::to_string(total));
    }

  private:
    struct Forward {
        std::int64_t index;
        std::size_t line;
    };
    const char *keyword_, *name_;
    std::size_t most_;
    std::vector<Forward> forward_;
};

class Parser {
  public:
    Parser(std::istream& stream, const std::string& file, bool need_texcoords)
        : lines_(stream, file), file_(file), need_texcoords_(need_texcoords) {}

    Result<ObjContent> parse() {
        for (;;) {
            const Result<bool> more = lines_.next();
            if (!more) return more.error();
            if (!*more) break;
            if (Result<void> line = take_line(); !line) return line.error();
        }
        if (Result<void> found = vertices_.check_forward(lines_, content_.positions.size()); !found)
            return found.error();
        if (Result<void> found = texcoords_.check_forward(lines_, content_.texcoords.size()); !found)
            return found.error();
        if (content_.triangles.empty())
            return Error{ErrorCode::malformed_file, file_ +
                                                        ": no faces (lines that start with \"f\") among " +
                                                        std::to_string(content_.positions.size()) +
                                                        " vertices; a cloth needs at least one"};
        cut_larger_faces();
        return std::move(content_);
    }

  private:
    /// A face of more than three corners.
    struct LargerFace {
        std::size_t first_triangle, corners;
    };

    Result<void> take_line() {
        std::string_view rest = lines_.text();
        const std::string_view keyword = take_word(rest);
        if (keyword == "v") return take_vertex(rest);
        if (keyword == "vt") return take_texcoord(rest);
        if (keyword == "f") return take_face(rest);
        content_.ignored_lines += !keyword.empty();
        return {};
    }

    Result<void> take_vertex(std::string_view rest) {
        std::array<float, 3> p;
        if (Result<void> read = read_coordinates(rest, "v", p); !read) return read;
        content_.positions.push_back({p[0], p[1], p[2]});
        return vertices_.check_count(lines_, content_.positions.size());
    }

    Result<void> take_texcoord(std::string_view rest) {
        std::array<float, 2> p;
        if (Result<void> read = read_coordinates(rest, "vt", p); !read) return read;
        content_.texcoords.push_back({p[0], p[1]});
        return texcoords_.check_count(lines_, content_.texcoords.size());
    }

    /// Reads the coordinates that are needed. More may follow: weights and colours.
    Result<void> read_coordinates(std::string_view rest, const char* keyword, std::span<float> needed) const {
        std::size_t count = 0;
        for (std::string_view token = take_word(rest); !token.empty(); token = take_word(rest)) {
            const std::optional<float> value = parse_coordinate(token);
            if (!value)
                return lines_.error("coordinate " + std::to_string(count + 1) + " is " + quoted(token) +
                                    "; it must be a finite number");
            if (count < needed.size()) needed[count] = *value;
            ++count;
        }
        if (count < needed.size())
            return lines_.error("the line is cut short: \"" + std::string(keyword) + "\" has " +
                                std::to_string(count) + " coordinates; it needs " +
                                std::to_string(needed.size()));
        return {};
    }

    Result<void> take_face(std::string_view rest) {
        face_.clear();
        for (std::string_view token = take_word(rest); !token.empty(); token = take_word(rest)) {
            const Result<Corner> corner = read_corner(token);
            if (!corner) return corner.error();
            face_.push_back(*corner);
        }
        if (face_.size() < 3)
            return lines_.error("the face has " + std::to_string(face_.size()) +
                                " corners; it needs at least 3");
        if (content_.triangles.size() + face_.size() - 2 > most_triangles)
            return lines_.error("there are more than " + std::to_string(most_triangles) +
                                " triangles; a mesh may have so many");
        append_face();
        return {};
    }

    /// Positions may follow later. Until all are read, the triangles of a larger face hold its n corners, one
    /// after the other, in their 3 (n - 2) places.
    void append_face() {
        const std::size_t first = content_.triangles.size();
        content_.triangles.resize(first + face_.size() - 2);
        for (std::size_t i = 0; i < face_.size(); ++i) content_.triangles[first + i / 3][i % 3] = face_[i];
        if (face_.size() > 3) larger_faces_.push_back({first, face_.size()});
    }

    /// Precondition: all indices are in range.
    void cut_larger_faces() {
        std::vector<Vec3> outline;
        std::vector<Triangle> cut;
        for (const LargerFace& larger : larger_faces_) {
            face_.clear(), outline.clear();
            for (std::size_t i = 0; i < larger.corners; ++i) {
                face_.push_back(content_.triangles[larger.first_triangle + i / 3][i % 3]);
                outline.push_back(content_.positions[face_.back().position]);
            }
            content_.crossing_faces += !triangulate(outline, cut);
            content_.touching_faces += touches_itself(outline);
            for (std::size_t t = 0; t < cut.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    content_.triangles[larger.first_triangle + t][k] = face_[cut[t][k]];
        }
        content_.triangulated_faces = static_cast<std::uint32_t>(larger_faces_.size());
    }

    /// Reads "v", "v/vt", "v//vn" or "v/vt/vn". Normals are not stored, so vn is only checked to be an index.
    Result<Corner> read_corner(std::string_view corner) {
        const std::size_t slash = std::min(corner.find('/'), corner.size());
        const Result<std::uint32_t> position =
            read_index(corner, corner.substr(0, slash), vertices_, content_.positions.size());
        if (!position) return position.error();

        Corner result{*position, Corner::none};
        std::string_view rest = corner.substr(slash);
        const bool has_texcoord = !rest.empty() && !rest.starts_with("//");
        if (has_texcoord) {
            rest.remove_prefix(1);
            const std::size_t second = std::min(rest.find('/'), rest.size());
            const Result<std::uint32_t> texcoord =
                read_index(corner, rest.substr(0, second), texcoords_, content_.texcoords.size());
            if (!texcoord) return texcoord.error();
            result.texcoord = *texcoord;
            content_.has_texcoords = true;
            rest.remove_prefix(second);
        } else if (need_texcoords_) {
            return lines_.error(
                "corner " + quoted(corner) +
                " has no texture coordinate; all need one (\"vertex/texcoord\") to be the flat pattern");
        } else if (!rest.empty()) {
            rest.remove_prefix(1);
        }
        if (!rest.empty() && !parse_index(rest.substr(1))) return no_index(corner);
        return result;
    }

    Result<std::uint32_t> read_index(std::string_view corner, std::string_view token, Elements& elements,
                                     std::size_t so_far) {
        const std::optional<std::int64_t> index = parse_index(token);
        if (!index) return no_index(corner);
        return elements.from_zero(lines_, corner, *index, so_far);
    }

    [[nodiscard]] Error no_index(std::string_view corner) const {
        return lines_.error("corner " + quoted(corner) +
                            " must be vertex, vertex/texcoord, vertex//normal or vertex/texcoord/normal, "
                            "each a whole number");
    }

    ObjLines lines_;
    const std::string& file_;
    const bool need_texcoords_;
    ObjContent content_;
    Elements vertices_{"v", "vertex", most_vertices};
    Elements texcoords_{"vt", "texture coordinate", most_triangles};
    std::vector<Corner> face_;  // of the present line
    std::vector<LargerFace> larger_faces_;
};

}  // namespace

Result<ObjContent> parse_obj(std::istream& stream, const std::string& file, bool need_texcoords) {
    return Parser(stream, file, need_texcoords).parse();
}

}  // namespace weft
