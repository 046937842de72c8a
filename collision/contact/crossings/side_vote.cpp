#include "collision/contact/crossings/side_vote.h"

#include <algorithm>

#include "collision/contact/crossings/surface_at.h"

namespace weft {

namespace {

Vector3 normal_of(const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b - a).cross(c - a);
}

}  // namespace

void SideVote::lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs) {
    scratch.take(starts_, particles + 1);
    scratch.take(order_, pairs);
    scratch.take(sides_, particles);
    scratch.take(members_, 2 * particles);
}

void SideVote::begin(std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                     const PairList& pairs) {
    bodies_ = bodies;
    positions_ = positions;
    pairs_ = &pairs;
    spreads_left_ = static_cast<std::uint32_t>(members_.size());
    std::ranges::fill(sides_.span(), std::uint8_t{0});
    std::ranges::fill(starts_.span(), 0u);
    for (std::uint32_t k = 0; k < pairs.vertex_triangle; ++k) ++starts_[pairs.pairs[k].corners[0]];
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_.span()) sum = start += sum;
    for (std::uint32_t k = pairs.vertex_triangle; k-- > 0;) order_[--starts_[pairs.pairs[k].corners[0]]] = k;
}

void SideVote::join(std::uint32_t particle, std::uint32_t side) {
    if (is_on(particle, side)) return;
    sides_[particle] |= static_cast<std::uint8_t>(1u << side);
    members_[member_count_++] = {particle, side};
}

/// Whether a triangle near the particle has a corner on the other side. All its corners then join that side.
bool SideVote::meets(std::uint32_t particle, std::uint32_t side) {
    bool meets = false;
    for (const std::uint32_t k : pairs_of(particle)) {
        const FeaturePair& pair = pairs_->pairs[k];
        if (!any_corner_is_on(pair, 1 - side)) continue;
        for (std::uint32_t c = 1; c < 4; ++c) join(pair.corners[c], 1 - side);
        meets = true;
    }
    return meets;
}

// The member's neighbours that are near the other surface join its side.
void SideVote::spread(const Member& member) {
    const ContactBody& body = bodies_[body_of(bodies_, member.particle)];
    for (const std::uint32_t t : body.mesh->triangles_of(member.particle - body.first))
        for (const std::uint32_t of_mesh : body.mesh->triangles()[t])
            if (const std::uint32_t i = body.first + of_mesh; meets(i, member.side)) join(i, member.side);
}

SideVote::Result SideVote::of(std::uint32_t contour, std::span<const Crossing> crossings,
                              const Contours& contours) {
    member_count_ = 0;
    contours.for_each_crossing(contour, [&](std::uint32_t k) {
        const std::uint32_t side = contours.side_of_edge(k);
        for (const std::uint32_t i : crossings[k].edge) join(i, side);
        for (const std::uint32_t i : crossings[k].triangle) join(i, 1 - side);
    });
    for (std::uint32_t k = 0; k < member_count_ && spreads_left_ > 0; ++k, --spreads_left_)
        spread(Member(members_[k]));

    std::uint32_t above = 0, below = 0;
    const std::span<const Member> members = members_.span().first(member_count_);
    for (const Member& member : members) {
        for (const std::uint32_t k : pairs_of(member.particle)) {
            const float opinion = opinion_of(member, k);
            above += opinion > 0 ? 1 : 0;
            below += opinion < 0 ? 1 : 0;
        }
    }
    for (const Member& member : members) sides_[member.particle] = 0;
    return {.side = above == below ? 0.0f : above > below ? 1.0f : -1.0f, .minority = std::min(above, below)};
}

/// A pair's vote: positive where side 0 lies above side 1, 0 where the pair does not count.
float SideVote::opinion_of(const Member& member, std::uint32_t pair) const {
    if (is_on(member.particle, 1 - member.side)) return 0;  // a surface that crosses itself
    const FeaturePair& its = pairs_->pairs[pair];
    const PairShape& shape = pairs_->shapes[pair];
    if (!(shape.normal.w > 0) || !any_corner_is_on(its, 1 - member.side)) return 0;
    const Vector3 from_triangle = xyz(shape.normal);
    if (member.side == 1) return -from_triangle.dot(normal_at(member.particle));
    return from_triangle.dot(normal_of(xyz(positions_[its.corners[1]]), xyz(positions_[its.corners[2]]),
                                       xyz(positions_[its.corners[3]])));
}

Vector3 SideVote::normal_at(std::uint32_t particle) const {
    return surface_at(bodies_[body_of(bodies_, particle)], positions_, particle).normal;
}

// Side 0 moves along side 1's normals, or side 1 moves against them.
Vector3 SideVote::way_of(const Crossing& crossing, std::uint32_t side_of_edge, float side) const {
    const auto at = [&](std::uint32_t i) { return xyz(positions_[i]); };
    const auto& [edge, triangle] = crossing;
    const Vector3 way = side_of_edge == 0 ? normal_of(at(triangle[0]), at(triangle[1]), at(triangle[2]))
                                          : Vector3(-normal_at(edge[0]) - normal_at(edge[1]));
    return (side * way).stableNormalized();
}

}  // namespace weft
