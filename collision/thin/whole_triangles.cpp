#include "collision/thin/whole_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "collision/colliders/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "collision/thin/cores.h"
#include "collision/thin/first_approach.h"
#include "collision/thin/skewer.h"
#include "collision/thin/yielding.h"
#include "engine/bounds.h"

namespace weft {

namespace {

constexpr int most_rounds = 8, most_searches = 3;
/// Part of the thickness that is kept: particles keep all of it, but the sides between them are chords round
/// a thin collider.
constexpr float part_of_thickness = 0.5f;
/// Least gap over the mean edge, where there is no thickness.
constexpr float least_gap = 0.02f;

std::span<const Vec4> of_block_of(std::span<const Vec4> all, const BlockRange& range) {
    return all.subspan(range.begin, range.end - range.begin);
}

/// Longest path of the corners relative to the collider, without motion that cloth shares with its wearer.
float longest_way(const CornerPaths& corners) {
    float squared = 0;
    for (std::size_t k = 0; k < 3; ++k)
        squared = std::max(squared, (corners.to[k] - corners.from[k]).squaredNorm());
    return std::sqrt(squared);
}

std::optional<weft::Meeting> meeting_with(const ColliderMotion& motion, float h, float thickness,
                                          const BlockPaths& paths) {
    return with_shapes(motion, [&](const auto& start, const auto& end) {
        return may_meet(start, end, {h, motion.fastest}, {thickness, 0}, paths);
    });
}

/// The sides of the cores' bounding box beyond which a block of triangles has its particles.
class ParticleSides {
  public:
    /// Nothing is known of a block whose particles lie too far apart in memory.
    ParticleSides(const TurningBox& box, std::span<const Vec4> starts, std::span<const Vec4> positions,
                  std::uint32_t first, std::uint32_t last)
        : first_(first), known_(last - first < most) {
        const std::uint32_t count = last - first + 1;
        if (known_)
            find_sides(box, starts.subspan(first, count), positions.subspan(first, count),
                       std::span(sides_).first(count));
    }
    [[nodiscard]] bool leave_out(const WholeTriangles::Triangle& t) const {
        return known_ && (sides_[t[0] - first_] & sides_[t[1] - first_] & sides_[t[2] - first_]) != 0;
    }

  private:
    static constexpr std::uint32_t most = 2048;
    std::uint32_t first_;
    bool known_;
    std::array<std::uint32_t, most> sides_;
};

}  // namespace

/// A pass of one collider against the cloth.
struct WholeTriangles::Meeting {
    const Cores& cores;
    const ColliderMotion& motion;
    const ClothSide& cloth;
    const CollidingParticles& particles;
    float h, mean_edge;
    Slipping slipping;
    bool edges_part;  ///< of triangles that are near

