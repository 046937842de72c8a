#include "demo/character/garment/painted_maps.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "cloth/mesh/obj/obj_lines.h"
#include "cloth/mesh/obj/words.h"

namespace weft::demo {
namespace {

template <class T>
std::optional<T> number_of(std::string_view word) {
    T value{};
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

class MapsReader {
  public:
    MapsReader(std::istream& stream, const std::string& file, std::size_t vertices,
               std::span<const Vec3> colours)
        : lines_(stream, file), vertices_(vertices), colours_(colours) {}

    Result<void> read() {
        for (;;) {
            const auto more = lines_.next();
            if (!more) return more.error();
            if (!*more) return {};
            if (auto line = take_line(); !line) return line;
        }
    }
    /// Values of the maps that lines name, by `v` line.
    [[nodiscard]] const std::map<Map, std::vector<float>>& maps() const { return maps_; }

  private:
    Result<void> take_line() {
        std::string_view rest = lines_.text();
        const std::string_view name = take_word(rest);
        if (name.empty()) return {};
        const auto map = std::ranges::find(named_maps, name, &NamedMap::name);
        if (map == named_maps.end())
            return lines_.error("there is no map " + std::string(name.substr(0, 40)) +
                                "; there are mass, pin, leash, backstop, backstop_radius, friction, "
                                "thickness, stiffness and collider_mask");
        const std::string_view which = take_word(rest), word = take_word(rest);
        const auto value = number_of<float>(word);
        if (!value || !take_word(rest).empty())
            return lines_.error("the line must be a map, vertices and a number, as in \"leash 1-20 0.1\"");
        std::vector<float>& values =
            maps_.try_emplace(map->map, std::vector<float>(vertices_, map->unset)).first->second;
        return set(which, *value, *map, values);
    }

    [[nodiscard]] Result<void> check(float value, const NamedMap& map) const {
        if (value >= map.least && value <= map.most) return {};
        return lines_.error(std::string(map.name) + " is " + std::to_string(value) + "; it must be from " +
                            std::to_string(map.least) + " to " + std::to_string(map.most));
    }

    Result<void> set(std::string_view which, float value, const NamedMap& map, std::vector<float>& values) {
        constexpr std::array<std::pair<std::string_view, float Vec3::*>, 3> channels{
            {{"red", &Vec3::x}, {"green", &Vec3::y}, {"blue", &Vec3::z}}};
        for (const auto& [name, channel] : channels) {
            if (which != name) continue;
            if (colours_.size() != vertices_)
                return lines_.error(
                    "the garment's vertices have no colours; give each one, or name them by "
                    "their numbers");
            for (std::size_t v = 0; v < vertices_; ++v) {
                values[v] = value * colours_[v].*channel;
                // A colour of 0 is out of some maps' range. The World refuses it, as it knows what the
                // garment is for.
                if (std::isnan(values[v])) return check(values[v], map);
            }
            return {};
        }
        if (auto fits = check(value, map); !fits) return fits;
        if (which == "all") {
            std::ranges::fill(values, value);
            return {};
        }
        const std::size_t dash = which.find('-');
        const auto first = number_of<std::size_t>(which.substr(0, dash));
        const auto last =
            dash == std::string_view::npos ? first : number_of<std::size_t>(which.substr(dash + 1));
        if (!first || !last || *first < 1 || *last < *first || *last > vertices_)
            return lines_.error("\"" + std::string(which.substr(0, 40)) +
                                "\" are no vertices; all, red, green, blue, or numbers from 1 to " +
                                std::to_string(vertices_) + " as in 12 or 12-40 are");
        std::fill(values.begin() + static_cast<std::ptrdiff_t>(*first - 1),
                  values.begin() + static_cast<std::ptrdiff_t>(*last), value);
        return {};
    }

    ObjLines lines_;
    std::size_t vertices_;
    std::span<const Vec3> colours_;
    std::map<Map, std::vector<float>> maps_;
};

/// The file's vertex that each vertex of the mesh was made of.
std::vector<std::size_t> lines_of(const Mesh& mesh, std::size_t vertices) {
    const auto key = [&](std::size_t v) {
        return std::tuple(mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z);
    };
    std::map<std::tuple<float, float, float>, std::size_t> at;
    std::vector<std::size_t> lines(mesh.positions.size());
    for (std::size_t v = 0; v < lines.size(); ++v) {
        lines[v] = v < vertices ? v : at.at(key(v));
        if (lines.size() > vertices && v < vertices) at.try_emplace(key(v), v);
    }
    return lines;
}

}  // namespace

std::vector<Vec3> read_vertex_colours(const std::filesystem::path& obj) {
    std::ifstream stream(obj, std::ios::binary);
    const std::string name = obj.string();
    ObjLines lines(stream, name);
    std::vector<Vec3> colours;
    for (auto more = lines.next(); more && *more; more = lines.next()) {
        std::string_view rest = lines.text();
        if (take_word(rest) != "v") continue;
        std::array<float, 6> numbers{};
        std::size_t count = 0;
        for (std::string_view word = take_word(rest); !word.empty() && count < 6; word = take_word(rest))
            numbers[count++] = number_of<float>(word).value_or(unlimited);
        const bool has_colour =
            std::isfinite(numbers[3]) && std::isfinite(numbers[4]) && std::isfinite(numbers[5]);
        if (count < 6 || !has_colour) return {};
        colours.push_back({numbers[3], numbers[4], numbers[5]});
    }
    return colours;
}

Result<void> read_maps(const std::filesystem::path& garment_file, std::size_t vertices,
                       std::span<const Vec3> colours, Garment& garment) {
    const std::filesystem::path file = maps_file(garment_file);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return {};
    std::ifstream stream(file, std::ios::binary);
    const std::string name = file.string();
    MapsReader reader(stream, name, vertices, colours);
    if (auto read = reader.read(); !read) return read;
    const std::vector<std::size_t> lines = lines_of(garment.mesh, vertices);
    for (const auto& [map, of_lines] : reader.maps()) {
        std::vector<float> values;
        for (const std::size_t line : lines) values.push_back(of_lines[line]);
        if (map != Map::pin) {
            garment.maps.push_back({map, std::move(values)});
            continue;
        }
        for (std::uint32_t v = 0; v < values.size(); ++v)
            if (values[v] >= 0.5f) garment.fixed.push_back(v);
        std::ranges::sort(garment.fixed);
        const auto twice = std::ranges::unique(garment.fixed);
        garment.fixed.erase(twice.begin(), twice.end());
    }
    return {};
}

namespace {

/// Lines of a map file, but for those of these maps. None: there is no file.
std::string other_lines(const std::filesystem::path& file, std::span<const PaintedMap> maps) {
    std::ifstream stream(file, std::ios::binary);
    std::string kept;
    for (std::string line; std::getline(stream, line);) {
        std::string_view rest = line;
        const std::string_view name = take_word(rest);
        const bool is_replaced = std::ranges::any_of(
            maps, [&](const PaintedMap& painted) { return named(painted.map).name == name; });
        if (!is_replaced) kept += line + "\n";
    }
    return kept;
}

/// A line for each run of vertices with one value other than the map's default, counted from 1.
void append_lines(const PaintedMap& painted, std::string& text) {
    const NamedMap& map = named(painted.map);
    const std::vector<float>& values = painted.values;
    for (std::size_t first = 0, last = 0; first < values.size(); first = last) {
        while (last < values.size() && values[last] == values[first]) ++last;
        if (values[first] == map.unset) continue;
        text.append(map.name).append(" ").append(std::to_string(first + 1));
        if (last > first + 1) text.append("-").append(std::to_string(last));
        char digits[32];
        std::snprintf(digits, sizeof digits, " %.9g\n", static_cast<double>(values[first]));
        text += digits;
    }
}

}  // namespace

std::filesystem::path maps_file(const std::filesystem::path& garment_file) {
    return std::filesystem::path(garment_file).replace_extension(".maps");
}

Result<void> write_maps(const std::filesystem::path& garment_file, std::span<const PaintedMap> maps) {
    const std::filesystem::path file = maps_file(garment_file);
    std::string text = other_lines(file, maps);
    for (const PaintedMap& painted : maps) append_lines(painted, text);
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.flush();
    if (stream) return {};
    return Error{ErrorCode::file_not_found, file.string() + " cannot be written"};
}

}  // namespace weft::demo
