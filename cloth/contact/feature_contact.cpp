#include "cloth/contact/feature_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "collision/geometry/surfaces.h"

namespace weft {

namespace {

// Fraction of the missing gap by which features that start nearer than the radius are pushed apart. The push
// becomes velocity, so the whole of it at once would make them bounce.
constexpr float parted_in_a_step = 0.2f;

// Room for crossings: one a particle, and at least so many.
constexpr std::size_t least_crossings = 1024;

std::size_t room_for_crossings(std::size_t particles) {
    return std::max(least_crossings, particles);
}

bool is_within(const Vector3& point, const Bounds& box) {
    const Vector3 lower = to_vector(box.lower), upper = to_vector(box.upper);
    return (point.array() >= lower.array()).all() && (point.array() <= upper.array()).all();
}

/// The largest fraction of `way` that ends in the box. Precondition: the start is in it.
float part_within(const Bounds& box, const Vector3& start, const Vector3& way) {
    const Vector3 lower = to_vector(box.lower), upper = to_vector(box.upper);
    float part = 1;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const float end = start[k] + way[k];
        if (end > upper[k]) part = std::min(part, (upper[k] - start[k]) / way[k]);
        if (end < lower[k]) part = std::min(part, (lower[k] - start[k]) / way[k]);
    }
    return std::max(part, 0.0f);
}

}  // namespace

void FeatureContact::lay_out(Scratch& scratch, std::span<const ContactCloth> bodies, ImpactZones* zones) {
    cloths_ = bodies;
    zones_ = zones;
    uses_zones_ = std::ranges::all_of(bodies, &ContactCloth::by_zones);
    std::size_t particles = 0;
    for (const ContactCloth& body : bodies) particles += particles_of(*body.mesh);
    const std::size_t pairs = room_for_pairs(particles), crossings = room_for_crossings(particles);
    scratch.take(bodies_, bodies.size());
    scratch.take(ranges_, bodies.size());
    scratch.take(restitutions_, bodies.size());
    for (auto* array : {&start_, &displacements_, &base_, &searched_}) scratch.take(*array, particles);
    finder_.lay_out_boxes(scratch, bodies);
    pairs_.lay_out(scratch, pairs);
    narrowing_.lay_out(scratch, pairs);
    crossings_.lay_out(scratch, crossings);
    tangles_.lay_out(
        scratch, {.bodies = bodies.size(), .particles = particles, .pairs = pairs, .crossings = crossings});
    scratch.take(memory_, particles);
    scratch.take(exempt_, pairs);
    scratch.take(laws_, pairs);
    scratch.take(wanted_, pairs);
    scratch.take(nearest_faces_, particles);
    const std::size_t blocks = block_count(static_cast<std::uint32_t>(particles)) + bodies.size();
    scratch.take(partials_, blocks);
    scratch.take(changes_, blocks);
    scratch.take(marks_, particles);
    scratch.take(colliding_, uses_zones_ ? pairs : 0);
    const PairRows::Room rows{particles, pairs, room_for_rows(particles)};
    rows_.lay_out_rows(scratch, rows);
    settler_.lay_out_split(scratch, particles, bodies.size());
    scratch.take_by_turns(
        [&] {
            rows_.lay_out_solve(scratch, rows);
            rows_.untangling().lay_out(scratch, crossings);
        },
        [&] {
            scratch.take_by_turns([&] { settler_.lay_out_cut(scratch, particles, bodies.size(), pairs); },
                                  [&] { finder_.lay_out_pool(scratch, pairs); });
        });
    if (scratch.has_memory()) number_bodies();
}

/// Numbers the bodies' particles, and zeroes the padding behind each body, which kernels read.
void FeatureContact::number_bodies() {
    std::uint32_t first = 0;
    for (std::size_t k = 0; k < cloths_.size(); ++k) {
        const ContactCloth& body = cloths_[k];
        const std::uint32_t count = body.mesh->particles(), end = first + particles_of(*body.mesh);
        bodies_[k] = {
            .mesh = body.mesh, .first = first, .reach = body.radius, .layer = body.layer, .mask = body.mask};
        ranges_[k] = {first, count};
        restitutions_[k] = body.restitution;
        for (auto* array : {&start_, &displacements_, &base_, &searched_})
            std::ranges::fill(array->span().subspan(first + count, end - first - count), Vec4{});
        first = end;
    }
}

