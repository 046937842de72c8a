#include "weft/drawn_mesh.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cloth/surface/drawn_bonds.h"
#include "cloth/surface/nearest_triangle.h"
#include "engine/error_text.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// `v` at length 1; `otherwise` where it has none.
Vector3 unit_or(const Vector3& v, const Vector3& otherwise) {
    const float length = v.norm();
    return length > 1e-12f ? Vector3(v / length) : otherwise;
}

/// A point on the rounded surface, and axes there: along the triangle's first side, across, and out.
struct SurfacePoint {
    Vector3 position;
    Matrix3 frame;
    Vector3 first_side, second_side;  // of the triangle, from its first corner
};

SurfacePoint surface_point(const ClothView& cloth, const std::array<std::uint32_t, 3>& particles,
                           float second, float third, float rounding) {
    const std::array<float, 3> weights{1 - second - third, second, third};
    std::array<Vector3, 3> corners, normals;
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = xyz(cloth.positions[particles[c]]);
        normals[c] = xyz(cloth.normals[particles[c]]);
    }
    const Vector3 flat = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    const Vector3 mean = weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2];
    Vector3 rise = Vector3::Zero();
    for (std::size_t c = 0; c < 3; ++c) rise += weights[c] * (corners[c] - flat).dot(normals[c]) * normals[c];
    SurfacePoint at{flat + rounding * rise, Matrix3(), corners[1] - corners[0], corners[2] - corners[0]};
    const Vector3& side = at.first_side;
    at.frame.col(2) = unit_or(mean, unit_or(side.cross(at.second_side), Vector3::UnitY()));
    at.frame.col(0) =
        unit_or(side - side.dot(at.frame.col(2)) * at.frame.col(2), at.frame.col(2).unitOrthogonal());
    at.frame.col(1) = at.frame.col(2).cross(at.frame.col(0));
    return at;
}

Error bad_vertex(std::size_t vertex, const std::string& what) {
    return {ErrorCode::invalid_argument,
            "vertex " + std::to_string(vertex) + " of the drawn surface " + what};
}

Result<void> check_counts(const DrawnSurface& surface) {
    const std::size_t count = surface.vertices.size();
    for (const auto& [name, size] : {std::pair("texture coordinates", surface.texcoords.size()),
                                     std::pair("normals", surface.normals.size())}) {
        if (size != 0 && size != count)
            return Error{ErrorCode::invalid_argument, "the drawn surface has " + std::to_string(size) + " " +
                                                          name + " for " + std::to_string(count) +
                                                          " vertices; give one each, or none"};
    }
    return {};
}

Result<void> check_surface(const DrawnSurface& surface, const DrawnMeshSettings& settings) {
    if (!(settings.rounding >= 0 && settings.rounding <= 1))
        return out_of_range("DrawnMeshSettings::rounding", static_cast<double>(settings.rounding),
                            "from 0 to 1");
    if (!(settings.reach > 0 && settings.reach <= 10))
        return out_of_range("DrawnMeshSettings::reach", static_cast<double>(settings.reach),
                            "above 0 and at most 10 m");
    if (auto counts = check_counts(surface); !counts) return counts;
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
        if (!is_finite(surface.vertices[v])) return bad_vertex(v, "is not finite");
        if (!surface.normals.empty() && !is_finite(surface.normals[v]))
            return bad_vertex(v, "has a normal that is not finite");
        const bool sound =
            surface.texcoords.empty() || is_finite({surface.texcoords[v].x, surface.texcoords[v].y, 0});
        if (!sound) return bad_vertex(v, "has texture coordinates that are not finite");
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (const std::uint32_t v : surface.triangles[t]) {
            if (v < surface.vertices.size()) continue;
            return Error{ErrorCode::invalid_argument,
                         "triangle " + std::to_string(t) + " of the drawn surface has vertex " +
                             std::to_string(v) + "; there are " + std::to_string(surface.vertices.size())};
        }
    }
    return {};
}

/// Each drawn vertex's normal, and the directions in which both texture coordinates grow. None has unit
/// length.
struct VertexAxes {
    std::vector<Vector3> normals, along_u, along_v;
};

VertexAxes axes_of(const DrawnSurface& surface) {
    const std::size_t count = surface.vertices.size();
    const std::vector<Vector3> zeros(count, Vector3::Zero());
    VertexAxes axes{zeros, zeros, zeros};
    for (const Triangle& t : surface.triangles) {
        const auto side = [&](std::size_t c) -> Vector3 {
            return to_vector(surface.vertices[t[c]]) - to_vector(surface.vertices[t[0]]);
        };
        const Vector3 area = side(1).cross(side(2));
        for (const std::uint32_t v : t) axes.normals[v] += area;
        if (surface.texcoords.empty()) continue;
        const Vec2 &o = surface.texcoords[t[0]], &p = surface.texcoords[t[1]], &q = surface.texcoords[t[2]];
        const float u1 = p.x - o.x, v1 = p.y - o.y, u2 = q.x - o.x, v2 = q.y - o.y;
        const float turn = u1 * v2 - u2 * v1 < 0 ? -1.0f : 1.0f;
        for (const std::uint32_t v : t) {
            axes.along_u[v] += turn * (v2 * side(1) - v1 * side(2));
            axes.along_v[v] += turn * (u1 * side(2) - u2 * side(1));
        }
    }
    for (std::size_t v = 0; v < surface.normals.size(); ++v) axes.normals[v] = to_vector(surface.normals[v]);
    return axes;
}

