#include "demo/look/settings_values.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "demo/json_text.h"
#include "demo/options/method_table.h"
#include "demo/self_collision.h"

namespace weft::demo {
namespace {

using Json = nlohmann::ordered_json;

using Read = SettingsValues;

Error malformed(const std::filesystem::path& file, const std::string& what) {
    return {ErrorCode::malformed_file, file.string() + ": " + what};
}

Result<Json> parse(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        return Error{ErrorCode::file_not_found,
                     file.string() + " cannot be read; it must be a JSON file of settings"};
    auto json = parse_json<Json>(stream);
    if (!json || !json->is_object()) return malformed(file, "is no JSON object of settings");
    return *std::move(json);
}

std::string words_of(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", number);
    return text.data();
}

/// A number of a struct, under a key. The ranges are those that the library takes.
struct Number {
    const char* key;
    double least, most;
    std::function<void(Read&, double)> set;
    std::function<double(const Read&)> get;
};

template <class Owner>
Number number_of(const char* key, double least, double most, Owner Read::*owner, float Owner::*field) {
    return {key, least, most,
            [=](Read& read, double value) { read.*owner.*field = static_cast<float>(value); },
            [=](const Read& read) { return static_cast<double>(read.*owner.*field); }};
}

Number of_fabric(const char* key, double least, double most, float Fabric::*field) {
    return {key, least, most,
            [=](Read& read, double value) { read.cloth.fabric.*field = static_cast<float>(value); },
            [=](const Read& read) { return static_cast<double>(read.cloth.fabric.*field); }};
}

const std::vector<Number>& fabric_numbers() {
    static const std::vector<Number> all{of_fabric("areal_density", 1e-4, 1e4, &Fabric::areal_density),
                                         of_fabric("warp", 0, 1e9, &Fabric::warp),
                                         of_fabric("weft", 0, 1e9, &Fabric::weft),
                                         of_fabric("shear", 0, 1e9, &Fabric::shear),
                                         of_fabric("bending", 0, 1e4, &Fabric::bending),
                                         of_fabric("bending_ratio", 0.01, 100, &Fabric::bending_ratio),
                                         of_fabric("damping", 0, 100, &Fabric::damping),
                                         of_fabric("stiffening", 0, 1000, &Fabric::stiffening)};
    return all;
}

const std::vector<Number>& wind_numbers() {
    static const std::vector<Number> all{
        {"gusts", 0, 100, [](Read& r, double v) { r.world.wind.gust = static_cast<float>(v); },
         [](const Read& r) { return static_cast<double>(r.world.wind.gust); }},
        {"swirl_size", 1e-3, 1e5, [](Read& r, double v) { r.world.wind.gust_length = static_cast<float>(v); },
         [](const Read& r) { return static_cast<double>(r.world.wind.gust_length); }}};
    return all;
}

const std::vector<Number>& plain_numbers() {
    static const std::vector<Number> all{
        {"substeps", 1, 256, [](Read& r, double v) { r.world.substeps = static_cast<int>(v); },
         [](const Read& r) { return static_cast<double>(r.world.substeps); }},
        number_of("budget", 0, 1000, &Read::world, &WorldSettings::budget),
        {"cloth_substeps", 1, 1024, [](Read& r, double v) { r.cloth.substeps = static_cast<int>(v); },
         [](const Read& r) { return static_cast<double>(r.cloth.substeps); }},
        {"layers_apart", 0, 10,
         [](Read& r, double v) { r.cloth.self_collision.distance = static_cast<float>(v); },
         [](const Read& r) { return static_cast<double>(r.cloth.self_collision.distance); }},
        number_of("air_drag", 0, 1e6, &Read::cloth, &ClothSettings::air_damping),
        number_of("gap_to_bodies", 0, 10, &Read::cloth, &ClothSettings::thickness),
        number_of("friction", 0, 1000, &Read::cloth, &ClothSettings::friction),
        number_of("back_friction_ratio", 0, 1000, &Read::cloth, &ClothSettings::back_friction_ratio)};
    return all;
}

Result<void> read_number(const std::filesystem::path& file, const Number& number, const Json& value,
                         Read& read) {
    if (!value.is_number() || !(value.get<double>() >= number.least && value.get<double>() <= number.most))
        return malformed(file, std::string(number.key) + " is " + quoted_json(value) +
                                   "; it must be a number from " + words_of(number.least) + " to " +
                                   words_of(number.most));
    number.set(read, value.get<double>());
    return {};
}

const Number* find(const std::vector<Number>& numbers, const std::string& key) {
    for (const Number& each : numbers)
        if (key == each.key) return &each;
    return nullptr;
}

/// Reads an object of numbers; its velocity is left to read_velocity().
Result<void> read_numbers(const std::filesystem::path& file, const char* name, const Json& json,
                          const std::vector<Number>& numbers, Read& read) {
    if (!json.is_object()) return malformed(file, std::string(name) + " must be an object");
    for (const auto& [key, value] : json.items()) {
        if (key == "velocity") continue;
        const Number* const number = find(numbers, key);
        if (number == nullptr)
            return malformed(file, std::string(name) + " has no " + quoted_json(Json(key)));
        if (auto done = read_number(file, *number, value, read); !done) return done;
    }
    return {};
}

Result<void> read_velocity(const std::filesystem::path& file, const Json& json, Read& read) {
    if (!json.contains("velocity")) return {};
    const Json& v = json["velocity"];
    const auto fits = [](const Json& each) {
        return each.is_number() && std::abs(each.get<double>()) <= 1000;
    };
    if (!v.is_array() || v.size() != 3 || !fits(v[0]) || !fits(v[1]) || !fits(v[2]))
        return malformed(
            file, "velocity is " + quoted_json(v) + "; it must be three numbers from -1000 to 1000 m/s");
    read.world.wind.velocity = {v[0].get<float>(), v[1].get<float>(), v[2].get<float>()};
    return {};
}

Result<void> read_method(const std::filesystem::path& file, const Json& json, Read& read) {
    if (json.contains("method")) {
        const Json& name = json["method"];
        const NamedMethod* const method = name.is_string() ? find_method(name.get<std::string>()) : nullptr;
        if (method == nullptr) {
            std::string names;
            for (const NamedMethod& each : all_methods())
                names.append(names.empty() ? "" : ", ").append(each.name);
            return malformed(file, "there is no method " + quoted_json(name) + "; there are " + names);
        }
        if (method->method.index() != read.cloth.method.index()) read.cloth.method = method->method;
    }
    const auto number = [&](const char* key, double least, double most) -> Result<double> {
        const Json& value = json[key];
        if (!value.is_number() || !(value.get<double>() >= least && value.get<double>() <= most))
            return malformed(file, std::string(key) + " is " + quoted_json(value) +
                                       "; it must be a number from " + words_of(least) + " to " +
                                       words_of(most));
        return value.get<double>();
    };
    if (json.contains("iterations")) {
        const auto iterations = number("iterations", 0, 10000);
        if (!iterations) return iterations.error();
        set_iterations(read.cloth.method, static_cast<int>(*iterations));
    }
    return {};
}

Result<void> read_self_collision(const std::filesystem::path& file, const Json& value, Read& read) {
    std::string names;
    for (const SelfCollisionMethod method : self_collision_methods) {
        if (value.is_string() && value.get<std::string>() == name_of(method)) {
            set_method(read.cloth.self_collision, method);
            return {};
        }
        names.append(names.empty() ? "" : ", ").append(name_of(method));
    }
    return malformed(file, "self_collision is " + quoted_json(value) + "; it is one of " + names);
}

Result<void> read_part(const std::filesystem::path& file, const std::string& key, const Json& value,
                       Read& read) {
    if (key == "scene" || key == "method" || key == "iterations") return {};
    if (key == "material") return read_numbers(file, "material", value, fabric_numbers(), read);
    if (key == "self_collision") return read_self_collision(file, value, read);
    if (key == "wind") {
        if (auto done = read_numbers(file, "wind", value, wind_numbers(), read); !done) return done;
        return read_velocity(file, value, read);
    }
    const Number* const number = find(plain_numbers(), key);
    if (number == nullptr) return malformed(file, "settings have no " + quoted_json(Json(key)));
    return read_number(file, *number, value, read);
}

}  // namespace

Result<SettingsValues> read_settings(const std::filesystem::path& file, const WorldSettings& world,
                                     const ClothSettings& cloth) {
    const auto json = parse(file);
    if (!json) return json.error();
    Read read{world, cloth};
    for (const auto& [key, value] : json->items())
        if (auto done = read_part(file, key, value, read); !done) return done.error();
    if (auto done = read_method(file, *json, read); !done) return done.error();
    return read;
}

namespace {

/// The shortest decimal number that reads back as the same float.
Json shortest(float value) {
    if (std::round(value) == value && std::abs(value) < 1e6f) return static_cast<long long>(value);
    std::array<char, 32> text{};
    for (int digits = 1; digits <= 9; ++digits) {
        std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(value));
        if (std::strtof(text.data(), nullptr) == value) break;
    }
    return std::strtod(text.data(), nullptr);
}

Json numbers_json(const std::vector<Number>& numbers, const Read& read) {
    Json json = Json::object();
    for (const Number& each : numbers) json[each.key] = shortest(static_cast<float>(each.get(read)));
    return json;
}

void write_method(const Method& method, Json& json) {
    json["method"] = entry_of(method).name;
    if (const auto iterations = iterations_of(method)) json["iterations"] = *iterations;
}

}  // namespace

std::string settings_text(const std::string& scene, const SettingsValues& present) {
    Json json = Json::object();
    json["scene"] = scene;
    json["wind"] = numbers_json(wind_numbers(), present);
    const Vec3& velocity = present.world.wind.velocity;
    json["wind"]["velocity"] = {shortest(velocity.x), shortest(velocity.y), shortest(velocity.z)};
    json["material"] = numbers_json(fabric_numbers(), present);
    write_method(present.cloth.method, json);
    json["self_collision"] = name_of(present.cloth.self_collision.method);
    json.update(numbers_json(plain_numbers(), present));
    return json.dump(2) + '\n';
}

Result<std::string> scene_of_settings(const std::filesystem::path& file) {
    const auto json = parse(file);
    if (!json) return json.error();
    if (!json->contains("scene")) return std::string();
    if (!(*json)["scene"].is_string()) return malformed(file, "scene must be the name of one");
    return (*json)["scene"].get<std::string>();
}

}  // namespace weft::demo