/// Clears the tangle memory, unless some body has recalled its own.
void FeatureContact::remember_nothing() {
    if (!std::exchange(may_cross_, true)) std::ranges::fill(memory_.span(), TangleMemory{});
}

void FeatureContact::place(Parallel& parallel, std::size_t body, std::span<const Vec4> positions,
                           const ExpectedMotion& expected) {
    const std::uint32_t first = bodies_[body].first;
    h_ = expected.h;
    is_pinned_ |= std::ranges::any_of(positions, [](const Vec4& x) { return x.w == 0; });
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            start_[first + i] = positions[i];
            displacements_[first + i] = to_vec4(expected.h * xyz(expected.velocities[i]), 0);
        }
    });
}

void FeatureContact::recall(std::size_t body, std::span<const TangleMemory> memory) {
    remember_nothing();
    std::ranges::copy(memory, memory_.data() + bodies_[body].first);
}

std::span<const TangleMemory> FeatureContact::memory(std::size_t body) {
    remember_nothing();
    return memory_.span().subspan(bodies_[body].first, bodies_[body].mesh->particles());
}

void FeatureContact::find_tangles(Parallel& parallel) {
    finder_.find_crossings(parallel, bodies_.span(), start_.span(), crossings_);
    tangles_.find({bodies_.span(), start_.span(), pairs_, h_}, crossings_, memory_.span());
}

/// Marks the pairs of the list that contact leaves alone; empty: none.
std::span<const std::uint8_t> FeatureContact::find_exempt(Parallel& parallel) {
    if (!tangles_.any()) return {};
    tangles_.exempt(parallel, pairs_, exempt_.span());
    return exempt_.span();
}

// Lists are ascending: their first and last entries reject most pairs, which are far apart along the cloth.
bool FeatureContact::are_near_at_rest(const FeaturePair& pair, std::uint32_t corners_of_a) const {
    const std::size_t body = bodies_.size() == 1 ? 0 : body_of(bodies_.span(), pair.corners[0]);
    const std::uint32_t first = bodies_[body].first;
    const RestFilter& near = cloths_[body].near_at_rest;
    if (near.offsets.empty()) return false;
    const std::span<const std::uint32_t> of_b = std::span(pair.corners).subspan(corners_of_a);
    const auto [least, most] = std::ranges::minmax(of_b);
    for (std::uint32_t a = 0; a < corners_of_a; ++a) {
        const std::uint32_t i = pair.corners[a] - first, begin = near.offsets[i], end = near.offsets[i + 1];
        if (begin == end || most - first < near.neighbours[begin] || least - first > near.neighbours[end - 1])
            continue;
        for (const std::uint32_t b : of_b)
            if (near.leaves_alone(i, b - first)) return true;
    }
    return false;
}

// A pair of edges whose closest point is an end of one gets no force: a vertex and a triangle are as near
// there, and have it.
void FeatureContact::make_laws(Parallel& parallel) {
    const bool is_alone = bodies_.size() == 1;
    const std::span<const std::uint8_t> exempt = find_exempt(parallel);
    parallel.ranges(pairs_.size, [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
            const FeaturePair& pair = pairs_.pairs[k];
            const bool is_at_border = pairs_.shapes[k].is_at_border();
            const std::uint32_t of_a = pairs_.corners_of_a(k);
            const std::size_t a = is_alone ? 0 : body_of(bodies_.span(), pair.corners[0]);
            const std::size_t b = is_alone ? 0 : body_of(bodies_.span(), pair.corners[3]);
            const bool is_left_alone = (of_a == 2 && is_at_border) || (!exempt.empty() && exempt[k] != 0) ||
                                       !(pairs_.shapes[k].normal.w > 0);
            const bool are_neighbours = !is_left_alone && a == b && are_near_at_rest(pair, of_a);
            const float radius = 0.5f * (cloths_[a].radius + cloths_[b].radius) *
                                 (is_at_border ? of_borders : 1) * (are_neighbours ? of_neighbours : 1);
            const float gap = std::min(pairs_.shapes[k].normal.w, radius);
            laws_[k] = {.radius = is_left_alone ? 0 : gap + parted_in_a_step * (radius - gap),
                        .friction = a == b ? cloths_[a].friction
                                           : friction_between(cloths_[a].friction, cloths_[b].friction)};
            wanted_[k] = std::max(projected_gap * laws_[k].radius,
                                  kept_floors * std::max(cloths_[a].floor, cloths_[b].floor));
        }
    });
    if (pairs_.size == 0) return;  // calm cloth costs nothing
    find_nearest_faces();
    leave_to_faces(parallel);
}

