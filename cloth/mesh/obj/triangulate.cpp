#include "cloth/mesh/obj/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <queue>
#include <tuple>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cloth/mesh/mesh_limits.h"
#include "cloth/mesh/obj/corner_tree.h"
#include "collision/geometry/volume_sign.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// The most corners of a face that is cut into a fan: its first corner gets all of the triangles.
constexpr std::uint32_t most_corners_of_fan = 64;

Eigen::Vector3d difference(const Vec3& p, const Vec3& origin) {
    return to_vector(p).cast<double>() - to_vector(origin).cast<double>();
}

/// Cuts the triangle between the first corner, the middle one and the last, and halves the rest on both its
/// sides in the same way: no corner gets more than two triangles for each halving.
void append_halves(std::uint32_t first, std::uint32_t last, std::vector<Triangle>& triangles) {
    if (last - first < 2) return;
    const std::uint32_t middle = first + (last - first + 1) / 2;
    triangles.push_back({first, middle, last});
    append_halves(first, middle, triangles);
    append_halves(middle, last, triangles);
}

/// A cut that is right for a convex face.
void cut_convex(std::uint32_t corners, std::vector<Triangle>& triangles) {
    triangles.clear();
    if (corners > most_corners_of_fan) return append_halves(0, corners - 1, triangles);
    for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
}

/// Twice a triangle's area vector.
Eigen::Vector3d doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return difference(b, a).cross(difference(c, a));
}

/// The outline as seen along its area vector, Newell's normal (Sutherland, Sproull, Schumacker 1974).
struct View {
    explicit View(std::span<const Vec3> seen) : outline(seen) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 2; i < seen.size(); ++i) sum += doubled_area(seen[0], seen[i - 1], seen[i]);
        const double largest = sum.cwiseAbs().maxCoeff();
        if (largest > 0) normal = to_vec3((sum / largest).cast<float>());
        doubled = sum.norm();
    }

    [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return area_sign(outline[a], outline[b], outline[c], normal);
    }

    /// Whether no triangle is turned over, and they do not stand edge-on.
    [[nodiscard]] bool shows_fronts(std::span<const Triangle> triangles) const {
        double sum = 0;
        for (const auto [a, b, c] : triangles) {
            if (turn(a, b, c) < 0) return false;
            sum += doubled_area(outline[a], outline[b], outline[c]).norm();
        }
        return sum <= most_oblique * doubled;
    }

    /// Two triangles that are folded to an angle of 11 degrees have 10 times the area that is seen. The two
    /// halves of a bow tie have more: they cancel in the normal, except where the face is not flat.
    static constexpr double most_oblique = 10;

    std::span<const Vec3> outline;
    Vec3 normal{};       ///< its largest component is 1 or -1; zero where the outline encloses nothing
    double doubled = 0;  ///< twice the area that the outline encloses [m^2]
};

/// Cuts ears off an outline, either on its inside or on its outside. An ear is a corner whose triangle with
/// its two neighbours is on that side, with nothing of the outline in it. Every outline that does not cross
/// itself has some (Meisters 1975), and all signs are exact, so that each such outline is cut to the end.
/// Where corners lie in a triangle, the farthest of them from the edge that the cut would make turns away
/// from that side, or goes straight on: only such corners are searched.
class EarClipping {
  public:
    enum Side : std::int8_t { outside = -1, inside = 1 };

    EarClipping(const View& view, Side side);

    /// Cuts all ears on the outside; true if what is left is convex. No point then has the outline around it
    /// twice: the convex outline goes once around what it encloses, and each ear takes a part away.
    [[nodiscard]] bool leaves_convex();
    /// Cuts all ears on the inside and returns whether they are all of the face.
    [[nodiscard]] bool cut_all(std::vector<Triangle>& triangles);

  private:
    /// Order of cuts. Corners without area come first on the outside, where their cut simplifies the outline.
    /// On the inside their cut makes a triangle without area: they come last, unless earlier cuts took their
    /// area away.
    enum Rank : std::int8_t { at_once, proper, touched, without_area };

    struct Candidate {
        Rank rank;
        int size;     // binary logarithm of the circumscribed circle's radius
        double base;  // [m^2] squared length of the edge that the cut makes
        Triangle corners;

        [[nodiscard]] auto key() const { return std::tie(rank, size, base, corners); }
        bool operator<(const Candidate& other) const { return other.key() < key(); }  // the least first
    };
    enum class Room { free, touched, blocked };
    /// A corner's side of each edge of a triangle: 1 inside, 0 on the edge's line, -1 outside.
    using Sides = std::array<int, 3>;

