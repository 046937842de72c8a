#include "cloth/mesh/obj_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace weft {

namespace {

constexpr std::string_view blanks = " \t";  // tinyobj's own
constexpr double largest_float = static_cast<double>(std::numeric_limits<float>::max());

/// A statement of the file. Lines joined by a backslash are one statement, with the number of its first line.
struct Line {
    std::size_t number = 0;  ///< counted from 1
    std::string text;
};

/// Takes the next token off the front of `text`; empty at the end.
std::string_view take_token(std::string_view& text) {
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const std::string_view token = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return token;
}

/// Takes the next physical line off the front of `text`, whether it ends in LF, CR LF or CR.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    return line;
}

std::vector<Line> split_lines(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());

    std::vector<Line> lines;
    bool continues = false;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = take_line(text);
        // Before the backslash is looked at: many a comment ends in a Windows path.
        line = line.substr(0, line.find('#'));
        const bool continued = line.ends_with('\\');
        if (continued) line.remove_suffix(1);

        if (!continues) lines.push_back({number, {}});
        lines.back().text.append(line).append(continued ? " " : "");
        continues = continued;
    }
    return lines;
}

std::string quoted(std::string_view token) {
    constexpr std::size_t longest = 40;
    return std::string("\"").append(token.substr(0, longest)) + (token.size() > longest ? "...\"" : "\"");
}

std::optional<double> parse_number(std::string_view token) {
    if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (code != std::errc{} || end != token.data() + token.size()) return std::nullopt;
    return value;
}

std::optional<std::int64_t> parse_index(std::string_view token) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (code != std::errc{} || end != token.data() + token.size()) return std::nullopt;
    return value;
}

/// Checks the v, vt and f lines. Indices may point forward, so the file's totals are known beforehand;
/// negative ones count back from the line that they stand on.
class Checker {
  public:
    Checker(const std::string& file, bool need_texcoords, std::int64_t vertices, std::int64_t texcoords)
        : file_(file),
          need_texcoords_(need_texcoords),
          vertices_{"vertex", vertices},
          texcoords_{"texture coordinate", texcoords} {}

    Result<void> check(const Line& line) {
        line_ = line.number;
        std::string_view rest = line.text;
        const std::string_view keyword = take_token(rest);
        if (keyword == "v") {
            ++vertices_.so_far;
            return check_coordinates(rest, 3, "v");
        }
        if (keyword == "vt") {
            ++texcoords_.so_far;
            return check_coordinates(rest, 2, "vt");
        }
        return check_face(rest);
    }

  private:
    struct Elements {
        const char* name;
        std::int64_t total;
        std::int64_t so_far = 0;
    };

    [[nodiscard]] Error error(const std::string& message) const {
        return {ErrorCode::malformed_file, file_ + ":" + std::to_string(line_) + ": " + message};
    }

    Result<void> check_coordinates(std::string_view rest, std::size_t needed, const char* keyword) const {
        std::size_t count = 0;
        for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest)) {
            ++count;
            const std::optional<double> value = parse_number(token);
            if (!value || !(std::abs(*value) <= largest_float))
                return error("coordinate " + std::to_string(count) + " is " + quoted(token) +
                             "; it must be a finite number");
        }
        if (count < needed)
            return error("the line is cut short: \"" + std::string(keyword) + "\" has " +
                         std::to_string(count) + " coordinates; it needs " + std::to_string(needed));
        return {};
    }

    Result<void> check_face(std::string_view rest) const {
        std::size_t corners = 0;
        for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest)) {
            ++corners;
            if (Result<void> corner = check_corner(token); !corner) return corner;
        }
        if (corners < 3)
            return error("the face has " + std::to_string(corners) + " corners; it needs at least 3");
        return {};
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn". Normals are not read, so theirs need only be an index.
    Result<void> check_corner(std::string_view corner) const {
        const std::size_t slash = std::min(corner.find('/'), corner.size());
        if (Result<void> vertex = check_index(corner, corner.substr(0, slash), &vertices_); !vertex)
            return vertex;

        std::string_view rest = corner.substr(slash);
        const bool has_texcoord = !rest.empty() && !rest.starts_with("//");
        if (has_texcoord) {
            rest.remove_prefix(1);
            const std::size_t second = std::min(rest.find('/'), rest.size());
            if (Result<void> texcoord = check_index(corner, rest.substr(0, second), &texcoords_); !texcoord)
                return texcoord;
            rest.remove_prefix(second);
        } else if (need_texcoords_) {
            return error(
                "corner " + quoted(corner) +
                " has no texture coordinate; all need one (\"vertex/texcoord\") to be the flat pattern");
        } else if (!rest.empty()) {
            rest.remove_prefix(1);
        }
        if (rest.empty()) return {};
        return check_index(corner, rest.substr(1), nullptr);
    }

    Result<void> check_index(std::string_view corner, std::string_view token,
                             const Elements* elements) const {
        const std::optional<std::int64_t> index = parse_index(token);
        if (!index)
            return error("corner " + quoted(corner) +
                         " must be vertex, vertex/texcoord, vertex//normal or "
                         "vertex/texcoord/normal, each a whole number");
        if (elements == nullptr) return {};
        if (*index == 0)
            return error("corner " + quoted(corner) + " has " + elements->name +
                         " index 0; they are counted from 1");
        const std::int64_t available = *index > 0 ? elements->total : elements->so_far;
        if (*index > available || *index < -available)
            return error("corner " + quoted(corner) + " has " + elements->name + " index " +
                         std::to_string(*index) + "; the file has " + std::to_string(available) +
                         (*index > 0 ? "" : " before this line"));
        return {};
    }

    const std::string& file_;
    const bool need_texcoords_;
    Elements vertices_, texcoords_;
    std::size_t line_ = 0;
};

}  // namespace

Result<CheckedObj> check_obj(std::string_view text, const std::string& file, bool need_texcoords) {
    std::vector<Line> lines = split_lines(text);

    CheckedObj result;
    std::int64_t vertices = 0, texcoords = 0, faces = 0;
    std::erase_if(lines, [&](const Line& line) {
        std::string_view rest = line.text;
        const std::string_view keyword = take_token(rest);
        vertices += keyword == "v";
        texcoords += keyword == "vt";
        faces += keyword == "f";
        const bool needed = keyword == "v" || keyword == "vt" || keyword == "f";
        result.ignored_lines += !needed && !keyword.empty();
        return !needed;
    });

    Checker checker(file, need_texcoords, vertices, texcoords);
    for (const Line& line : lines) {
        if (Result<void> valid = checker.check(line); !valid) return valid.error();
        result.text.append(line.text).push_back('\n');
    }
    if (faces == 0)
        return Error{ErrorCode::malformed_file, file + ": no faces (lines that start with \"f\") among " +
                                                    std::to_string(vertices) +
                                                    " vertices; a cloth needs at least one"};
    return result;
}

}  // namespace weft
