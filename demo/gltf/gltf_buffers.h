#pragma once
// The bytes of a glTF file: its two kinds of container, and the buffers that it names.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demo/gltf/gltf_fields.h"
#include "demo/gltf/gltf_model.h"
#include "weft/error.h"

namespace weft {

using GltfBytes = std::vector<unsigned char>;

/// Reads all of a regular file. Error: the file cannot be read, or is larger than 2 GiB.
[[nodiscard]] Result<GltfBytes> read_bytes(const std::filesystem::path& file);

/// The two parts of a glTF file, as views of its bytes.
struct GltfContainer {
    std::string_view json;
    std::optional<std::string_view> binary;  ///< in some .glb files only
};

/// Finds the parts of a file. Error: a .glb whose chunks contradict the format or the file's length.
[[nodiscard]] Result<GltfContainer> open_container(const GltfBytes& bytes);

/// The `buffers` of a file in `folder`, 2 GiB together at most, each of the length that the file says.
[[nodiscard]] Result<std::vector<GltfBytes>> load_buffers(const GltfFields& file,
                                                          const std::filesystem::path& folder,
                                                          std::optional<std::string_view> binary);

/// The `images` of a file in `folder`, of which those that cannot be read have no bytes.
[[nodiscard]] std::vector<GltfPicture> load_pictures(const GltfFields& file,
                                                     const std::filesystem::path& folder,
                                                     const GltfModel& model);

/// Is true if Weft was built with Draco.
extern const bool has_draco;

/// Decodes compressed primitives: their data become buffers, views and accessors like any others. Without
/// Draco they keep their uncompressed data, if they have any. What cannot be decoded becomes the primitive's
/// fault: also data that is compressed only, without Draco. Error: all decoded data are more than 2 GiB.
[[nodiscard]] Result<void> decode_draco(GltfModel& model);

}  // namespace weft
