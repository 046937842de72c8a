#pragma once
// A reader of files under the fuzzer: it gets damaged files, and has to refuse each with a message, or to
// make of it something whole and finite.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/random/random.h"
#include "weft/weft.h"

namespace weft::fuzz {

/// Thrown where a reader does not keep its promise.
struct Broken {
    std::string what;
};

inline void must(bool holds, const std::string& what) {
    if (!holds) throw Broken{what};
}

struct Reader {
    std::string name;
    /// Makes a damaged file in the folder, or in memory, and has it read. Returns whether it was accepted.
    /// Throws Broken.
    std::function<bool(Random&, const std::filesystem::path& folder)> read_one;
};

/// OBJ, cooked cloth, saves, recordings.
[[nodiscard]] std::vector<Reader> library_readers();
/// Garments with their materials and maps, glTF, BVH, fabrics, settings.
[[nodiscard]] std::vector<Reader> demo_readers();

void write_file(const std::filesystem::path& file, std::string_view bytes);

/// A refusal says what is wrong with the file of this name, at no more length than somebody reads.
void check_error(const Error& error, const std::string& file_name);
/// Finite positions, and triangles of them.
void check_mesh(const Mesh& mesh, const std::string& of);
void check_finite(std::span<const Vec4> values, const std::string& of);

/// A tube of triangles, open at both ends, with texture coordinates: what a skirt is.
[[nodiscard]] Mesh tube(std::uint32_t columns, std::uint32_t rows);

}  // namespace weft::fuzz