    void consider(std::uint32_t corner, bool is_spent = false);
    void flatten();
    [[nodiscard]] std::optional<Candidate> next_ear();
    [[nodiscard]] Room room_of(const Triangle& corners);
    [[nodiscard]] bool enters(const Triangle& triangle, const Sides& sides, std::uint32_t to) const;
    [[nodiscard]] Room room_beside(const Triangle& triangle, std::uint32_t corner) const;
    void cut(std::uint32_t corner);
    void update(std::uint32_t corner);
    void unblock(std::uint32_t corner);

    const View& view_;
    const int side_;
    std::uint32_t left_;                         // corners
    std::vector<std::uint32_t> before_, after_;  // of each corner, in a ring
    std::vector<std::int8_t> turns_;             // of each corner: 1 left, -1 right, 0 straight or none
    std::vector<bool> is_cut_, blocks_;
    std::vector<Eigen::Vector2d> points_;  // corners along two axes across the normal
    std::optional<CornerTree> blocking_;   // made when the first ear is examined
    std::priority_queue<Candidate> candidates_;
    std::size_t looks_left_;
};

/// Budget of the searches: nodes and corners visited for each corner of the face, so that a file is read in
/// time proportional to its length. Combs, stars and spirals of up to 100 000 corners need 30 to 150. More
/// are needed only where thousands of corners lie at one position; such a face counts as crossing itself.
constexpr std::size_t most_looks = 512;

EarClipping::EarClipping(const View& view, Side side)
    : view_(view),
      side_(side),
      left_(static_cast<std::uint32_t>(view.outline.size())),
      before_(left_),
      after_(left_),
      turns_(left_),
      is_cut_(left_),
      blocks_(left_),
      looks_left_(most_looks * left_) {
    for (std::uint32_t i = 0; i < left_; ++i) {
        before_[i] = i == 0 ? left_ - 1 : i - 1;
        after_[i] = i + 1 == left_ ? 0 : i + 1;
    }
    for (std::uint32_t i = 0; i < left_; ++i) {
        turns_[i] = static_cast<std::int8_t>(view_.turn(before_[i], i, after_[i]));
        blocks_[i] = turns_[i] != side_;
    }
    for (std::uint32_t i = 0; i < left_; ++i) consider(i);
}

bool EarClipping::leaves_convex() {
    while (left_ > 3) {
        const std::optional<Candidate> ear = next_ear();
        if (!ear) break;
        cut(ear->corners[1]);
    }
    std::uint32_t first = 0;
    while (is_cut_[first]) ++first;
    // All corners lie to the left of the first edge, and turn to the left about the first corner.
    const std::uint32_t second = after_[first];
    for (std::uint32_t i = after_[second]; i != first; i = after_[i]) {
        if (view_.turn(first, second, i) <= 0 || view_.turn(first, before_[i], i) <= 0) return false;
    }
    return true;
}

bool EarClipping::cut_all(std::vector<Triangle>& triangles) {
    triangles.clear();
    while (left_ > 3) {
        const std::optional<Candidate> ear = next_ear();
        if (!ear) return false;
        triangles.push_back(ear->corners);
        cut(ear->corners[1]);
    }
    std::uint32_t first = 0;
    while (is_cut_[first]) ++first;
    triangles.push_back({first, after_[first], before_[first]});
    return view_.shows_fronts(triangles);
}

void EarClipping::consider(std::uint32_t corner, bool is_spent) {
    if (turns_[corner] == -side_) return;
    const Triangle corners{before_[corner], corner, after_[corner]};
    const auto edge = [&](std::size_t from, std::size_t to) {
        return difference(view_.outline[corners[to]], view_.outline[corners[from]]);
    };
    const Eigen::Vector3d a = edge(0, 1), b = edge(1, 2), c = edge(2, 0);
    const double doubled = a.cross(b).norm();
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
    const double radius = a.norm() * b.norm() * c.norm() / (2 * doubled);
    const bool has_area = turns_[corner] != 0 && doubled > least_relative_height * longest;
    Candidate candidate{proper, 0, c.squaredNorm(), corners};
    if (has_area)
        candidate.size = std::ilogb(radius);
    else
        candidate.rank = turns_[corner] == 0 && (side_ == outside || is_spent) ? at_once : without_area;
    candidates_.push(candidate);
}

/// The next corner to cut; none: no corner can be cut.
std::optional<EarClipping::Candidate> EarClipping::next_ear() {
    while (!candidates_.empty()) {
        Candidate candidate = candidates_.top();
        candidates_.pop();
        const auto [before, corner, after] = candidate.corners;
        if (is_cut_[corner] || before_[corner] != before || after_[corner] != after) continue;
        if (turns_[corner] == 0) return candidate;
        const Room room = room_of(candidate.corners);
        if (room == Room::free || (room == Room::touched && candidate.rank >= touched)) return candidate;
        if (room == Room::blocked) continue;
        candidate.rank = touched;
        candidates_.push(candidate);
    }
    return std::nullopt;
}