// A vertex between two layers is over a face of each.
void FeatureContact::find_nearest_faces() {
    const std::span<const PairShape> shapes = std::as_const(pairs_.shapes).span();
    const auto take_nearer = [&](std::uint32_t& nearest, std::uint32_t k) {
        if (nearest == NearestFaces::none || shapes[k].normal.w < shapes[nearest].normal.w) nearest = k;
    };
    std::ranges::fill(nearest_faces_.span(), NearestFaces{});
    const auto for_each_face = [&](const auto& visit) {
        for (std::uint32_t k = 0; k < pairs_.vertex_triangle; ++k)
            if (laws_[k].radius > 0 && !shapes[k].is_at_border())
                visit(k, nearest_faces_[pairs_.pairs[k].corners[0]]);
    };
    for_each_face([&](std::uint32_t k, NearestFaces& of) { take_nearer(of.nearest, k); });
    for_each_face([&](std::uint32_t k, NearestFaces& of) {
        if (xyz(shapes[k].normal).dot(xyz(shapes[of.nearest].normal)) < 0) take_nearer(of.behind, k);
    });
}

// Where layers are pressed together, a vertex is near the borders of the face below it, too. These pairs
// would push it sideways, and stop cloth that lands and slides; so they get no force. Nor do edges whose four
// ends have faces about as near on the same side: these hold the layers apart, and edges where ridges cross
// have none. All are projected like others, since squeezed layers would get stuck on one another otherwise.
void FeatureContact::leave_to_faces(Parallel& parallel) {
    constexpr float leans = 0.95f;                 // cosine of the angle between the two normals
    constexpr float alike = 0.7f, as_near = 0.1f;  // the same, of sides; farther than the edges [radii]
    const std::span<const PairShape> shapes = std::as_const(pairs_.shapes).span();
    const auto distance = [&](std::uint32_t k) {
        Vector3 apart = Vector3::Zero();
        for (std::uint32_t c = 0; c < 4; ++c)
            apart += shapes[k].weight(c) * xyz(start_[pairs_.pairs[k].corners[c]]);
        return apart.norm();
    };
    const auto is_border_of_face = [&](std::uint32_t k) {
        const std::uint32_t face = nearest_faces_[pairs_.pairs[k].corners[0]].nearest;
        if (face == NearestFaces::none || !shapes[k].is_at_border()) return false;
        const float along = xyz(shapes[face].normal).dot(xyz(shapes[k].normal));
        return along > 0 && along < leans && shapes[face].normal.w <= distance(k);
    };
    const auto have_faces_as_near = [&](std::uint32_t k) {
        const float farthest = shapes[k].normal.w + as_near * laws_[k].radius;
        const auto stands_for = [&](std::uint32_t face, float side) {
            return face != NearestFaces::none && shapes[face].normal.w <= farthest &&
                   side * xyz(shapes[face].normal).dot(xyz(shapes[k].normal)) > alike;
        };
        for (std::uint32_t c = 0; c < 4; ++c) {
            const NearestFaces& of = nearest_faces_[pairs_.pairs[k].corners[c]];
            const float side = c < 2 ? 1.0f : -1.0f;
            if (!stands_for(of.nearest, side) && !stands_for(of.behind, side)) return false;
        }
        return true;
    };
    const auto is_left = [&](std::uint32_t k) {
        return k < pairs_.vertex_triangle ? is_border_of_face(k) : have_faces_as_near(k);
    };
    parallel.ranges(pairs_.size, [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin; k < range.end; ++k)
            if (laws_[k].radius > 0 && is_left(k)) laws_[k].radius = 0;
    });
}