/// unit_or() of components in a frame.
std::array<float, 3> unit_or(const std::array<float, 3>& v, const std::array<float, 3>& otherwise) {
    const Vector3 unit =
        unit_or(Vector3(v[0], v[1], v[2]), Vector3(otherwise[0], otherwise[1], otherwise[2]));
    return {unit.x(), unit.y(), unit.z()};
}

std::array<float, 3> in_frame(const Matrix3& frame, const Vector3& v) {
    const Vector3 local = frame.transpose() * v;
    return {local.x(), local.y(), local.z()};
}

/// The multiples of the two sides whose sum is nearest to `v`.
std::array<float, 2> in_sides(const SurfacePoint& at, const Vector3& v) {
    const Vector3 &s = at.first_side, &t = at.second_side;
    const float ss = s.dot(s), st = s.dot(t), tt = t.dot(t), vs = v.dot(s), vt = v.dot(t);
    const float det = ss * tt - st * st;
    if (!(det > 1e-6f * ss * tt)) return {1, 0};
    return {(vs * tt - vt * st) / det, (vt * ss - vs * st) / det};
}

/// The part of `way` in the normal's plane, at unit length; that of `otherwise` where it has none.
Vector3 tangent_to(const Vector3& normal, const Vector3& way, const Vector3& otherwise) {
    return unit_or(way - way.dot(normal) * normal,
                   unit_or(otherwise - otherwise.dot(normal) * normal, normal.unitOrthogonal()));
}

/// The numbers of the first `most_named` vertices.
std::string list_of(const std::vector<std::size_t>& vertices) {
    constexpr std::size_t most_named = 16;
    std::string text;
    for (std::size_t k = 0; k < std::min(most_named, vertices.size()); ++k)
        text += (k > 0 ? ", " : "") + std::to_string(vertices[k]);
    return vertices.size() > most_named ? text + ", ..." : text;
}

/// Precondition: `vertices` is not empty.
Error out_of_reach(const std::vector<std::size_t>& vertices, std::size_t all, float reach) {
    const std::string end = " further from the cloth than DrawnMeshSettings::reach, " +
                            number_text(static_cast<double>(reach)) + " m";
    if (vertices.size() == 1) return bad_vertex(vertices[0], "is" + end);
    return {ErrorCode::invalid_argument, std::to_string(vertices.size()) + " of the " + std::to_string(all) +
                                             " vertices of the drawn surface are" + end + ": vertices " +
                                             list_of(vertices)};
}

DrawnBond bond_to(const ClothView& cloth, const NearestTriangle::Found& found, float rounding,
                  const Vector3& vertex, const Vector3& normal, const Vector3& along_u,
                  const Vector3& along_v) {
    DrawnBond bond;
    bond.particles = cloth.triangles[found.triangle];
    bond.second = found.second;
    bond.third = found.third;
    const SurfacePoint at = surface_point(cloth, bond.particles, bond.second, bond.third, rounding);
    const Vector3 out = unit_or(normal, at.frame.col(2));
    const Vector3 tangent = tangent_to(out, along_u, at.first_side);
    bond.offset = in_frame(at.frame, vertex - at.position);
    bond.normal = in_frame(at.frame, out);
    bond.tangent = in_sides(at, tangent);
    bond.handedness = out.cross(tangent).dot(along_v) < 0 ? -1.0f : 1.0f;
    return bond;
}

}  // namespace

DrawnMesh::DrawnMesh(std::unique_ptr<Bonds> bonds) : bonds_(std::move(bonds)) {}
DrawnMesh::DrawnMesh(DrawnMesh&&) noexcept = default;
DrawnMesh& DrawnMesh::operator=(DrawnMesh&&) noexcept = default;
DrawnMesh::~DrawnMesh() = default;

