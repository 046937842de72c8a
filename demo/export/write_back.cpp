#include "demo/export/write_back.h"

#include <algorithm>

namespace weft::demo {

void write_back(const ClothView& cloth, std::span<Vec3> vertices) {
    const std::size_t count = std::min(vertices.size(), cloth.vertex_to_particle.size());
    for (std::size_t v = 0; v < count; ++v) {
        const Vec4& p = cloth.positions[cloth.vertex_to_particle[v]];
        if (p.w != 0) vertices[v] = {p.x, p.y, p.z};
    }
}

}  // namespace weft::demo
