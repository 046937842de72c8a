#pragma once
// Values of a glTF file's JSON, each checked as it is read. Errors name the value by its path, as in
// "accessors[3].count".

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "weft/error.h"

namespace weft {

[[nodiscard]] inline Error gltf_error(const std::string& what) {
    return {ErrorCode::malformed_file, what};
}

/// One JSON object. The first value that does not fit becomes the error. Such values read as absent, zero or
/// empty, and the caller checks the error once, at the end.
class GltfFields {
  public:
    /// `path` is empty for the whole file. `object` and `error` must outlive the fields.
    GltfFields(const nlohmann::json& object, std::string path, std::optional<Error>& error);

    [[nodiscard]] bool has(const char* key) const;
    /// A whole number from 0 to `most`; `absent` where the key is missing.
    [[nodiscard]] std::size_t whole(const char* key, std::size_t absent, std::size_t most = most_whole) const;
    /// An index into something of `size` elements, or none.
    [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t size) const;
    /// An index whose absence is an error.
    [[nodiscard]] std::size_t needed_index(const char* key, std::size_t size) const;
    /// Indices below `size`, all different.
    [[nodiscard]] std::vector<std::size_t> indices(const char* key, std::size_t size) const;
    /// Every key of an object with its value, an index below `size`.
    [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> named_indices(const char* key,
                                                                                 std::size_t size) const;
    /// Exactly `count` numbers that a float can hold, or none.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const;
    [[nodiscard]] bool flag(const char* key) const;
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] std::vector<std::string> texts(const char* key) const;  ///< of an array

    /// An object; an empty one where it is absent.
    [[nodiscard]] GltfFields object(const char* key) const;
    /// The objects of an array; none where it is absent.
    [[nodiscard]] std::vector<GltfFields> objects(const char* key) const;
    [[nodiscard]] std::size_t size(const char* key) const;  ///< elements of an array

    /// Reports a value as an error: "accessors[3].count is 9; it must be ...".
    void must(const char* key, const std::string& be) const;
    /// Reports the object as an error: "accessors[3] ...".
    void complain(const std::string& what) const;

    /// Up to this number a double holds whole numbers exactly.
    static constexpr std::size_t most_whole = std::size_t{1} << 53;

  private:
    [[nodiscard]] const nlohmann::json* find(const char* key) const;
    [[nodiscard]] std::string path_of(const char* key) const;
    [[nodiscard]] std::optional<std::size_t> whole_of(const nlohmann::json& value, const std::string& path,
                                                      std::size_t most) const;
    void refuse(const nlohmann::json& value, const std::string& path, const std::string& be) const;

    const nlohmann::json* object_;
    std::string path_;
    std::optional<Error>* error_;
};

}  // namespace weft
