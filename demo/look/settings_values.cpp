#include "demo/look/settings_values.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "demo/must.h"
#include "demo/number_json.h"
#include "demo/options/method_table.h"
#include "demo/self_collision.h"

namespace weft::demo {
namespace {

using Json = nlohmann::ordered_json;

using Read = SettingsValues;

/// Throws Refusal.
Json parse(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw Refusal({ErrorCode::file_not_found, "cannot be read; it must be a JSON file of settings"});
    auto json = parse_json<Json>(stream);
    if (!json || !json->is_object()) refuse("is no JSON object of settings");
    return *std::move(json);
}

/// Numbers whose key is not the field's name. The file does not have those without one.
constexpr struct {
    std::string_view name;
    const char* key;
} renamed[] = {{"Wind::gust", "gusts"},
               {"Wind::gust_length", "swirl_size"},
               {"WorldSettings::threads", ""},
               {"WorldSettings::contact_reports", ""},
               {"ClothSettings::substeps", "cloth_substeps"},
               {"SelfCollision::distance", "layers_apart"},
               {"SelfCollision::friction", ""},
               {"SelfCollision::restitution", ""},
               {"ClothSettings::air_damping", "air_drag"},
               {"ClothSettings::thickness", "gap_to_bodies"}};

/// Numbers of an object of the file, by key.
using Numbers = std::vector<std::pair<std::string, SettingNumber>>;

/// The numbers of the structs of these names.
Numbers numbers_of(Read& read, std::initializer_list<std::string_view> types) {
    Numbers found;
    for (const auto& all : {weft::numbers_of(read.world), weft::numbers_of(read.cloth)})
        for (const SettingNumber& each : *all) {
            const std::string name = std::string(each.type) + "::" + each.field;
            const auto other = std::ranges::find(renamed, name, [](const auto& pair) { return pair.name; });
            if (std::ranges::find(types, each.type) == types.end()) continue;
            const std::string key = other == std::end(renamed) ? each.field : other->key;
            if (!key.empty()) found.emplace_back(key, each);
        }
    return found;
}
Numbers wind_numbers(Read& read) {
    return numbers_of(read, {"Wind"});
}
Numbers fabric_numbers(Read& read) {
    return numbers_of(read, {"Fabric"});
}
/// The numbers that no object groups.
Numbers plain_numbers(Read& read) {
    return numbers_of(read, {"WorldSettings", "ClothSettings", "SelfCollision"});
}

/// Reads a value of these numbers. `owner` is what the message says has no such key.
void read_number(const char* owner, const Numbers& numbers, const std::string& key, const Json& value) {
    const auto found = std::ranges::find(numbers, key, [](const auto& each) { return each.first; });
    if (found == numbers.end()) refuse(std::string(owner) + " no " + quoted_json(Json(key)));
    if (auto set = number_from_json(found->second, key, value); !set) refuse(set.error().message);
}

void read_numbers(const char* name, const Json& json, const Numbers& numbers) {
    if (!json.is_object()) refuse(std::string(name) + " must be an object");
    for (const auto& [key, value] : json.items())
        read_number((std::string(name) + " has").c_str(), numbers, key, value);
}

void read_method(const Json& json, Read& read) {
    if (json.contains("method")) {
        const Json& name = json["method"];
        const NamedMethod* const method = name.is_string() ? find_method(name.get<std::string>()) : nullptr;
        if (method == nullptr) {
            std::string names;
            for (const NamedMethod& each : all_methods())
                names.append(names.empty() ? "" : ", ").append(each.name);
            refuse("there is no method " + quoted_json(name) + "; there are " + names);
        }
        if (method->method.index() != read.cloth.method.index()) read.cloth.method = method->method;
    }
    if (json.contains("iterations")) {
        const Json& value = json["iterations"];
        if (!value.is_number() || !(value.get<double>() >= 0 && value.get<double>() <= 10000))
            refuse("iterations is " + quoted_json(value) + "; it must be a number from 0 to 10000");
        set_iterations(read.cloth.method, value.get<int>());
    }
}

void read_self_collision(const Json& value, Read& read) {
    std::string names;
    for (const SelfCollisionMethod method : self_collision_methods) {
        if (value.is_string() && value.get<std::string>() == name_of(method)) {
            set_method(read.cloth.self_collision, method);
            return;
        }
        names.append(names.empty() ? "" : ", ").append(name_of(method));
    }
    refuse("self_collision is " + quoted_json(value) + "; it is one of " + names);
}

void read_part(const std::string& key, const Json& value, Read& read) {
    if (key == "scene" || key == "method" || key == "iterations") return;
    if (key == "self_collision") return read_self_collision(value, read);
    if (key == "material") return read_numbers("material", value, fabric_numbers(read));
    if (key == "wind") return read_numbers("wind", value, wind_numbers(read));
    return read_number("settings have", plain_numbers(read), key, value);
}

}  // namespace

Result<SettingsValues> read_settings(const std::filesystem::path& file, const WorldSettings& world,
                                     const ClothSettings& cloth) {
    return caught_in(file, [&] {
        const Json json = parse(file);
        Read read{world, cloth};
        for (const auto& [key, value] : json.items()) read_part(key, value, read);
        read_method(json, read);
        return read;
    });
}

namespace {

Json numbers_json(const Numbers& numbers) {
    Json json = Json::object();
    for (const auto& [key, number] : numbers) json[key] = number_to_json(number);
    return json;
}

void write_method(const Method& method, Json& json) {
    json["method"] = entry_of(method).name;
    if (const auto iterations = iterations_of(method)) json["iterations"] = *iterations;
}

}  // namespace

std::string settings_text(const std::string& scene, const SettingsValues& present) {
    SettingsValues copy = present;
    Json json = Json::object();
    json["scene"] = scene;
    json["wind"] = numbers_json(wind_numbers(copy));
    json["material"] = numbers_json(fabric_numbers(copy));
    write_method(present.cloth.method, json);
    json["self_collision"] = name_of(present.cloth.self_collision.method);
    json.update(numbers_json(plain_numbers(copy)));
    return json.dump(2) + '\n';
}

Result<std::string> scene_of_settings(const std::filesystem::path& file) {
    return caught_in(file, [&]() -> std::string {
        const Json json = parse(file);
        if (!json.contains("scene")) return {};
        if (!json["scene"].is_string()) refuse("scene must be the name of one");
        return json["scene"].get<std::string>();
    });
}

}  // namespace weft::demo