/// Computes coordinates along two axes across the normal. The first turns counter-clockwise to the second.
void EarClipping::flatten() {
    const Eigen::Vector3d normal = to_vector(view_.normal).cast<double>().normalized();
    const Eigen::Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);
    double farthest = 0;
    for (const Vec3& corner : view_.outline) {
        const Eigen::Vector3d p = difference(corner, view_.outline[0]);
        points_.emplace_back(first.dot(p), second.dot(p));
        farthest = std::max(farthest, p.norm());
    }
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < blocks_.size(); ++i)
        if (blocks_[i]) corners.push_back(i);
    constexpr double rounding = 64 * 0x1p-53;  // three times that of some twenty operations
    blocking_.emplace(points_, std::move(corners), rounding * farthest);
}

/// Whether the way to corner `to` goes into the triangle, from a corner on its border with these sides.
bool EarClipping::enters(const Triangle& triangle, const Sides& sides, std::uint32_t to) const {
    for (std::size_t i = 0; i < 3; ++i)
        if (sides[i] == 0 && view_.turn(triangle[i], triangle[(i + 1) % 3], to) <= 0) return false;
    return true;
}

EarClipping::Room EarClipping::room_beside(const Triangle& triangle, std::uint32_t corner) const {
    Sides sides;
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] = view_.turn(triangle[i], triangle[(i + 1) % 3], corner);
        if (sides[i] < 0) return Room::free;
    }
    if (enters(triangle, sides, before_[corner]) || enters(triangle, sides, after_[corner]))
        return Room::blocked;
    if (sides[0] > 0 && sides[1] > 0) return sides[2] > 0 ? Room::blocked : Room::touched;
    return Room::free;
}

/// Corners at the positions of the ear's own, or on its two edges, block it only where the outline goes on
/// into it. Corners on the edge that the cut would make are avoided while others can be cut: the edge would
/// pass through them.
EarClipping::Room EarClipping::room_of(const Triangle& corners) {
    const auto [before, corner, after] = corners;
    // Counter-clockwise, the edge that the cut makes being the last.
    const Triangle triangle = side_ == inside ? corners : Triangle{after, corner, before};
    const Sides of_first{0, 1, 0}, of_last{1, 0, 0};
    if (enters(triangle, side_ == inside ? of_first : of_last, before_[before]) ||
        enters(triangle, side_ == inside ? of_last : of_first, after_[after]))
        return Room::blocked;
    if (looks_left_ == 0) return Room::blocked;
    if (!blocking_) flatten();
    Room room = Room::free;
    const auto visit = [&](std::uint32_t other) {
        if (std::ranges::find(corners, other) == corners.end())
            room = std::max(room, room_beside(triangle, other));
        return room == Room::blocked;
    };
    const std::size_t looks =
        blocking_->search({points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]}, visit);
    looks_left_ -= std::min(looks, looks_left_);
    return looks_left_ == 0 ? Room::blocked : room;
}

void EarClipping::cut(std::uint32_t corner) {
    const std::uint32_t before = before_[corner], after = after_[corner];
    is_cut_[corner] = true;
    --left_;
    after_[before] = after;
    before_[after] = before;
    unblock(corner);
    update(before);
    update(after);
}

void EarClipping::update(std::uint32_t corner) {
    const bool was_sharp = turns_[corner] == side_;
    turns_[corner] = static_cast<std::int8_t>(view_.turn(before_[corner], corner, after_[corner]));
    if (turns_[corner] == side_) unblock(corner);
    consider(corner, was_sharp);
}

void EarClipping::unblock(std::uint32_t corner) {
    if (blocks_[corner] && blocking_) blocking_->remove(corner);
    blocks_[corner] = false;
}

}  // namespace

bool triangulate(std::span<const Vec3> outline, std::vector<Triangle>& triangles) {
    const auto corners = static_cast<std::uint32_t>(outline.size());
    cut_convex(corners, triangles);
    if (corners == 3) return true;
    const View view(outline);
    const bool is_right = view.shows_fronts(triangles);
    // Two fronts that share an edge lie side by side; more may lie on each other.
    if ((is_right && corners == 4) || view.doubled == 0) return is_right;
    if (!EarClipping(view, EarClipping::outside).leaves_convex()) return false;
    if (is_right) return true;
    std::vector<Triangle> ears;
    if (!EarClipping(view, EarClipping::inside).cut_all(ears)) return false;
    triangles.swap(ears);
    return true;
}

}  // namespace weft
