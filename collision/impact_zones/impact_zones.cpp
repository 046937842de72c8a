#include "collision/impact_zones/impact_zones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "collision/geometry/surfaces.h"
#include "engine/vector.h"

namespace weft {

namespace {

using Eigen::Vector3d;

std::uint32_t find_root(std::vector<std::uint32_t>& roots, std::uint32_t i) {
    while (roots[i] != i) i = roots[i] = roots[roots[i]];
    return i;
}

Vector3d direction_of(const Vector3d& normal) {
    const double length = length_of(normal);
    return length > 0 ? Vector3d(normal / length) : Vector3d::Zero();
}

/// Replaces A by L, row by row, with A = L L^T (Cholesky). Returns false if A is not positive definite. Eigen
/// is not used: it orders sums by the machine's vectors.
bool factorise(std::span<double> a, std::size_t m) {
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double rest = a[i * m + j];
            for (std::size_t k = 0; k < j; ++k) rest -= a[i * m + k] * a[j * m + k];
            if (i == j && !(rest > 1e-12 * a[i * m + i])) return false;
            a[i * m + j] = i == j ? std::sqrt(rest) : rest / a[j * m + j];
        }
    }
    return true;
}

/// Replaces x by A^-1 x.
void solve_factors(std::span<const double> l, std::span<double> x) {
    const std::size_t m = x.size();
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t k = 0; k < i; ++k) x[i] -= l[i * m + k] * x[k];
        x[i] /= l[i * m + i];
    }
    for (std::size_t i = m; i-- > 0;) {
        for (std::size_t k = i + 1; k < m; ++k) x[i] -= l[k * m + i] * x[k];
        x[i] /= l[i * m + i];
    }
}

}  // namespace

std::uint32_t find_colliding(const PairList& pairs, std::span<const Vec4> positions,
                             std::span<const Vec4> motions, float gap, float still,
                             std::span<std::uint32_t> colliding) {
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < pairs.size; ++k) {
        const PairShape& shape = pairs.shapes[k];
        const Vector3 n = xyz(shape.normal);
        const std::uint32_t first = pairs.pairs[k].corners[0];
        float distance = 0,
              approach = 0;  // weights add up to 0: the rounding of differences is small
        for (std::uint32_t c = 1; c < 4; ++c) {
            const std::uint32_t i = pairs.pairs[k].corners[c];
            distance += shape.weight(c) * n.dot(xyz(positions[i]) - xyz(positions[first]));
            approach += shape.weight(c) * n.dot(xyz(motions[i]) - xyz(motions[first]));
        }
        if (approach < -still && distance + approach < gap) colliding[count++] = k;
    }
    return count;
}

const std::size_t ImpactZones::bytes_per_particle = CollisionClusters::bytes_per_particle +
                                                    sizeof(CollisionCluster) + 4 * sizeof(std::uint32_t) + 1 +
                                                    sizeof(Vector3d);
const std::size_t ImpactZones::bytes_per_pair = sizeof(Collision) + 2 * sizeof(std::uint32_t);

void ImpactZones::reserve(std::size_t particles, std::size_t pairs) {
    clusters_.reserve(particles);
    merged_.reserve(particles);
    for (auto* of_clusters : {&roots_, &zone_roots_, &ends_, &degrees_}) of_clusters->reserve(particles);
    seen_.reserve(particles);
    starts_.reserve(particles);
    collisions_.reserve(pairs);
    next_ends_.reserve(2 * pairs);
    matrix_.resize(most_solved * most_solved);
    for (auto* of_zone : {&wanted_, &cost_, &impulses_}) of_zone->resize(most_solved);
    program_ = LinearProgram(most_solved);
}

std::uint32_t ImpactZones::root(std::uint32_t cluster) {
    return find_root(roots_, cluster);
}
std::uint32_t ImpactZones::zone_root(std::uint32_t cluster) {
    return find_root(zone_roots_, cluster);
}
double ImpactZones::inverse_mass(std::uint32_t cluster) const {
    return merged_[cluster].mass > 0 ? 1 / merged_[cluster].mass : 0;
}

void ImpactZones::list_collisions(const CollidingPairs& collisions, ZoneCounts& counts) {
    collisions_.clear();
    for (const std::uint32_t pair : collisions.colliding) {
        const std::uint32_t a = clusters_.of(collisions.side_a(pair)),
                            b = clusters_.of(collisions.side_b(pair));
        if (a == b || a == CollisionClusters::none || b == CollisionClusters::none) {
            ++counts.unresolved;
            continue;
        }
        const Vector3d normal = xyz(collisions.pairs.shapes[pair].normal).cast<double>();
        collisions_.push_back(
            {.a = std::min(a, b), .b = std::max(a, b), .direction = a < b ? normal : -normal});
    }
    join_equal();
}

