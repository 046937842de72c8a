#include "demo/character/garment/painted_maps.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "cloth/mesh/obj/obj_lines.h"
#include "cloth/mesh/obj/words.h"

namespace weft::demo {
namespace {

constexpr float none = std::numeric_limits<float>::infinity();

/// A map with its name in files, its default, and its range as in maps.h.
struct NamedMap {
    std::string_view name;
    Map map;
    float unset, least, most;
};
constexpr std::array<NamedMap, 9> named_maps{
    {{"mass", Map::mass, 1, 0.01f, 100},
     {"pin", Map::pin, 0, 0, 1},
     {"leash", Map::leash, none, 0, none},
     {"backstop", Map::backstop, none, -10, none},
     {"backstop_radius", Map::backstop_radius, none, 1e-3f, none},
     {"friction", Map::friction, 1, 0, 1000},
     {"thickness", Map::thickness, 1, 0, 1},
     {"stiffness", Map::stiffness, 1, 1e-3f, 1000},
     {"collider_mask", Map::collider_mask, most_collider_mask, 0, most_collider_mask}}};

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
        const auto named = std::ranges::find(named_maps, name, &NamedMap::name);
        if (named == named_maps.end())
            return lines_.error("there is no map " + std::string(name.substr(0, 40)) +
                                "; there are mass, pin, leash, backstop, backstop_radius, friction, "
                                "thickness, stiffness and collider_mask");
        const std::string_view which = take_word(rest), word = take_word(rest);
        const auto value = number_of<float>(word);
        if (!value || !take_word(rest).empty())
            return lines_.error("the line must be a map, vertices and a number, as in \"leash 1-20 0.1\"");
        std::vector<float>& values =
            maps_.try_emplace(named->map, std::vector<float>(vertices_, named->unset)).first->second;
        return set(which, *value, *named, values);
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
            numbers[count++] = number_of<float>(word).value_or(none);
        const bool has_colour =
            std::isfinite(numbers[3]) && std::isfinite(numbers[4]) && std::isfinite(numbers[5]);
        if (count < 6 || !has_colour) return {};
        colours.push_back({numbers[3], numbers[4], numbers[5]});
    }
    return colours;
}

Result<void> read_maps(const std::filesystem::path& garment_file, std::size_t vertices,
                       std::span<const Vec3> colours, Garment& garment) {
    std::filesystem::path file = garment_file;
    file.replace_extension(".maps");
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

}  // namespace weft::demo