void FeatureContact::set_base(Parallel& parallel, std::size_t body, std::span<const Vec4> base_positions) {
    const std::uint32_t first = bodies_[body].first;
    parallel.ranges(static_cast<std::uint32_t>(base_positions.size()), [&](const BlockRange& range) {
        std::copy(base_positions.data() + range.begin, base_positions.data() + range.end,
                  base_.data() + first + range.begin);
    });
}

void FeatureContact::set_fixed_base(Parallel& parallel, std::size_t body, std::span<const Vec4> positions) {
    set_base(parallel, body, positions);
    const std::uint32_t first = bodies_[body].first;
    for (std::size_t i = 0; i < positions.size(); ++i) base_[first + i].w = 0;
}

void FeatureContact::make_rows(Parallel& parallel, float gamma) {
    rows_.untangling().begin(tangles_.rows(), base_.span(), gamma);
    rows_.begin(parallel, pairs_, laws_.span(), base_.span(), gamma);
}

void FeatureContact::arrive(Parallel& parallel, std::size_t body, std::span<const Vec4> positions) {
    const std::uint32_t first = bodies_[body].first;
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            displacements_[first + i] = to_vec4(xyz(positions[i]) - xyz(start_[first + i]), 0);
    });
}

void FeatureContact::project(Parallel& parallel) {
    near_ = {.pairs = pairs_.size, .tangles = tangles_.counts(), .overflowed = pairs_.overflowed};
    const std::span<const std::uint8_t> exempt =
        tangles_.any() ? std::as_const(exempt_).span() : std::span<const std::uint8_t>();
    settler_.project(parallel, group(), pairs_, exempt, {.each = wanted_.span()}, projections,
                     displacements_.span());
}

bool FeatureContact::leaves(Parallel& parallel, std::size_t body, const Bounds& box) {
    const std::span<const Vec4> start = starts(body), way = displacements(body);
    const auto find_block = [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            if (!is_within(xyz(start[i]) + xyz(way[i]), box)) return 1.0f;
        return 0.0f;
    };
    return parallel.reduce(ranges_[body].count, partials_.span(), 0.0f, find_block,
                           [](float a, float b) { return std::max(a, b); }) > 0;
}

void FeatureContact::keep_within(Parallel& parallel, std::size_t body, const Bounds& box) {
    const std::span<const Vec4> start = starts(body);
    const std::span<Vec4> way = displacements_.span().subspan(ranges_[body].first, ranges_[body].count);
    parallel.ranges(ranges_[body].count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            set_xyz(way[i], part_within(box, xyz(start[i]), xyz(way[i])) * xyz(way[i]));
    });
}

bool FeatureContact::crosses_anew(Parallel& parallel) {
    if (may_cross_ || is_uncertain_) return false;
    for_ranges(parallel, ranges_.span(), [&](const BlockRange& range) {  // the bases are of no more use
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            set_xyz(base_[i], xyz(start_[i]) + xyz(displacements_[i]));
    });
    return any_crosses(parallel, base_.span());
}

bool FeatureContact::any_crosses(Parallel& parallel, std::span<const Vec4> positions) {
    finder_.find_crossings(parallel, bodies_.span(), positions, crossings_);
    return crossings_.size > 0;
}

void FeatureContact::hand_back(Parallel& parallel, std::size_t body, float h, std::span<Vec4> positions,
                               std::span<Vec4> velocities) const {
    const std::uint32_t first = bodies_[body].first;
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 wanted = xyz(positions[i]) - xyz(start_[first + i]);
            const Vector3 change = xyz(displacements_[first + i]) - wanted;
            if (change.isZero(0)) continue;
            set_xyz(positions[i], xyz(start_[first + i]) + xyz(displacements_[first + i]));
            set_xyz(velocities[i], xyz(velocities[i]) + change / h);
        }
    });
}

}  // namespace weft