/// Joins the collisions of the same two clusters. The direction, for now, is the sum of the pairs' normals.
void ImpactZones::join_equal() {
    const auto key = [](const Collision& c) {
        return std::tuple(c.a, c.b, c.direction.x(), c.direction.y(), c.direction.z());
    };
    std::ranges::sort(collisions_, {}, key);
    std::size_t kept = 0;
    for (const Collision& each : collisions_) {
        if (kept > 0 && collisions_[kept - 1].a == each.a && collisions_[kept - 1].b == each.b)
            collisions_[kept - 1].direction += each.direction;
        else
            collisions_[kept++] = each;
    }
    collisions_.resize(kept);
}

/// Whether two merged clusters may become one: their normals differ by at most a right angle, and they do not
/// collide with each other.
bool ImpactZones::may_merge(std::uint32_t a, std::uint32_t b) {
    if (dot(merged_[a].normal, merged_[b].normal) < 0) return false;
    const std::uint32_t fewer = degrees_[a] <= degrees_[b] ? a : b, other = fewer == a ? b : a;
    if (degrees_[fewer] > most_compared) return false;
    std::uint32_t end = ends_[fewer];
    for (std::uint32_t k = 0; k < degrees_[fewer]; ++k, end = next_ends_[end]) {
        const Collision& collision = collisions_[end / 2];
        if (root(end % 2 == 0 ? collision.b : collision.a) == other) return false;
    }
    return true;
}

void ImpactZones::list_ends() {
    degrees_.assign(merged_.size(), 0);
    ends_.resize(merged_.size());
    next_ends_.resize(2 * collisions_.size());
    for (std::uint32_t end = 0; end < next_ends_.size(); ++end) {
        const std::uint32_t cluster = end % 2 == 0 ? collisions_[end / 2].a : collisions_[end / 2].b;
        if (degrees_[cluster]++ == 0)
            ends_[cluster] = next_ends_[end] = end;
        else
            next_ends_[end] = std::exchange(next_ends_[ends_[cluster]], end);
    }
}

/// Merges b into a.
void ImpactZones::merge(std::uint32_t a, std::uint32_t b) {
    CollisionCluster &into = merged_[a], &from = merged_[b];
    const double mass = into.mass + from.mass;
    into.velocity = mass > 0 ? Vector3d((into.mass * into.velocity + from.mass * from.velocity) / mass)
                             : Vector3d(0.5 * (into.velocity + from.velocity));
    into.mass = mass;
    into.normal += from.normal;
    roots_[b] = a;
    if (degrees_[a] == 0)
        ends_[a] = ends_[b];
    else if (degrees_[b] > 0)
        std::swap(next_ends_[ends_[a]], next_ends_[ends_[b]]);
    degrees_[a] += degrees_[b];
}

// Clusters of one surface are close if at most two edges outside both connect them (section 3.2). Only zones
// of three and more clusters have any to merge.
void ImpactZones::merge_close(const CollidingPairs& collisions, ZoneCounts& counts) {
    seen_.assign(merged_.size(), 0);  // number of clusters of the zone, up to three
    for (std::uint32_t c = 0; c < merged_.size(); ++c) {
        std::uint8_t& count = seen_[zone_root(c)];
        count = static_cast<std::uint8_t>(std::min(count + 1, 3));
    }
    list_ends();
    const auto look = [&](std::uint32_t cluster, std::uint32_t near) {
        if (near == CollisionClusters::none || zone_root(cluster) != zone_root(near)) return;
        const std::uint32_t a = std::min(root(cluster), root(near)), b = std::max(root(cluster), root(near));
        if (a == b || merged_[a].body != merged_[b].body || !may_merge(a, b)) return;
        if ((merged_[a].mass > 0) != (merged_[b].mass > 0)) return;
        merge(a, b);
        ++counts.merged;
    };
    for (const std::uint32_t i : clusters_.particles()) {
        const std::uint32_t cluster = clusters_.of(i);
        if (seen_[zone_root(cluster)] < 3) continue;
        const ContactBody& body = collisions.bodies[clusters_.all()[cluster].body];
        for_each_neighbour(body, i, [&](std::uint32_t j) {
            look(cluster, clusters_.of(j));
            if (clusters_.of(j) != CollisionClusters::none) return;
            for_each_neighbour(body, j, [&](std::uint32_t k) { look(cluster, clusters_.of(k)); });
        });
    }
    for (Collision& each : collisions_) {
        std::uint32_t a = root(each.a), b = root(each.b);
        if (a > b) each.direction = -each.direction;
        each.a = std::min(a, b);
        each.b = std::max(a, b);
    }
    if (counts.merged > 0) join_equal();
}

