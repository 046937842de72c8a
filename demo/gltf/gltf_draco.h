#pragma once
// Primitives that are compressed by Draco (KHR_draco_mesh_compression).

#include "demo/gltf/gltf_model.h"

namespace weft {

/// Is true if Weft was built with Draco.
extern const bool has_draco;

/// Decodes compressed primitives: their data become buffers, views and accessors like any others. Without
/// Draco they keep their uncompressed data, if they have any. What cannot be decoded becomes the primitive's
/// fault: also data that is compressed only, without Draco. Error: all decoded data are more than 2 GiB.
[[nodiscard]] Result<void> decode_draco(GltfModel& model);

}  // namespace weft
