// The World's calls that ask where its cloths are.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "cloth/surface/queries.h"
#include "engine/bounds.h"
#include "engine/error_text.h"

namespace weft {

namespace {

TriangleList triangles_of(const Cloth& cloth) {
    return {cloth.state.positions.span(), cloth.model.triangles.span()};
}
Bounds box_of_triangles(const Cloth& cloth) {
    return {cloth.extent.lower, cloth.extent.upper};
}

ClothPoint cloth_point(ClothId id, const TriangleList& of, const PlaceOnTriangle& place) {
    const auto x = of.corners(place.triangle);
    const Vector3 &w = place.weights, across = (x[1] - x[0]).cross(x[2] - x[0]);
    return {.cloth = id,
            .triangle = place.triangle,
            .weights = to_vec3(w),
            .position = to_vec3(Vector3(w.x() * x[0] + w.y() * x[1] + w.z() * x[2])),
            .normal = to_vec3(Vector3(across.stableNormalized())),
            .distance = static_cast<float>(place.distance)};
}

Result<void> validate_length(const char* name, float length) {
    if (length >= 0) return {};
    return out_of_range(name, static_cast<double>(length), "a number from 0, or infinity");
}

/// Calls visit(id, cloth) for cloth `only`, or for all if it is null; none of those that are disabled. Error:
/// `only` is stale.
template <class Visit>
Result<void> for_cloths(const Simulation& simulation, ClothId only, const Visit& visit) {
    if (!(only == ClothId{}))
        return with_cloth(simulation, only, [&](const Cloth& cloth) -> Result<void> {
            if (cloth.settings.enabled) visit(only, cloth);
            return {};
        });
    simulation.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& cloth) {
        if (cloth->settings.enabled) visit(id, *cloth);
    });
    return {};
}

/// Calls visit(id, place) for the nearest place of each triangle within `radius` of the point; visit returns
/// the radius for those that follow.
template <class Visit>
Result<void> for_near_triangles(const Simulation& simulation, ClothId only, const Vector3& point,
                                double radius, const Visit& visit) {
    return for_cloths(simulation, only, [&](ClothId id, const Cloth& cloth) {
        const TriangleList list = triangles_of(cloth);
        const Bounds box = box_of_triangles(cloth);
        const Eigen::AlignedBox3f around(to_vector(box.lower), to_vector(box.upper));
        if (static_cast<double>(around.exteriorDistance(point)) * (1 - 1e-6) > radius) return;
        for (std::uint32_t t = 0; t < list.triangles.size(); ++t) {
            const PlaceOnTriangle place = nearest_place(point, list, t);
            if (place.distance <= radius) radius = visit(id, list, place);
        }
    });
}

}  // namespace

Result<std::optional<ClothPoint>> World::cast_ray(const Vec3& from, const Vec3& direction, float reach,
                                                  ClothId only) const {
    using Found = std::optional<ClothPoint>;
    return impl_->read("cast_ray", [&]() -> Result<Found> {
        if (auto valid = validate_point("from", from); !valid) return valid.error();
        const Eigen::Vector3d way = to_vector(direction).cast<double>();
        if (!(way.norm() > 0) || !std::isfinite(way.norm()))
            return out_of_range("direction", direction, "finite and not 0");
        if (auto valid = validate_length("reach", reach); !valid) return valid.error();
        const Ray ray{to_vector(from).cast<double>(), way.normalized()};
        double within = static_cast<double>(reach);
        Found first;
        auto asked = for_cloths(impl_->simulation, only, [&](ClothId id, const Cloth& cloth) {
            if (!may_hit(ray, box_of_triangles(cloth), within)) return;
            const TriangleList list = triangles_of(cloth);
            const auto hit = first_hit(ray, list, within);
            if (!hit || (first && !(hit->distance < within))) return;
            within = hit->distance;
            first = cloth_point(id, list, *hit);
        });
        if (!asked) return asked.error();
        return first;
    });
}

Result<std::optional<ClothPoint>> World::closest_point(const Vec3& to, float within, ClothId only) const {
    using Found = std::optional<ClothPoint>;
    return impl_->read("closest_point", [&]() -> Result<Found> {
        if (auto valid = validate_point("to", to); !valid) return valid.error();
        if (auto valid = validate_length("within", within); !valid) return valid.error();
        Found nearest;
        double least = std::numeric_limits<double>::infinity();
        auto asked =
            for_near_triangles(impl_->simulation, only, to_vector(to), static_cast<double>(within),
                               [&](ClothId id, const TriangleList& list, const PlaceOnTriangle& place) {
                                   if (place.distance < least) nearest = cloth_point(id, list, place);
                                   return least = std::min(least, place.distance);
                               });
        if (!asked) return asked.error();
        return nearest;
    });
}

Result<std::size_t> World::triangles_in_ball(const Vec3& center, float radius, std::span<ClothPoint> to,
                                             ClothId only) const {
    return impl_->read("triangles_in_ball", [&]() -> Result<std::size_t> {
        if (auto valid = validate_point("center", center); !valid) return valid.error();
        if (auto valid = validate_length("radius", radius); !valid) return valid.error();
        std::size_t count = 0;
        const auto all = static_cast<double>(radius);
        auto asked =
            for_near_triangles(impl_->simulation, only, to_vector(center), all,
                               [&](ClothId id, const TriangleList& list, const PlaceOnTriangle& place) {
                                   if (count < to.size()) to[count] = cloth_point(id, list, place);
                                   ++count;
                                   return all;
                               });
        if (!asked) return asked.error();
        return count;
    });
}

Result<FillingInfo> World::filling_info(ClothId id) const {
    return impl_->read("filling_info", [&] {
        return with_cloth(impl_->simulation, id,
                          [](const Cloth& cloth) { return Result<FillingInfo>(cloth.filling_info()); });
    });
}

}  // namespace weft
