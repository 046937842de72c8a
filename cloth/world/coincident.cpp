#include "cloth/world/coincident.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "engine/memory/hooks.h"

namespace weft {

void log_coincident(const Simulation& world, const Cloth& added) {
    using Place = std::array<float, 3>;
    const auto place_of = [](const Vec4& x) { return Place{x.x, x.y, x.z}; };
    if (!added.has_features()) return;
    std::vector<Place> places;  // of the new cloth, ascending
    world.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& other) {
        if (!other->has_features() || !may_meet(added, *other) ||
            !overlap({added.extent.lower, added.extent.upper}, {other->extent.lower, other->extent.upper}))
            return;
        if (places.empty()) {
            std::ranges::transform(added.state.positions.span(), std::back_inserter(places), place_of);
            std::ranges::sort(places);
        }
        const auto count = std::ranges::count_if(other->state.positions.span(), [&](const Vec4& x) {
            return std::ranges::binary_search(places, place_of(x));
        });
        if (count > 0)
            log_line(LogLevel::note,
                     "%u particles of a new cloth lie exactly on those of cloth %u; move one of the two "
                     "before the first step, or contact lays the new one before the other's front",
                     static_cast<unsigned>(count), id.index);
    });
}

}  // namespace weft
