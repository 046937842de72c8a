#include "cloth/normals.h"

#include "engine/vector.h"

namespace weft {

void compute_normals(Parallel& parallel, const CookedCloth& model, std::span<Vec4> triangle_scratch,
                     ClothState& state) {
    parallel.ranges(static_cast<std::uint32_t>(model.triangles.size()), [&](const BlockRange& range) {
        for (std::uint32_t t = range.begin; t < range.end; ++t) {
            const auto [a, b, c] = model.triangles[t];
            const Vector3 origin = xyz(state.positions[a]);
            const Vector3 doubled =
                (xyz(state.positions[b]) - origin).cross(xyz(state.positions[c]) - origin);
            triangle_scratch[t] = to_vec4(doubled, 0);
        }
    });
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector3 sum = Vector3::Zero();
            for (std::uint32_t c = model.corner_offsets[i]; c < model.corner_offsets[i + 1]; ++c) {
                sum += xyz(triangle_scratch[model.corner_triangles[c]]);
            }
            const float length = sum.norm();
            state.normals[i] = length > 1e-20f ? to_vec4(sum / length, 0) : Vec4{0, 1, 0, 0};
        }
    });
}

}  // namespace weft
