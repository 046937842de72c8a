// Questions to a World's cloths, for C.

#include <algorithm>

#include "cloth/c/handles.h"

namespace weft::c {

namespace {

/// Hands over what was found, if anything was.
[[nodiscard]] Result<void> hand_point(const Result<std::optional<ClothPoint>>& asked, WeftClothPoint* point,
                                      WeftBool* found) {
    if (!asked) return asked.error();
    *found = asked->has_value() ? 1 : 0;
    if (*asked) *point = std::bit_cast<WeftClothPoint>(**asked);
    return {};
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_world_cast_ray(const WeftWorld* world, WeftVec3 from, WeftVec3 direction, float reach,
                               WeftClothId only, WeftClothPoint* point, WeftBool* found) {
    return on(world, {{point, "point"}, {found, "found"}}, [&](const weft::World& of) {
        return hand_point(of.cast_ray(std::bit_cast<weft::Vec3>(from), std::bit_cast<weft::Vec3>(direction),
                                      reach, std::bit_cast<weft::ClothId>(only)),
                          point, found);
    });
}
WeftResult weft_world_closest_point(const WeftWorld* world, WeftVec3 to, float within, WeftClothId only,
                                    WeftClothPoint* point, WeftBool* found) {
    return on(world, {{point, "point"}, {found, "found"}}, [&](const weft::World& of) {
        return hand_point(
            of.closest_point(std::bit_cast<weft::Vec3>(to), within, std::bit_cast<weft::ClothId>(only)),
            point, found);
    });
}
WeftResult weft_world_triangles_in_ball(const WeftWorld* world, WeftVec3 center, float radius,
                                        WeftClothId only, WeftClothPoint* to, size_t room, size_t* found) {
    return on(world, {{to, "to"}, {found, "found"}}, [&](const weft::World& of) -> weft::Result<void> {
        const std::span<weft::ClothPoint> places(reinterpret_cast<weft::ClothPoint*>(to), room);
        const auto count = of.triangles_in_ball(std::bit_cast<weft::Vec3>(center), radius, places,
                                                std::bit_cast<weft::ClothId>(only));
        if (!count) return count.error();
        *found = *count;
        return {};
    });
}
