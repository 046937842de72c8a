// Colliders' cores as bodies whose way is given: features of cloth meet them as they meet one another, and
// give way alone.

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/frame/feature_contact.h"
#include "collision/contact/contours.h"

namespace weft {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Around finite points.
struct PointBox {
    Vector3 lower = Vector3::Constant(infinity), upper = -lower;

    void add(const Vector3& point) {
        if (!point.allFinite()) return;
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    [[nodiscard]] bool is_clear_of(const PointBox& other, float reach) const {
        return (lower.array() - reach > other.upper.array()).any() ||
               (upper.array() + reach < other.lower.array()).any();
    }
};

}  // namespace

/// Bodies as large as any core.
void FeatureContact::reserve_cores(std::size_t particles) {
    const ContactMesh& mesh = largest_core();
    const std::uint32_t each = whole_groups(mesh.particles());
    for (std::uint32_t k = 0; k < room_for_cores_; ++k)
        bodies_.push_back({.mesh = &mesh,
                           .first = static_cast<std::uint32_t>(particles) + k * each,
                           .reach = 0,
                           .is_given = true});
    given_ = AlignedBuffer<Vec4>(each * room_for_cores_);
    core_radii_ = AlignedBuffer<float>(given_.size());
}

void FeatureContact::add_cores(const MetColliders& colliders) {
    float edge = 0, thickness = 0;
    for (const ContactCloth& cloth : cloths_) {
        edge = std::max(edge, cloth.edge);
        thickness = std::max(thickness, cloth.thickness);
    }
    PointBox around;
    bool is_known = false;
    for (const ColliderMotion& motion : colliders.motions) {
        const ContactMesh* const mesh = core_of(motion.end, edge);
        if (mesh == nullptr || cores_.size() == room_for_cores_) continue;
        if (!is_known)
            for (const ParticleRange& range : island().particles)
                for (const Vec4& x : start_.span().subspan(range.first, range.count)) around.add(xyz(x));
        is_known = true;
        add_core(motion, *mesh, colliders.h);
        const Core& core = cores_.back();
        PointBox its;
        const ParticleRange range = ranges_.back();
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            its.add(xyz(start_[i]));
            its.add(xyz(start_[i]) + xyz(displacements_[i]));
        }
        if (!its.is_clear_of(around, core.radius + thickness + colliders.margin)) continue;
        cores_.pop_back();
        bodies_.pop_back();
        ranges_.pop_back();
    }
}

void FeatureContact::add_core(const ColliderMotion& motion, const ContactMesh& mesh, float h) {
    const std::uint32_t first = ranges_.back().first + whole_groups(ranges_.back().count);
    const std::span<Vec4> start = start_.span().subspan(first, mesh.particles());
    const std::span<Vec4> way = displacements_.span().subspan(first, mesh.particles());
    if (cores_.empty()) first_given_ = first;
    const bool jumped = has_jumped(motion, h);
    place_core(jumped ? motion.end : motion.start, start);
    place_core(motion.end, way);
    Core core{.motion = jumped ? CommonMotion{} : motion_of_core(motion),
              .friction = motion.end.friction,
              .way = 0,
              .radius = 0};
    for (std::uint32_t k = 0; k < mesh.particles(); ++k) {
        const std::uint32_t i = first - first_given_ + k;
        core_radii_[i] = way[k].w;
        way[k] = to_vec4(xyz(way[k]) - xyz(start[k]), 0);
        given_[i] = to_vec4(xyz(way[k]) / h, 0);
        start[k].w = 0;
        core.way = std::max(core.way, xyz(way[k]).norm());
        core.radius = std::max(core.radius, core_radii_[i]);
    }
    cores_.push_back(core);
    bodies_.push_back({.mesh = &mesh, .first = first, .reach = 0, .is_given = true});
    ranges_.push_back({first, mesh.particles()});
}

void FeatureContact::set_base_of_cores(float gamma) {
    for (const ParticleRange& range : island().given)
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const Vector3 end = xyz(start_[i]) + xyz(displacements_[i]);
            base_[i] = to_vec4(end - gamma * xyz(given_[i - first_given_]), 0);
        }
}