// The direction of collision is the mean of the clusters' normals, signed so that N1 . N2 >= 0 (section 3.3).
// It points as the pairs' directions do. Clusters that separate along it need no impulse.
void ImpactZones::aim(const ZoneSettings& settings) {
    const auto restitution_of = [&](std::size_t a, std::size_t b) {
        const std::span<const float> of = settings.restitutions;
        return of.empty() ? 0.0 : static_cast<double>(restitution_between(of[a], of[b]));
    };
    std::size_t kept = 0;
    for (Collision each : collisions_) {
        const CollisionCluster &a = merged_[each.a], &b = merged_[each.b];
        const Vector3d of_a = direction_of(a.normal), of_b = direction_of(b.normal);
        Vector3d mean = direction_of(of_a + (dot(of_a, of_b) < 0 ? -1.0 : 1.0) * of_b);
        if (mean.isZero(0)) mean = direction_of(each.direction);
        each.direction = dot(each.direction, mean) < 0 ? Vector3d(-mean) : mean;
        const double before = dot(a.velocity - b.velocity, each.direction);
        if (!(before < settings.still) || inverse_mass(each.a) + inverse_mass(each.b) <= 0) continue;
        each.wanted = -restitution_of(a.body, b.body) * std::min(before, 0.0);
        collisions_[kept++] = each;
    }
    collisions_.resize(kept);
}

/// Fills the matrix, from impulses to changes of relative velocities, and the wanted changes of these.
void ImpactZones::assemble(std::span<const Collision> zone) {
    const std::size_t m = zone.size();
    for (std::size_t e = 0; e < m; ++e) {
        const Collision& row = zone[e];
        for (std::size_t f = 0; f < m; ++f) {
            const Collision& column = zone[f];
            const auto share = [&](std::uint32_t cluster) {
                const double of_row = (row.a == cluster) - (row.b == cluster);
                const double of_column = (column.a == cluster) - (column.b == cluster);
                return of_row * of_column * inverse_mass(cluster);
            };
            matrix_[e * m + f] = (share(row.a) + share(row.b)) * dot(row.direction, column.direction);
        }
        wanted_[e] = row.wanted - dot(merged_[row.a].velocity - merged_[row.b].velocity, row.direction);
    }
}

/// Solves N - 1 equations v+ = -C_e v- (eq. 1), with momentum kept (eq. 2). Returns false if an impulse would
/// pull, or if the equations are dependent.
bool ImpactZones::solve_equations(std::span<Collision> zone) {
    const std::size_t m = zone.size();
    std::array<double, most_solved * most_solved> factors;
    std::copy_n(matrix_.begin(), m * m, factors.begin());
    if (!factorise(factors, m)) return false;
    const std::span<double> impulses = std::span(impulses_).first(m);
    std::ranges::copy(std::span(wanted_).first(m), impulses.begin());
    solve_factors(factors, impulses);
    if (!std::ranges::all_of(impulses, [](double impulse) { return impulse >= 0 && std::isfinite(impulse); }))
        return false;
    for (std::size_t e = 0; e < m; ++e) zone[e].impulse = impulses[e];
    return true;
}

/// Solves v+ >= -C_e v- (eq. 3) with the least sum of v+ + C_e v- (eq. 4): the energy that is brought in.
bool ImpactZones::solve_program(std::span<Collision> zone) {
    const std::size_t m = zone.size();
    for (std::size_t f = 0; f < m; ++f) {
        cost_[f] = 0;
        for (std::size_t e = 0; e < m; ++e) cost_[f] += matrix_[e * m + f];
    }
    const std::span<double> impulses = std::span(impulses_).first(m);
    if (!program_.minimise(std::span(cost_).first(m), std::span(matrix_).first(m * m),
                           std::span(wanted_).first(m), impulses))
        return false;
    for (std::size_t e = 0; e < m; ++e) zone[e].impulse = impulses[e];
    return true;
}

/// Solves eq. 3 by Gauss-Seidel; the velocities here include the impulses so far.
void ImpactZones::relax(std::span<Collision> zone) {
    constexpr int sweeps = 60;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (Collision& each : zone) {
            CollisionCluster &a = merged_[each.a], &b = merged_[each.b];
            const double now = dot(a.velocity - b.velocity, each.direction);
            const double weight = inverse_mass(each.a) + inverse_mass(each.b);
            const double more = std::max((each.wanted - now) / weight, -each.impulse);
            each.impulse += more;
            a.velocity += more * inverse_mass(each.a) * each.direction;
            b.velocity -= more * inverse_mass(each.b) * each.direction;
        }
    }
}