Result<DrawnMesh> DrawnMesh::bind(const ClothView& cloth, const DrawnSurface& surface,
                                  const DrawnMeshSettings& settings) {
    return without_exceptions([&]() -> Result<DrawnMesh> {
        if (auto sound = check_surface(surface, settings); !sound) return sound.error();
        const VertexAxes axes = axes_of(surface);
        const NearestTriangle nearest(cloth);
        auto bonds = std::make_unique<Bonds>();
        bonds->rounding = settings.rounding;
        bonds->mesh = BoundMesh(cloth);
        bonds->of_vertex.reserve(surface.vertices.size());
        std::vector<std::size_t> unbound;
        std::uint32_t nearby = 0;
        for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
            const Vector3 vertex = to_vector(surface.vertices[v]);
            const auto found = nearest.to(vertex, axes.normals[v], settings.reach, nearby);
            if (found) nearby = found->leaf;
            if (!found)
                unbound.push_back(v);
            else if (unbound.empty())
                bonds->of_vertex.push_back(bond_to(cloth, *found, settings.rounding, vertex, axes.normals[v],
                                                   axes.along_u[v], axes.along_v[v]));
        }
        if (!unbound.empty()) return out_of_reach(unbound, surface.vertices.size(), settings.reach);
        return DrawnMesh(std::move(bonds));
    });
}

std::size_t DrawnMesh::size() const noexcept {
    return bonds_->of_vertex.size();
}

std::span<const DrawnBond> DrawnMesh::bonds() const noexcept {
    return bonds_->of_vertex;
}

float DrawnMesh::rounding() const noexcept {
    return bonds_->rounding;
}

Result<void> DrawnMesh::begin_blend(const ClothView& cloth, std::span<const Vec4> positions,
                                    std::span<const Vec4> normals) {
    return without_exceptions([&]() -> Result<void> {
        if (bonds_->mesh != BoundMesh(cloth))
            return Error{ErrorCode::invalid_argument, "the cloth has another mesh than was bound to"};
        if (positions.size() != size() || (!normals.empty() && normals.size() != size()))
            return Error{ErrorCode::invalid_argument,
                         std::to_string(positions.size()) + " positions and " +
                             std::to_string(normals.size()) + " normals; the drawn mesh has " +
                             std::to_string(size()) + " vertices: give one each"};
        for (std::size_t v = 0; v < size(); ++v) {
            if (!is_finite(to_vec3(xyz(positions[v])))) return bad_vertex(v, "is not finite");
            if (!normals.empty() && !is_finite(to_vec3(xyz(normals[v]))))
                return bad_vertex(v, "has a normal that is not finite");
        }
        std::vector<DrawnBond> own = bonds_->without_blend(), start = own;
        for (std::size_t v = 0; v < size(); ++v) {
            DrawnBond& bond = start[v];
            const SurfacePoint at =
                surface_point(cloth, bond.particles, bond.second, bond.third, bonds_->rounding);
            bond.offset = in_frame(at.frame, xyz(positions[v]) - at.position);
            if (!normals.empty()) bond.normal = unit_or(in_frame(at.frame, xyz(normals[v])), bond.normal);
        }
        bonds_->of_vertex = start;
        bonds_->own = std::move(own);
        bonds_->start = std::move(start);
        return {};
    });
}

Result<void> DrawnMesh::blend(float left) {
    return without_exceptions([&]() -> Result<void> {
        if (!(left >= 0 && left <= 1)) return out_of_range("left", static_cast<double>(left), "from 0 to 1");
        for (std::size_t v = 0; v < bonds_->own.size(); ++v) {
            const DrawnBond &own = bonds_->own[v], &start = bonds_->start[v];
            DrawnBond& bond = bonds_->of_vertex[v];
            const auto between = [&](const std::array<float, 3>& from, const std::array<float, 3>& to) {
                return std::array{(1 - left) * from[0] + left * to[0], (1 - left) * from[1] + left * to[1],
                                  (1 - left) * from[2] + left * to[2]};
            };
            bond.offset = between(own.offset, start.offset);
            bond.normal = unit_or(between(own.normal, start.normal), own.normal);
        }
        if (left > 0 || bonds_->own.empty()) return {};
        bonds_->of_vertex = std::move(bonds_->own);
        bonds_->own = {};
        bonds_->start = {};
        return {};
    });
}

void DrawnMesh::update(const ClothView& cloth, const DrawnVertices& to, std::size_t first,
                       std::size_t count) const noexcept {
    const std::size_t last = std::min(size(), count > SIZE_MAX - first ? SIZE_MAX : first + count);
    const bool positions = to.positions.size() >= size(), normals = to.normals.size() >= size();
    const bool tangents = to.tangents.size() >= size();
    for (std::size_t v = first; v < last; ++v) {
        const DrawnBond& bond = bonds_->of_vertex[v];
        const SurfacePoint at =
            surface_point(cloth, bond.particles, bond.second, bond.third, bonds_->rounding);
        const auto turned = [&](const std::array<float, 3>& local) -> Vector3 {
            return at.frame * Vector3(local[0], local[1], local[2]);
        };
        if (positions) to.positions[v] = to_vec4(at.position + turned(bond.offset), 1);
        const Vector3 normal = turned(bond.normal);
        if (normals) to.normals[v] = to_vec4(normal, 0);
        if (!tangents) continue;
        const Vector3 way = bond.tangent[0] * at.first_side + bond.tangent[1] * at.second_side;
        to.tangents[v] = to_vec4(tangent_to(normal, way, at.frame.col(0)), bond.handedness);
    }
}

}  // namespace weft
