#include "cloth/mesh/cooking/geodesics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace weft {

namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();

double square(double x) {
    return x * x;
}

// The distance of a corner from those of the opposite side's two ends, if both were reached straight from one
// source: unfolded into the triangle's plane, that source lies where the circles about the ends meet, beyond
// the side (Novotni and Klein 2002; exact on flat cloth, where Kimmel and Sethian's plane waves are not).
// Unreachable if the straight way does not lead through the side; then the ways along the other two sides are
// the shortest through the triangle.
double distance_across(const GeodesicCorner& corner, double from_begin, double from_end) {
    const double along = 0.5 * ((square(from_begin) - square(from_end)) / corner.side + corner.side);
    const double depth = std::sqrt(std::max(0.0, square(from_begin) - square(along)));
    const double crossing = along * corner.height + corner.along * depth;  // times height + depth
    if (crossing < 0 || crossing > corner.side * (corner.height + depth)) return unreachable;
    return std::sqrt(square(corner.along - along) + square(corner.height + depth));
}

const GeodesicReach* find(std::span<const GeodesicReach> reached, std::uint32_t source) {
    const auto at = std::ranges::find(reached, source, &GeodesicReach::source);
    return at == reached.end() ? nullptr : &*at;
}

}  // namespace

Geodesics::Geodesics(const ClothModel& model)
    : triangles_(model.triangles.size()), reached_(model.particle_count) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const Triangle& particles = model.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = particles[k], begin = particles[(k + 1) % 3],
                                end = particles[(k + 2) % 3];
            const double side = rest_length_between(model, begin, end);
            const double to_begin = rest_length_between(model, corner, begin),
                         to_end = rest_length_between(model, corner, end);
            const double along = 0.5 * ((square(to_begin) - square(to_end)) / side + side);
            triangles_[t][k] = {.along = along,
                                .height = std::sqrt(std::max(0.0, square(to_begin) - square(along))),
                                .side = side,
                                .is_obtuse = square(to_begin) + square(to_end) < (1 - 1e-6) * square(side)};
        }
    }
    reserve();
}

// An entry is superseded if a shorter way to its particle has been found, or if nearer groups displaced it.
bool Geodesics::is_superseded(const Front& front) const {
    const GeodesicReach* const way = find(reached_[front.particle], front.source);
    return way == nullptr || way->distance < front.distance;
}

// Each way of a particle is in the front at most once, but for superseded entries. Their removal leaves room,
// so that the front never reallocates.
void Geodesics::push(const Front& front) {
    if (front_.size() == front_.capacity()) {
        std::erase_if(front_, [&](const Front& entry) { return is_superseded(entry); });
        std::ranges::make_heap(front_, std::greater<>{}, &Front::distance);
    }
    front_.push_back(front);
    std::ranges::push_heap(front_, std::greater<>{}, &Front::distance);
}

// A particle keeps its ways in ascending order. A way that has most_reached nearer groups is dropped and not
// continued: it is not among the nearest of any particle behind either.
void Geodesics::reach(std::uint32_t particle, const GeodesicReach& way) {
    constexpr double least_gain = 1 - 1e-9;  // rounding must not keep the front alive
    Reached& reached = reached_[particle];
    auto at = std::ranges::find(reached, way.group, &GeodesicReach::group);
    if (at == reached.end()) at = reached.end() - 1;  // the furthest, or an empty one
    if (at->source != GeodesicReach::none && !(way.distance < least_gain * at->distance)) return;
    *at = way;
    for (; at != reached.begin(); --at) {
        GeodesicReach& nearer = *(at - 1);
        if (nearer.source != GeodesicReach::none && nearer.distance <= at->distance) break;
        std::swap(nearer, *at);
    }
    push({way.distance, particle, way.source});
}

// A corner of at most 90 degrees that is nearer than the front's particle is final: no front that crosses the
// triangle later gives it a shorter way.
void Geodesics::cross_triangle(const Triangle& particles, const std::array<GeodesicCorner, 3>& shape,
                               std::uint32_t from, const GeodesicReach& way) {
    const std::size_t a = particles[0] == from   ? 0
                          : particles[1] == from ? 1
                                                 : 2,
                      b = (a + 1) % 3, c = (a + 2) % 3;
    const GeodesicReach* const to_b = find(reached_[particles[b]], way.source);
    const GeodesicReach* const to_c = find(reached_[particles[c]], way.source);
    const double from_b = to_b ? to_b->distance : unreachable, from_c = to_c ? to_c->distance : unreachable;
    const auto is_open = [&](std::size_t corner, double distance) {
        return distance > way.distance || shape[corner].is_obtuse;
    };
    const auto go_to = [&](std::size_t corner, double distance) {
        reach(particles[corner], {distance, way.source, way.group});
    };
    if (is_open(b, from_b)) {
        const GeodesicCorner& corner = shape[b];
        const double along_side = way.distance + shape[c].side;
        go_to(b, to_c ? std::min(along_side, distance_across(corner, from_c, way.distance)) : along_side);
    }
    if (is_open(c, from_c)) {
        const GeodesicCorner& corner = shape[c];
        const double along_side = way.distance + shape[b].side;
        go_to(c, to_b ? std::min(along_side, distance_across(corner, way.distance, from_b)) : along_side);
    }
}

// In an obtuse triangle the front can reach the far corner before one of the other two. A particle that is
// later reached by a shorter way enters the front again, which then corrects the distances found from there.
void Geodesics::march(const ClothModel& model, std::span<const GeodesicSource> sources) noexcept {
    std::ranges::fill(reached_, Reached{});
    front_.clear();
    for (const auto& [particle, group] : sources) reach(particle, {0, particle, group});
    while (!front_.empty()) {
        std::ranges::pop_heap(front_, std::greater<>{}, &Front::distance);
        const Front nearest = front_.back();
        front_.pop_back();
        if (is_superseded(nearest)) continue;
        const std::uint32_t particle = nearest.particle;
        const GeodesicReach present = *find(reached_[particle], nearest.source);
        for (std::uint32_t k = model.corner_offsets[particle]; k < model.corner_offsets[particle + 1]; ++k) {
            const std::uint32_t triangle = model.corner_triangles[k];
            cross_triangle(model.triangles[triangle], triangles_[triangle], particle, present);
        }
    }
}

std::size_t Geodesics::bytes() const noexcept {
    return triangles_.bytes() + reached_.size() * sizeof(Reached) + front_.capacity() * sizeof(Front);
}

}  // namespace weft
