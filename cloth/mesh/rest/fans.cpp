#include "cloth/mesh/rest/fans.h"

#include <algorithm>
#include <utility>

namespace weft {

namespace {

/// A corner is one triangle at a particle.
struct Corner {
    struct Side {
        std::uint32_t hinge, particle;  ///< no_hinge at a border; the side's other end
        double length;                  ///< [m]
    };
    Side forth, back;  ///< the sides that begin and end at the particle, as the triangle is wound
    double angle, area;
    bool is_used = false;
};

class FanFinder {
  public:
    FanFinder(const ClothModel& model, const Bending& bending) : model_(model), bending_(bending) {}

    Fans operator()() {
        fans_.list.reserve(model_.particle_count);
        fans_.ends.resize(bending_.hinges.size());
        for (std::uint32_t i = 0; i < model_.particle_count; ++i) find_fans(i);
        return std::move(fans_);
    }

  private:
    void find_fans(std::uint32_t particle);
    void list_corners(std::uint32_t particle);
    void walk(std::uint32_t particle, std::size_t first, bool is_closed);
    void meet(std::uint32_t hinge, std::uint32_t particle, double angle, bool apex_0_is_before);

    const ClothModel& model_;
    const Bending& bending_;
    Fans fans_;
    std::vector<Corner> corners_;
};

void FanFinder::list_corners(std::uint32_t particle) {
    corners_.clear();
    for (std::uint32_t c = model_.corner_offsets[particle]; c < model_.corner_offsets[particle + 1]; ++c) {
        const std::uint32_t t = model_.corner_triangles[c];
        const std::uint32_t k = corner_at(model_.triangles[t], particle);
        const RestSides sides = rest_sides(model_, t);
        const std::array<Eigen::Vector2d, 3> at{Eigen::Vector2d::Zero(), sides.to1.cast<double>(),
                                                sides.to2.cast<double>()};
        const Eigen::Vector2d forth = at[(k + 1) % 3] - at[k], back = at[(k + 2) % 3] - at[k];
        const double doubled = std::abs(forth.x() * back.y() - forth.y() * back.x());
        const Triangle& triangle = model_.triangles[t];
        const auto hinge = [&](std::uint32_t side) { return bending_.of_sides[3 * std::size_t{t} + side]; };
        corners_.push_back({.forth = {hinge(k), triangle[(k + 1) % 3], forth.norm()},
                            .back = {hinge((k + 2) % 3), triangle[(k + 2) % 3], back.norm()},
                            .angle = std::atan2(doubled, forth.dot(back)),
                            .area = doubled / 6});
    }
}

void FanFinder::find_fans(std::uint32_t particle) {
    list_corners(particle);
    for (const bool is_closed : {false, true})
        for (std::size_t c = 0; c < corners_.size(); ++c)
            if (!corners_[c].is_used && (is_closed || corners_[c].forth.hinge == Bending::no_hinge ||
                                         corners_[c].back.hinge == Bending::no_hinge))
                walk(particle, c, is_closed);
}

/// Records that the hinge's edge lies at that angle in the last fan, which is at the particle, an end of the
/// edge. `apex_0_is_before`: the hinge's first apex is in the triangle before the edge, not behind it.
void FanFinder::meet(std::uint32_t hinge, std::uint32_t particle, double angle, bool apex_0_is_before) {
    const std::uint32_t end = bending_.hinges[hinge].particles[0] == particle ? 0 : 1;
    HingeEnd& here = fans_.ends[hinge][end];
    here.fan = static_cast<std::uint32_t>(fans_.list.size()) - 1;
    here.to_fan = Turn(angle, (end == 0) == apex_0_is_before);
    fans_.list.back().ends.push_back({hinge, end});
}

/// Walks from triangle to triangle, beginning at a border if there is one.
void FanFinder::walk(std::uint32_t particle, std::size_t first, bool is_closed) {
    Fan& fan = fans_.list.emplace_back();
    fan.middle = particle;
    fan.is_closed = is_closed;
    struct Met {
        std::uint32_t hinge;
        double angle;
        bool apex_0_is_before;
    };
    std::vector<Met> met;
    const auto first_apex = [&](std::uint32_t hinge) { return bending_.hinges[hinge].particles[2]; };
    Corner* corner = &corners_[first];
    // The walk goes as the first triangle is wound, unless it begins at a border on the other side.
    Corner::Side from = is_closed || corner->forth.hinge == Bending::no_hinge ? corner->forth : corner->back;
    if (is_closed) {
        const std::uint32_t apex = corner->back.particle;
        met.push_back({from.hinge, 0, first_apex(from.hinge) != apex});
    }
    fan.around.push_back({from.particle, 0, from.length});
    while (corner != nullptr) {
        corner->is_used = true;
        fan.area += corner->area;
        fan.angle += corner->angle;
        const std::uint32_t apex = from.particle;
        from = corner->forth.particle == from.particle ? corner->back : corner->forth;
        corner = nullptr;
        for (Corner& other : corners_)
            if (from.hinge != Bending::no_hinge && !other.is_used &&
                (other.forth.hinge == from.hinge || other.back.hinge == from.hinge))
                corner = &other;
        if (is_closed && corner == nullptr) break;  // the ring is closed
        fan.around.push_back({from.particle, fan.angle, from.length});
        if (from.hinge != Bending::no_hinge)
            met.push_back({from.hinge, fan.angle, first_apex(from.hinge) == apex});
    }
    const double scale = is_closed ? 2 * std::numbers::pi / fan.angle : 1;
    for (const auto& [hinge, at, before] : met) meet(hinge, particle, scale * at, before);
    if (is_closed) return;
    const auto normal_of = [](double edge) { return Turn(edge) * Tensor(0, 1, 0); };
    if (std::abs(fan.angle - std::numbers::pi) < std::numbers::pi / 6) {
        fan.free.resize(3, 1);
        fan.free << normal_of((fan.angle - std::numbers::pi) / 2);
    } else {
        fan.free.resize(3, 2);
        fan.free << normal_of(0), normal_of(fan.angle);
    }
}

}  // namespace

Fans find_fans(const ClothModel& model, const Bending& bending) {
    return FanFinder(model, bending)();
}

}  // namespace weft