    /// Size of cells where a triangle begins: the cloth's mean edge, or two thirds of the triangle's own size
    /// if greater. That is half the root of its sides' summed squares, for half of a square the square's
    /// side. Beside rods that stand still it is the mean edge: cloth squeezed by two limbs is stretched, and
    /// rests only where particles alone hold it.
    [[nodiscard]] float side(const CornerPaths& corners) const {
        if (!slipping.moves && !slipping.is_ball) return mean_edge;
        constexpr float part = 2.0f / 3;
        const auto& [a, b, c] = corners.from;
        const float squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        return std::max(mean_edge, part * 0.5f * std::sqrt(squares));
    }
    [[nodiscard]] float thickness() const { return thickness_of(motion, cloth); }
    [[nodiscard]] float longest_gap() const {
        return std::max(part_of_thickness * thickness(), least_gap * mean_edge);
    }
    /// Gap to keep for this triangle.
    [[nodiscard]] float gap(const Triangle& corners) const {
        float own = cloth.most_thickness;
        for (const std::uint32_t i : corners) own = std::min(own, cloth.thickness[i]);
        return std::max(part_of_thickness * (own + motion.end.thickness), least_gap * mean_edge);
    }
    [[nodiscard]] CornerPaths paths(const Triangle& corners) const {
        CornerPaths paths;
        for (std::size_t k = 0; k < 3; ++k) {
            paths.from[k] = cores.seen_at_start(xyz(particles.starts[corners[k]]));
            paths.to[k] = cores.seen(xyz(particles.positions[corners[k]]));
        }
        return paths;
    }
    [[nodiscard]] auto corners_that_meet(const Triangle& corners) const {
        return std::ranges::count_if(corners, [&](std::uint32_t i) { return cloth.meets(motion.end, i); });
    }
    [[nodiscard]] bool meets_side(const Triangle& corners, std::size_t k) const {
        return cloth.meets(motion.end, corners[k]) && cloth.meets(motion.end, corners[(k + 1) % 3]);
    }
    void push(const Triangle& corners, const Approach& approach) const;
};

// The impulse is shared by masses and weights (Bridson, Fedkiw, Anderson 2002, equation 7 and section 7.3).
// Coulomb's friction moves positions, too, as in collide().
void WholeTriangles::Meeting::push(const Triangle& corners, const Approach& approach) const {
    float rubs = 0;
    const Vector3 normal = cores.in_world(approach.normal);
    Vector3 velocity = -cores.velocity_at(approach.core);
    for (std::size_t k = 0; k < 3; ++k) {
        const float weight = approach.weights[k];
        if (weight == 0) continue;
        velocity += weight * xyz(particles.velocities[corners[k]]);
        rubs += weight * cloth.friction_on(normal, corners[k]);
    }
    const float along = normal.dot(velocity), arrives = std::max(-along, 0.0f);
    const float taken =
        arrives > cloth.least_bounce ? (1 + restitution_of(motion, cloth)) * arrives : arrives;
    const Vector3 sliding = velocity - along * normal;
    const float speed = sliding.norm(), limit = rubs * motion.end.friction * taken;
    const Vector3 stopped = speed > limit ? Vector3((limit / speed) * sliding) : sliding;
    const Vector3 kick = taken * normal - stopped, way = approach.depth * normal - h * stopped;
    share_push(corners, approach.weights, particles.positions, [&](std::uint32_t i, float share) {
        Vec4 &position = particles.positions[i], &own = particles.velocities[i];
        set_xyz(position, xyz(position) + share * way);
        set_xyz(own, xyz(own) + share * kick);
    });
}

WholeTriangles::WholeTriangles(std::span<const Triangle> triangles, std::uint32_t particles, float mean_edge)
    : triangles_(triangles),
      order_(triangles.size()),
      mean_edge_(mean_edge),
      owned_(triangles.size()),
      spans_(block_count(static_cast<std::uint32_t>(triangles.size()))),
      near_(triangles.size()),
      counts_(spans_.size()),
      is_fast_(spans_.size()),
      longest_(spans_.size()),
      paths_(block_count(particles)) {
    std::iota(order_.span().begin(), order_.span().end(), 0u);
    std::ranges::sort(order_.span(), {},
                      [&](std::uint32_t t) { return std::pair(std::ranges::min(triangles[t]), t); });
    find_owned();
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto [least, most] = std::ranges::minmax(triangles[order_[t]]);
        ParticleSpan& span = spans_[t / block_size];
        if (t % block_size == 0) span = {least, most};
        span = {std::min(span.first, least), std::max(span.last, most)};
    }
}

/// A side that two triangles share is tested once, with the first of them.
void WholeTriangles::find_owned() {
    struct Side {
        std::uint32_t low, high, triangle, k;
        auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t i = triangles_[t][k], j = triangles_[t][(k + 1) % 3];
            if (i != j) sides.push_back({std::min(i, j), std::max(i, j), t, k});
        }
    std::ranges::sort(sides);
    const Side* before = nullptr;
    for (const Side& side : sides) {
        if (before == nullptr || before->low != side.low || before->high != side.high)
            owned_[side.triangle] |= static_cast<std::uint8_t>(1u << side.k);
        before = &side;
    }
}

std::uint32_t WholeTriangles::keep_out(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                       const ClothSide& cloth, float h, const CollidingParticles& particles) {
    std::uint32_t met = 0;
    bool has_paths = false;
    float longest = 0;  // longest edge; 0: not known
    BlockPaths all;
    for (const ColliderMotion& motion : colliders) {
        if (!cloth.meets(motion.end)) continue;
        if (has_paths && !may_be_near(motion, cloth.most_thickness, all)) continue;
        const float thickness = thickness_of(motion, cloth);
        const std::optional<Slipping> slips = slipping(motion, h, thickness);
        if (!slips) continue;
        if (!has_paths) all = find_paths(parallel, particles);
        has_paths = true;
        if (!meeting_with(motion, h, thickness, all)) continue;
        if (longest == 0) longest = longest_edge(parallel, particles.starts);
        const bool edges_part = slips->edges_part(slips->way + all.longest, h);
        if (slips->beside(std::max(longest, mean_edge_), edges_part) == Thinness::thick) continue;
        const Cores cores(motion, h, edges_part);
        if (cores.empty()) continue;
        const Meeting meeting{cores, motion, cloth, particles, h, mean_edge_, *slips, edges_part};
        // A push also moves neighbouring triangles that were not near.
        for (int search = 0; search < most_searches; ++search) {
            if (search > 0) all = find_paths(parallel, particles);
            const std::uint32_t moved = push_out(meeting, find_near(parallel, meeting));
            met += search == 0 ? moved : 0;
            if (moved == 0) break;
        }
        met += take_off(parallel, meeting, colliders);
    }
    return met;
}

