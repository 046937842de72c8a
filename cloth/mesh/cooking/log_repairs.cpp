#include "cloth/mesh/cooking/log_repairs.h"

#include <cstdint>

#include "engine/memory/hooks.h"

namespace weft {

void log_repairs(const ClothInfo& info) noexcept {
    const auto tell = [](LogLevel level, std::uint32_t count, const char* what) {
        if (count > 0) log_line(level, "mesh: %u %s", count, what);
    };
    tell(LogLevel::note, info.welded_vertices, "vertices were welded");
    tell(LogLevel::warning, info.dropped_triangles, "triangles were left out");
    tell(LogLevel::warning, info.turned_triangles, "triangles were turned");
    tell(LogLevel::note, info.flipped_triangles, "triangles were flipped, since slivers were among them");
    tell(LogLevel::warning, info.softened_triangles,
         "triangles are slivers, and less stiff than the fabric: see CookReport::softened");
    tell(LogLevel::warning, info.misoriented_edges, "edges have triangles that are wound against each other");
    tell(LogLevel::warning, info.loose_particles, "particles are of no triangle");
    constexpr float coarsest = 1;  // [m]: cloth in millimetres has edges of 2 and more
    if (info.mean_edge > coarsest)
        log_line(LogLevel::warning,
                 "mesh: its edges are %g m long in the mean, and cloth bends in centimetres; is it in "
                 "millimetres? "
                 "Coordinates are in metres",
                 static_cast<double>(info.mean_edge));
}

}  // namespace weft
