#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cloth/proxy/cells.h"
#include "cloth/proxy/plain_surface.h"
#include "cloth/surface/nearest_triangle.h"
#include "engine/error_text.h"
#include "engine/memory/without_exceptions.h"
#include "weft/proxy.h"
#include "weft/types.h"

namespace weft {

namespace {

constexpr float least_part = 2;    // cells: the least diagonal of a part that is simulated
constexpr float least_border = 3;  // cells: shorter borders are closed
constexpr float refinement = 4;    // points of the surface along an edge of the proxy, at least

Result<void> check(const ProxySettings& settings) {
    if (!(settings.particles >= 12 && settings.particles <= 1u << 20))
        return out_of_range("ProxySettings::particles", static_cast<double>(settings.particles),
                            "from 12 to 2^20 = 1048576");
    if (!(settings.thickness >= 0 && settings.thickness <= 1))
        return out_of_range("ProxySettings::thickness", static_cast<double>(settings.thickness),
                            "from 0 to 1 m");
    return {};
}

/// The edge of so many equilateral triangles' corners over the surface: a corner has an area of sqrt(3/4)
/// edge^2, one on a border half of that, and borders have one an edge.
float edge_for(const PlainSurface& surface, std::uint32_t wanted) {
    double area = 0, border = 0;
    for (const Triangle& t : surface.triangles) area += static_cast<double>(area_of(surface, t));
    for (const auto& loop : borders_of(surface)) border += static_cast<double>(length_of(surface, loop));
    const double a = area * 2 / std::numbers::sqrt3, b = border / 2;
    return static_cast<float>((b + std::sqrt(b * b + 4 * a * wanted)) / (2 * wanted));
}

/// The number of parts, and whether each triangle's part is large enough; the largest always is.
std::vector<bool> large_parts(const PlainSurface& surface, float least, ProxyReport& report) {
    const std::vector<std::uint32_t> parts =
        parts_of(surface, std::vector<bool>(surface.triangles.size(), true));
    std::vector<Eigen::AlignedBox3f> boxes;
    for (std::size_t t = 0; t < parts.size(); ++t) {
        boxes.resize(std::max<std::size_t>(boxes.size(), parts[t] + 1));
        for (const std::uint32_t p : surface.triangles[t]) boxes[parts[t]].extend(surface.points[p]);
    }
    float most = least;
    for (const auto& box : boxes) most = std::max(most, box.diagonal().norm());
    const auto is_large = [&](std::uint32_t part) {
        const float size = boxes[part].diagonal().norm();
        return size > least || size == most;
    };
    report.parts = 0;
    for (std::uint32_t part = 0; part < boxes.size(); ++part) report.parts += is_large(part) ? 1 : 0;
    report.left_out_parts = static_cast<std::uint32_t>(boxes.size()) - report.parts;
    std::vector<bool> kept;
    for (const std::uint32_t part : parts) kept.push_back(is_large(part));
    return kept;
}

/// The part of the mesh that is simulated, with edges that are short beside the proxy's.
PlainSurface prepared(const PlainSurface& whole, const ProxySettings& settings, ProxyReport& report) {
    const std::vector<bool> outer = outer_layers(whole, settings.thickness);
    report.left_out_triangles = static_cast<std::uint32_t>(std::ranges::count(outer, false));
    PlainSurface surface = kept_of(whole, outer);
    report.cell = edge_for(surface, settings.particles);
    surface = kept_of(surface, large_parts(surface, least_part * report.cell, report));
    report.cell = edge_for(surface, settings.particles);
    for (const auto& loop : borders_of(surface)) {
        if (!(length_of(surface, loop) < least_border * report.cell)) continue;
        close_border(surface, loop);
        ++report.closed_holes;
    }
    report.cell = edge_for(surface, settings.particles);
    refine(surface, report.cell / refinement);
    return surface;
}

/// Measures edges, and how far the mesh's vertices lie from the proxy.
void measure(const Mesh& fine, const PlainSurface& proxy, ProxyReport& report) {
    report.shortest_edge = std::numeric_limits<float>::infinity();
    for (const Triangle& t : proxy.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float length = (proxy.points[t[(c + 1) % 3]] - proxy.points[t[c]]).norm();
            report.shortest_edge = std::min(report.shortest_edge, length);
            report.longest_edge = std::max(report.longest_edge, length);
        }
    }
    const NearestTriangle nearest = nearest_on(proxy);
    std::uint32_t leaf = 0;
    for (const Vec3& p : fine.positions) {
        const auto found = nearest.to(to_vector(p), Vector3::Zero(), std::numeric_limits<float>::max(), leaf);
        leaf = found->leaf;
        report.reach = std::max(report.reach, found->distance);
    }
}

}  // namespace

Result<Mesh> make_proxy(const Mesh& fine, const ProxySettings& settings, ProxyReport* report) {
    return without_exceptions([&]() -> Result<Mesh> {
        if (auto valid = check(settings); !valid) return valid.error();
        const auto whole = plain_surface(fine);
        if (!whole) return whole.error();
        ProxyReport made;
        const PlainSurface surface = prepared(*whole, settings, made);
        const PlainSurface proxy =
            triangles_between(surface, cut_into_cells(surface, made.cell, settings.particles));
        if (proxy.triangles.empty())
            return Error{ErrorCode::invalid_mesh, "nothing is left of the mesh at edges of " +
                                                      number_text(static_cast<double>(made.cell)) +
                                                      " m: raise ProxySettings::particles"};
        measure(fine, proxy, made);
        if (report != nullptr) *report = made;
        Mesh mesh;
        for (const Vector3& p : proxy.points) mesh.positions.push_back(to_vec3(p));
        mesh.triangles = proxy.triangles;
        return mesh;
    });
}

}  // namespace weft