float WholeTriangles::longest_edge(Parallel& parallel, std::span<const Vec4> positions) {
    parallel.ranges(static_cast<std::uint32_t>(triangles_.size()), [&](const BlockRange& range) {
        float squared = 0;
        for (const std::uint32_t t : order_.span().subspan(range.begin, range.end - range.begin))
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec4 &a = positions[triangles_[t][k]], &b = positions[triangles_[t][(k + 1) % 3]];
                squared = std::max(squared, (xyz(b) - xyz(a)).squaredNorm());
            }
        longest_[range.block] = std::sqrt(squared);
    });
    return *std::ranges::max_element(longest_.span());
}

/// Finds the paths of each block; returns those of all.
BlockPaths WholeTriangles::find_paths(Parallel& parallel, const CollidingParticles& particles) {
    parallel.ranges(static_cast<std::uint32_t>(particles.positions.size()), [&](const BlockRange& range) {
        paths_[range.block] =
            paths_of(of_block_of(particles.starts, range), of_block_of(particles.positions, range));
    });
    return joined(0, static_cast<std::uint32_t>(paths_.size()) - 1);
}

BlockPaths WholeTriangles::joined(std::uint32_t first, std::uint32_t last) const {
    BlockPaths all = paths_[first];
    for (std::uint32_t block = first + 1; block <= last; ++block) {
        const BlockPaths& more = paths_[block];
        all.ends.lower = to_vec3(to_vector(all.ends.lower).cwiseMin(to_vector(more.ends.lower)));
        all.ends.upper = to_vec3(to_vector(all.ends.upper).cwiseMax(to_vector(more.ends.upper)));
        all.longest = std::max(all.longest, more.longest);
    }
    return all;
}

/// Finds triangles that may come near a core that is thin beside them, in ascending order; returns their
/// number. If one is fast enough all count: slow ones beside it move with the collider already.
std::uint32_t WholeTriangles::find_near(Parallel& parallel, const Meeting& meeting) {
    parallel.ranges(static_cast<std::uint32_t>(triangles_.size()),
                    [&](const BlockRange& range) { find_near_in_block(meeting, range); });
    if (std::ranges::none_of(is_fast_.span(), [](std::uint8_t fast) { return fast != 0; })) return 0;
    return gather_near();
}

std::uint32_t WholeTriangles::gather_near() {
    std::uint32_t near = 0;
    for (std::uint32_t block = 0; block < counts_.size(); ++block) {
        const std::uint32_t* const begin = near_.data() + std::size_t{block} * block_size;
        std::copy(begin, begin + counts_[block], near_.data() + near);
        near += counts_[block];
    }
    std::ranges::sort(near_.span().first(near));
    return near;
}

void WholeTriangles::find_near_in_block(const Meeting& meeting, const BlockRange& range) {
    std::uint32_t& count = counts_[range.block];
    count = 0;
    is_fast_[range.block] = 0;
    const ParticleSpan& span = spans_[range.block];
    const BlockPaths paths = joined(span.first / block_size, span.last / block_size);
    const float gap = meeting.longest_gap();
    const auto may = meeting_with(meeting.motion, meeting.h, meeting.thickness(), paths);
    const Slipping& slipping = meeting.slipping;
    const bool edges_part = slipping.edges_part(slipping.way + paths.longest, meeting.h);
    if (!may || slipping.beside(std::max(longest_[range.block], mean_edge_), edges_part) == Thinness::thick)
        return;
    constexpr float never = std::numeric_limits<float>::infinity();
    const float if_fast = may->thin == 0 ? never : may->thin;
    const Vector3 margin = Vector3::Constant(gap);
    const ParticleSides sides(meeting.cores.turning_box(gap), meeting.particles.starts,
                              meeting.particles.positions, span.first, span.last);
    for (const std::uint32_t t : order_.span().subspan(range.begin, range.end - range.begin)) {
        const Triangle& triangle = triangles_[t];
        if (sides.leave_out(triangle) || meeting.corners_that_meet(triangle) < 2) continue;
        const CornerPaths corners = meeting.paths(triangle);
        const float way = longest_way(corners);
        const Thinness thinness = slipping.beside(meeting.side(corners), slipping.edges_part(way, meeting.h));
        if (thinness == Thinness::thick) continue;
        Eigen::AlignedBox3f box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(corners.from[k]).extend(corners.to[k]);
        box = Eigen::AlignedBox3f(box.min() - margin, box.max() + margin);
        if (!box.intersects(meeting.cores.box())) continue;
        const auto is_near = [&](const Core& core) { return box.intersects(core.box); };
        if (!std::ranges::any_of(meeting.cores.list(), is_near)) continue;
        near_[range.begin + count++] = t;
        if (thinness != Thinness::thin_if_fast || way > if_fast) is_fast_[range.block] = 1;
    }
}

