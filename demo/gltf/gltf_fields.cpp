#include "demo/gltf/gltf_fields.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>

#include "demo/number_json.h"

namespace weft {
namespace {

using Json = nlohmann::json;

const Json no_fields = Json::object();

std::string element(const std::string& path, std::size_t i) {
    return path + "[" + std::to_string(i) + "]";
}

std::string below(std::size_t size) {
    return size == 0 ? "absent, since there are none" : "an index from 0 to " + std::to_string(size - 1);
}

}  // namespace

GltfFields::GltfFields(const Json& object, std::string path, std::optional<Error>& error)
    : object_(&object), path_(std::move(path)), error_(&error) {
    if (object.is_object()) return;
    refuse(object, path_.empty() ? "the file" : path_, "a JSON object");
    object_ = &no_fields;
}

bool GltfFields::has(const char* key) const {
    return find(key) != nullptr;
}

std::size_t GltfFields::whole(const char* key, std::size_t absent, std::size_t most) const {
    const Json* const value = find(key);
    return value == nullptr ? absent : whole_of(*value, path_of(key), most).value_or(0);
}

std::optional<std::size_t> GltfFields::index(const char* key, std::size_t size) const {
    const Json* const value = find(key);
    if (value == nullptr) return std::nullopt;
    if (size > 0) return whole_of(*value, path_of(key), size - 1);
    refuse(*value, path_of(key), below(size));
    return std::nullopt;
}

std::size_t GltfFields::needed_index(const char* key, std::size_t size) const {
    if (!has(key)) complain(std::string("has no ") + key + "; it must be " + below(size));
    return index(key, size).value_or(0);
}

std::vector<std::size_t> GltfFields::indices(const char* key, std::size_t size) const {
    std::vector<std::size_t> all;
    const Json* const values = find(key);
    if (values == nullptr) return all;
    if (!values->is_array()) {
        refuse(*values, path_of(key), "an array of indices");
        return all;
    }
    std::unordered_set<std::size_t> seen;
    for (std::size_t i = 0; i < values->size(); ++i) {
        const Json& value = (*values)[i];
        const std::string path = element(path_of(key), i);
        if (size == 0) refuse(value, path, below(size));
        const auto index = size == 0 ? std::nullopt : whole_of(value, path, size - 1);
        if (!index) return {};
        if (!seen.insert(*index).second) refuse(value, path, "another index than those before it");
        all.push_back(*index);
    }
    return all;
}

std::vector<std::pair<std::string, std::size_t>> GltfFields::named_indices(const char* key,
                                                                           std::size_t size) const {
    std::vector<std::pair<std::string, std::size_t>> all;
    const GltfFields from = object(key);
    for (const auto& [name, unused] : from.object_->items())
        all.emplace_back(name, from.needed_index(name.c_str(), size));
    return all;
}

std::vector<double> GltfFields::numbers(const char* key, std::size_t count) const {
    const Json* const values = find(key);
    if (values == nullptr) return {};
    const auto fits = [](const Json& each) {
        return each.is_number() &&
               std::abs(each.get<double>()) <= static_cast<double>(std::numeric_limits<float>::max());
    };
    if (values->is_array() && values->size() == count && std::ranges::all_of(*values, fits))
        return values->get<std::vector<double>>();
    refuse(*values, path_of(key), std::to_string(count) + " numbers that a float can hold");
    return {};
}

bool GltfFields::flag(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) return false;
    if (value->is_boolean()) return value->get<bool>();
    refuse(*value, path_of(key), "true or false");
    return false;
}

std::string GltfFields::text(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) return {};
    if (value->is_string()) return value->get<std::string>();
    refuse(*value, path_of(key), "a string");
    return {};
}

std::vector<std::string> GltfFields::texts(const char* key) const {
    std::vector<std::string> all;
    const std::size_t count = size(key);
    for (std::size_t i = 0; i < count; ++i) {
        const Json& value = (*find(key))[i];
        if (!value.is_string()) refuse(value, element(path_of(key), i), "a string");
        all.push_back(value.is_string() ? value.get<std::string>() : "");
    }
    return all;
}

GltfFields GltfFields::object(const char* key) const {
    const Json* const value = find(key);
    return {value == nullptr ? no_fields : *value, path_of(key), *error_};
}

std::vector<GltfFields> GltfFields::objects(const char* key) const {
    std::vector<GltfFields> all;
    const std::size_t count = size(key);
    for (std::size_t i = 0; i < count; ++i)
        all.emplace_back((*find(key))[i], element(path_of(key), i), *error_);
    return all;
}

std::size_t GltfFields::size(const char* key) const {
    const Json* const values = find(key);
    if (values == nullptr) return 0;
    if (values->is_array()) return values->size();
    refuse(*values, path_of(key), "an array");
    return 0;
}

void GltfFields::must(const char* key, const std::string& be) const {
    if (const Json* const value = find(key)) return refuse(*value, path_of(key), be);
    complain(std::string("has no ") + key + "; it must be " + be);
}

void GltfFields::complain(const std::string& what) const {
    if (!*error_)
        *error_ = Error{ErrorCode::malformed_file, (path_.empty() ? "the file" : path_) + " " + what};
}

const Json* GltfFields::find(const char* key) const {
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

std::string GltfFields::path_of(const char* key) const {
    return path_.empty() ? key : path_ + "." + key;
}

std::optional<std::size_t> GltfFields::whole_of(const Json& value, const std::string& path,
                                                std::size_t most) const {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (number >= 0 && number <= static_cast<double>(most) && number == std::floor(number))
        return static_cast<std::size_t>(number);
    refuse(value, path, "a whole number from 0 to " + std::to_string(most));
    return std::nullopt;
}

void GltfFields::refuse(const Json& value, const std::string& path, const std::string& be) const {
    if (*error_) return;
    *error_ =
        Error{ErrorCode::malformed_file, path + " is " + demo::quoted_json(value) + "; it must be " + be};
}

}  // namespace weft
