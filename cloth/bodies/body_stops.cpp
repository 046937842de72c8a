// Bodies against particles that do not give way: pinned ones, and those that a body presses onto a collider.
// Their motion is given, and the body meets them as obstacles.

#include <algorithm>
#include <array>

#include "cloth/equation/contacts.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

namespace {

// Stiffness of a stop over the body's effective mass at its point. n stops that bear a body yield by the n-th
// part of a step's free fall.
constexpr double stop_per_mass = 1;

Vector3 point(const BlockLanes& points, std::uint32_t k) {
    return {points.x[k], points.y[k], points.z[k]};
}

}  // namespace

void Contacts::carry(std::span<const MovingBody> bodies, std::span<const Attachment> attached,
                     std::span<const float> areas, BodyBuffers& buffers) {
    bodies_ = bodies;
    attached_ = attached;
    areas_ = areas;
    body_buffers_ = &buffers;
    buffers.pushes.clear();
    buffers.stops.clear();
    const auto gives_way = [&](const ColliderMotion& motion) {
        return motion.body >= 0 && bodies[static_cast<std::size_t>(motion.body)].gives_way();
    };
    firm_ = static_cast<std::size_t>(std::ranges::find_if(colliders_, gives_way) - colliders_.begin());
}

// A particle has one row: between a body and a collider that faces the body it is the collider's.
void Contacts::find_squeezed(const StepEquation& equation, std::span<const Vec4> velocities,
                             const BlockRange& range, NearSurfaces& near,
                             std::span<std::int32_t> pressed) const {
    if (firm_ == 0 || firm_ == colliders_.size()) return;
    const std::uint32_t size = range.end - range.begin;
    const auto find = [&](std::span<const ColliderMotion> colliders, NearSurfaces& found) {
        return find_near_surfaces(colliders, side_.part(range.begin, size), equation.h, reach,
                                  equation.positions.subspan(range.begin, size),
                                  equation.base_positions.subspan(range.begin, size), equation.gamma,
                                  velocities.subspan(range.begin, size), found);
    };
    NearSurfaces firm, giving_way;
    if (!find(colliders_.subspan(firm_), giving_way) || !find(colliders_.first(firm_), firm)) return;
    for (std::uint32_t k = 0; k < size; ++k) {
        if (!(equation.positions[range.begin + k].w > 0)) continue;
        if (!(firm.surfaces.w[k] < reach && giving_way.surfaces.w[k] < reach)) continue;
        if (!(point(firm.surfaces, k).dot(point(giving_way.surfaces, k)) < 0)) continue;
        for (const auto lane : {&BlockLanes::x, &BlockLanes::y, &BlockLanes::z, &BlockLanes::w}) {
            (near.surfaces.*lane)[k] = (firm.surfaces.*lane)[k];
            (near.motions.*lane)[k] = (firm.motions.*lane)[k];
        }
        pressed[k] = BodyBuffers::squeezed;
    }
}

void Contacts::find_stops(const StepEquation& equation, std::span<const Vec4> velocities) {
    body_buffers_->stops.clear();
    const std::span<const ColliderMotion> giving_way = colliders_.subspan(firm_);
    if (giving_way.empty()) return;
    const auto does_not_give_way = [&](std::uint32_t i) {
        return equation.positions[i].w > 0 ? body_buffers_->pressed[i] == BodyBuffers::squeezed
                                           : areas_[i] > 0;
    };
    const auto particles = static_cast<std::uint32_t>(velocities.size());
    for (std::uint32_t begin = 0; begin < particles; begin += block_size) {
        const std::uint32_t size = std::min(block_size, particles - begin);
        bool any = false;
        for (std::uint32_t k = 0; k < size && !any; ++k) any = does_not_give_way(begin + k);
        if (!any) continue;
        NearSurfaces near;
        std::array<std::int32_t, block_size> bodies;
        if (!find_near_surfaces(giving_way, side_.part(begin, size), equation.h, 0,
                                equation.positions.subspan(begin, size),
                                equation.base_positions.subspan(begin, size), equation.gamma,
                                velocities.subspan(begin, size), near, std::span(bodies).first(size)))
            continue;
        for (std::uint32_t k = 0; k < size; ++k)
            if (does_not_give_way(begin + k) && bodies[k] >= 0 && near.surfaces.w[k] < 0)
                add_stop(equation, near, k, xyz(velocities[begin + k]),
                         static_cast<std::uint32_t>(bodies[k]));
    }
}

/// Adds a spring along the contact normal and a damper across it, which is limited by Coulomb's law.
void Contacts::add_stop(const StepEquation& equation, const NearSurfaces& near, std::uint32_t k,
                        const Vector3& velocity, std::uint32_t number) {
    const MovingBody& body = bodies_[number];
    const Eigen::Vector3d normal = point(near.surfaces, k).cast<double>();
    const Vector3 place = point(near.points, k), arm = place - body.end.position;
    const double inverse_mass =
        (body.root.transpose() * wrench(arm.cast<double>(), normal)).squaredNorm();  // of its point, along n
    if (!(inverse_mass > 0) || !normal.allFinite()) return;
    const double spring = stop_per_mass / inverse_mass;
    const double pressed =
        spring / static_cast<double>(equation.gamma) * -static_cast<double>(near.surfaces.w[k]);
    const Vector3 of_point = body.velocity_at(place);
    const Eigen::Vector3d relative = (velocity - of_point).cast<double>();
    const Eigen::Vector3d sliding = relative - relative.dot(normal) * normal;
    const double limit = static_cast<double>(near.motions.w[k]) * pressed, speed = sliding.norm();
    const double damper = limit < spring * speed ? limit / speed : spring;
    const Eigen::Matrix3d g =
        damper * Eigen::Matrix3d::Identity() + (spring - damper) * normal * normal.transpose();
    const auto entry = [&](int row, int column) { return static_cast<float>(g(row, column)); };
    body_buffers_->stops.push_back(
        {.body = number,
         .arm = arm,
         .velocity = of_point,
         .impulse = (pressed * normal - damper * sliding).cast<float>(),
         .response = {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)}});
}

}  // namespace weft