/// Triangles are pushed one after the other, so that each starts from the last one's result.
std::uint32_t WholeTriangles::push_out(const Meeting& meeting, std::uint32_t near) {
    std::uint32_t moved = 0;
    for (int round = 0; round < most_rounds; ++round) {
        bool any = false;
        for (const std::uint32_t triangle : near_.span().first(near)) {
            if (!push_out_triangle(meeting, triangle)) continue;
            any = true;
            moved += round == 0 ? 1 : 0;
        }
        if (!any) break;
    }
    return moved;
}

bool WholeTriangles::push_out_triangle(const Meeting& meeting, std::uint32_t triangle) {
    const Triangle& corners = triangles_[triangle];
    const float gap = meeting.gap(corners);
    bool any = false;
    CornerPaths paths = meeting.paths(corners);
    const float side = meeting.side(paths);
    const bool only_from_outside = meeting.slipping.beside(side, meeting.edges_part) != Thinness::thinnest;
    // Edges hold a collider that is nearly as wide as cells; its round core would push the other way.
    const Thinness as_rod = meeting.slipping.as_rod(side);
    const bool is_thick =
        as_rod == Thinness::thick || (meeting.edges_part && as_rod == Thinness::thin_if_fast);
    const auto push = [&](const Core& core, const Triangle& of, const CornerPaths& way) {
        const auto approach = first_approach(meeting.cores, core, way, {gap, only_from_outside});
        if (!approach) return;
        meeting.push(of, *approach);
        paths = meeting.paths(corners);
        any |= approach->depth > 0.02f * gap;
    };
    const Vector3 margin = Vector3::Constant(gap);
    for (const Core& core : meeting.cores.list()) {
        if (is_thick && !core.is_edge) continue;
        Eigen::AlignedBox3f box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(paths.from[k]).extend(paths.to[k]);
        if (!Eigen::AlignedBox3f(box.min() - margin, box.max() + margin).intersects(core.box)) continue;
        if (core.is_point()) {
            if (meeting.corners_that_meet(corners) == 3) push(core, corners, paths);
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned_[triangle] & (1u << k)) == 0 || !meeting.meets_side(corners, k)) continue;
            const std::size_t next = (k + 1) % 3;
            push(core, {corners[k], corners[next], corners[k]},
                 {{paths.from[k], paths.from[next], paths.from[k]},
                  {paths.to[k], paths.to[next], paths.to[k]}});
        }
    }
    return any;
}

/// Finds the triangles that the axis pierces, in ascending order; returns their number.
std::uint32_t WholeTriangles::find_pierced(Parallel& parallel, const Skewer& skewer, const Meeting& meeting) {
    const Bounds bounds = skewer.bounds();
    const TurningBox box = skewer.box();
    const std::span<const Vec4> positions = meeting.particles.positions;
    parallel.ranges(static_cast<std::uint32_t>(triangles_.size()), [&](const BlockRange& range) {
        std::uint32_t& count = counts_[range.block];
        count = 0;
        const ParticleSpan& span = spans_[range.block];
        if (!overlap(joined(span.first / block_size, span.last / block_size).ends, bounds)) return;
        const ParticleSides sides(box, positions, positions, span.first, span.last);
        for (const std::uint32_t t : order_.span().subspan(range.begin, range.end - range.begin))
            if (!sides.leave_out(triangles_[t]) && meeting.corners_that_meet(triangles_[t]) == 3 &&
                skewer.goes_through(triangles_[t], positions))
                near_[range.begin + count++] = t;
    });
    return gather_near();
}

/// Removes triangles that are pierced all the same, as when contact acts last.
std::uint32_t WholeTriangles::take_off(Parallel& parallel, const Meeting& meeting,
                                       std::span<const ColliderMotion> colliders) {
    std::optional<Skewer> skewer = Skewer::of(meeting.cores);
    if (!skewer) return 0;
    const std::uint32_t pierced = find_pierced(parallel, *skewer, meeting);
    if (pierced == 0) return 0;
    skewer->find_ways(meeting.motion, colliders, meeting.cloth, meeting.h);
    std::uint32_t moved = 0;
    for (const std::uint32_t triangle : near_.span().first(pierced))
        moved += skewer->take_off(triangles_[triangle], meeting.h, meeting.particles.positions) ? 1 : 0;
    return moved;
}

}  // namespace weft