void ImpactZones::solve(std::span<Collision> zone, ZoneCounts& counts) {
    ++counts.zones;
    if (zone.size() > most_solved) {
        ++counts.relaxed;
        return relax(zone);
    }
    std::size_t bodies = 0;
    for (const Collision& each : zone) seen_[each.a] = seen_[each.b] = 0;
    for (const Collision& each : zone)
        for (const std::uint32_t cluster : {each.a, each.b}) bodies += seen_[cluster]++ == 0 ? 1 : 0;
    assemble(zone);
    const bool is_cyclic = zone.size() >= bodies;
    if (is_cyclic || !solve_equations(zone)) {
        const bool is_one_too_many = counts.programs == most_programs;
        if (is_one_too_many || (++counts.programs, !solve_program(zone))) {
            ++counts.relaxed;
            return relax(zone);
        }
    }
    for (const Collision& each : zone) {
        merged_[each.a].velocity += each.impulse * inverse_mass(each.a) * each.direction;
        merged_[each.b].velocity -= each.impulse * inverse_mass(each.b) * each.direction;
    }
}

void ImpactZones::apply(const CollidingPairs& collisions, const ZoneSettings& settings,
                        std::span<Vec4> velocities) {
    seen_.assign(merged_.size(), 0);
    for (const Collision& each : collisions_) seen_[each.a] = seen_[each.b] = 1;
    for (const std::uint32_t i : clusters_.particles()) {
        const std::uint32_t cluster = root(clusters_.of(i));
        if (seen_[cluster] == 0 || !(collisions.positions[i].w > 0)) continue;
        const Vector3d now = xyz(velocities[i]).cast<double>();
        const Vector3d then = merged_[cluster].velocity;
        set_xyz(velocities[i],
                (settings.as_bundles ? then : Vector3d(now + then - starts_[cluster])).cast<float>());
    }
}

ZoneCounts ImpactZones::resolve(const CollidingPairs& collisions, const ZoneSettings& settings,
                                std::span<Vec4> velocities) {
    ZoneCounts counts;
    if (collisions.colliding.empty()) return counts;
    clusters_.find(collisions, velocities);
    counts.clusters = static_cast<std::uint32_t>(clusters_.all().size());
    merged_.assign(clusters_.all().begin(), clusters_.all().end());
    roots_.resize(merged_.size());
    zone_roots_.resize(merged_.size());
    for (std::uint32_t c = 0; c < merged_.size(); ++c) roots_[c] = zone_roots_[c] = c;
    list_collisions(collisions, counts);
    for (const Collision& each : collisions_) zone_roots_[zone_root(each.a)] = zone_root(each.b);
    merge_close(collisions, counts);
    aim(settings);
    counts.collisions = static_cast<std::uint32_t>(collisions_.size());
    starts_.clear();
    for (const CollisionCluster& each : merged_) starts_.push_back(each.velocity);

    for (std::uint32_t c = 0; c < merged_.size(); ++c) zone_roots_[c] = c;
    for (const Collision& each : collisions_)
        zone_roots_[std::max(zone_root(each.a), zone_root(each.b))] =
            std::min(zone_root(each.a), zone_root(each.b));
    for (Collision& each : collisions_) each.zone = zone_root(each.a);
    std::ranges::sort(collisions_, {}, [](const Collision& c) { return std::tuple(c.zone, c.a, c.b); });
    const std::span<Collision> all = collisions_;
    for (std::size_t begin = 0; begin < all.size();) {
        std::size_t end = begin;
        while (end < all.size() && all[end].zone == all[begin].zone) ++end;
        solve(all.subspan(begin, end - begin), counts);
        begin = end;
    }
    apply(collisions, settings, velocities);
    return counts;
}

std::size_t ImpactZones::bytes() const noexcept {
    return clusters_.bytes() + program_.bytes() + merged_.capacity() * sizeof(CollisionCluster) +
           (roots_.capacity() + zone_roots_.capacity() + ends_.capacity() + next_ends_.capacity() +
            degrees_.capacity()) *
               sizeof(std::uint32_t) +
           seen_.capacity() + collisions_.capacity() * sizeof(Collision) +
           starts_.capacity() * sizeof(Vector3d) +
           (matrix_.capacity() + wanted_.capacity() + cost_.capacity() + impulses_.capacity()) *
               sizeof(double);
}

}  // namespace weft