/// The ball about the core is the collider, outside of which thickness counts.
FeatureContact::CoreLaw FeatureContact::law_with_core(const FeaturePair& pair, const PairShape& shape,
                                                      std::size_t cloth, std::size_t core) const {
    float ball = 0;
    for (std::uint32_t c = 0; c < 4; ++c)
        if (pair.corners[c] >= first_given_)
            ball += std::abs(shape.weight(c)) * core_radii_[pair.corners[c] - first_given_];
    const float thickness = cloths_[cloth].thickness;
    const float gap = std::min(shape.normal.w - ball, thickness);
    const float radius = gap + parted_in_a_step * (thickness - gap);
    return {{.radius = ball + radius,
             .friction = cloths_[cloth].collider_friction * cores_[core - cloths_.size()].friction},
            ball + std::min(radius, projected_gap * radius)};
}

const FeatureContact::Core* FeatureContact::fastest_core(bool passing) const {
    const Core* fastest = nullptr;
    if (cores_.empty()) return fastest;
    for (std::uint32_t k = 0; k < pairs_.size; ++k) {
        const auto& corners = pairs_.pairs[k].corners;
        const std::uint32_t last = std::max(corners[0], corners[3]);
        if (last < first_given_ || (passing && !settler_.has_passed(k))) continue;
        const Core& core = cores_[body_of(bodies_, last) - cloths_.size()];
        if (fastest == nullptr || core.way > fastest->way) fastest = &core;
    }
    return fastest;
}

// With a core's own motion for the common one, what is cut to nothing goes along with it, and is not passed.
// In that motion more is near than in the cloth's own, and there may be no room for it.
bool FeatureContact::carry_with_core(Parallel& parallel, const Core* core) {
    if (core == nullptr) return false;
    settler_.split_by(parallel, core->motion, island(), displacements_.span());
    find(parallel, settler_.relative(), {&ContactCloth::floor});
    return !pairs_.overflowed;
}

// Most is kept clear of slow cores by the equation; of fast ones little. Where there is no room for what is
// near in a core's motion, the core passes.
SettleResult FeatureContact::settle_clear_of_cores(Parallel& parallel, const Island& island,
                                                   const TruncationSettings& settings) {
    const auto settle = [&](bool may_refuse) {
        return settler_.settle(parallel, island, pairs_, find_exempt(parallel), settings,
                               displacements_.span(), may_refuse);
    };
    float thickness = 0;
    for (const ContactCloth& cloth : cloths_) thickness = std::max(thickness, cloth.thickness);
    const Core* const fastest = fastest_core(false);
    const bool is_fast = fastest != nullptr && fastest->way > fastest->radius + thickness;
    if (is_fast && carry_with_core(parallel, fastest)) return settle(false);
    if (is_fast) has_all_near_ = false;
    find_for_cut(parallel);
    const SettleResult result = settle(!is_fast);
    if (!result.refused) return result;
    if (!carry_with_core(parallel, fastest_core(true))) find_for_cut(parallel);
    return settle(false);
}

// A pair with cloth has at least half of it, and at a border the part of that.
void FeatureContact::set_reach_of_cores(const Reach& reach) {
    float beyond = 0;
    for (const ContactCloth& cloth : cloths_)
        beyond = std::max(beyond, reach.is_for_cut ? cloth.floor : cloth.thickness);
    for (std::size_t k = 0; k < cores_.size(); ++k)
        bodies_[cloths_.size() + k].reach = 2 / reach.of_borders * (cores_[k].radius + beyond);
}

/// By how much pairs of the particle were searched farther off than a cut has to know them [m].
float FeatureContact::spare_reach(std::uint32_t particle) const {
    const std::size_t body = body_of(bodies_, particle);
    float least = std::numeric_limits<float>::infinity();
    for (const ContactCloth& cloth : cloths_) {
        if (!is_core(body) && &cloth != &cloths_[body]) continue;
        least = std::min(least, of_borders * cloth.radius - greatest_floor());
        if (!cores_.empty())
            least = std::min(least, 0.5f * of_borders * cloth.radius + cloth.thickness - greatest_floor());
    }
    return least;
}

float FeatureContact::greatest_floor() const {
    float floor = 0;
    for (const ContactCloth& cloth : cloths_) floor = std::max(floor, cloth.floor);
    return floor;
}

/// Of the farthest pairs that a cut has to know, whatever their bodies.
float FeatureContact::reach_for_cut() const {
    float ball = 0;
    for (const Core& core : cores_) ball = std::max(ball, core.radius);
    return greatest_floor() + ball;
}

}  // namespace weft
