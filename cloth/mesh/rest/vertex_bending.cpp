#include "cloth/mesh/rest/vertex_bending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

namespace {

constexpr std::uint32_t none = Bending::no_hinge;

using Tensor = Eigen::Vector3d;  // xx, yy, sqrt 2 xy
/// Orthonormal columns: the moments that a fan can bear.
using Bearing = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

/// Turn rotates tensors by an angle, and before that may mirror them in the first axis.
class Turn {
  public:
    Turn() = default;
    explicit Turn(double angle, bool mirrors = false)
        : cosine_(std::cos(2 * angle)), sine_(std::sin(2 * angle)), handedness_(mirrors ? -1 : 1) {}

    Tensor operator*(const Tensor& v) const { return rotated({v.x(), v.y(), handedness_ * v.z()}, sine_); }
    [[nodiscard]] Tensor back(const Tensor& v) const {
        const Tensor turned = rotated(v, -sine_);
        return {turned.x(), turned.y(), handedness_ * turned.z()};
    }
    /// Of a cross product of tensors.
    [[nodiscard]] Eigen::Vector3d of_axis(const Eigen::Vector3d& v) const {
        return handedness_ * (*this * v);
    }
    [[nodiscard]] Eigen::Vector3d axis_back(const Eigen::Vector3d& v) const { return handedness_ * back(v); }
    [[nodiscard]] Eigen::Matrix3d matrix() const {
        Eigen::Matrix3d m;
        m << *this * Tensor::UnitX(), *this * Tensor::UnitY(), *this * Tensor::UnitZ();
        return m;
    }

  private:
    [[nodiscard]] Tensor rotated(const Tensor& v, double sine) const {
        const double mean = (v.x() + v.y()) / 2, differs = (v.x() - v.y()) / 2;
        const double shear = v.z() / std::numbers::sqrt2;
        const double along = differs * cosine_ - shear * sine, aside = differs * sine + shear * cosine_;
        return {mean + along, mean - along, std::numbers::sqrt2 * aside};
    }
    double cosine_ = 1, sine_ = 0, handedness_ = 1;
};

/// n n^T of the normal of an edge at that angle.
Tensor across(double angle) {
    return Turn(angle) * Tensor(0, 1, 0);
}

/// HingeEnd is one end of a hinge's edge, in the fan of triangles there.
struct HingeEnd {
    std::uint32_t fan = none;
    Turn to_fan;                    ///< of tensors, from the hinge's frame
    Tensor share = Tensor::Zero();  ///< p, in the hinge's frame
};

struct SharedEdge {
    std::array<HingeEnd, 2> ends;
    Tensor f = Tensor::Zero();       ///< in the hinge's frame
    Tensor passed = Tensor::Zero();  ///< from the second end's share to the first's
    std::uint32_t exchange = none;   ///< at a border, in Plate::exchanges_: what both ends can bear
};

/// A fan is a set of triangles at a particle that share edges there, laid flat.
struct Fan {
    struct End {
        std::uint32_t hinge, end;
    };
    /// A neighbour, from the particle at the fan's middle.
    struct Polar {
        std::uint32_t particle;
        double angle, radius;  ///< [m]
    };
    std::uint32_t middle = none;
    std::vector<End> ends;
    std::vector<Polar> around;
    double angle = 0;  ///< of all its triangles
    bool is_closed = false;
    Bearing bears = Eigen::Matrix3d::Identity();
    double area = 0;   ///< a third of its triangles' [m^2]
    double scale = 0;  ///< 1 / norm of its f
};

/// A corner is one triangle at a particle.
struct Corner {
    struct Side {
        std::uint32_t hinge, particle;  ///< or no hinge, at a border; the side's other end
        double length;                  ///< [m]
    };
    Side forth, back;  ///< that it begins and ends, as it is wound
    double angle, area;
    bool is_used = false;
};

/// Distance of two neighbours in the fan, laid flat [m].
double distance_in(const Fan& fan, const Fan::Polar& one, const Fan::Polar& other) {
    double between = std::abs(one.angle - other.angle);
    if (fan.is_closed) between = std::min(between, fan.angle - between);
    between = std::min(between, std::numbers::pi);
    const double x = one.radius - other.radius * std::cos(between), y = other.radius * std::sin(between);
    return std::sqrt(x * x + y * y);
}

/// The c_i of a fan's three elements, in this order: of the particle in its middle, and of those around it.
using ElementsOfFan = std::vector<Eigen::Vector3d>;

/// Sums up what joins particles.
class PairSums {
  public:
    explicit PairSums(std::uint32_t particles)
        : first_(particles, none), own_(particles), excess_(particles) {}

    void add(const Fan& fan, const ElementsOfFan& c);
    /// Ascending, without those whose terms cancel.
    [[nodiscard]] std::vector<BendingPair> pairs() const;
    [[nodiscard]] std::vector<double>&& excess() { return std::move(excess_); }

  private:
    struct Sum {
        BendingPair pair;
        std::uint32_t next;  // of the same i
    };
    void add(const BendingPair& term);

    std::vector<Sum> sums_;
    std::vector<std::uint32_t> first_;  // by i, in sums_
    std::vector<double> own_;           // by particle: sum of c_i^2
    std::vector<double> excess_;
};

void PairSums::add(const BendingPair& term) {
    std::uint32_t* at = &first_[term.i];
    while (*at != none && sums_[*at].pair.j != term.j) at = &sums_[*at].next;
    if (*at == none) {
        *at = static_cast<std::uint32_t>(sums_.size());
        sums_.push_back({term, none});
        return;
    }
    BendingPair& sum = sums_[*at].pair;
    sum.weight += term.weight;
    sum.length = std::min(sum.length, term.length);
}

void PairSums::add(const Fan& fan, const ElementsOfFan& c) {
    Eigen::Array3d positive = Eigen::Array3d::Zero();
    for (const Eigen::Vector3d& of_i : c) positive += of_i.array().max(0);
    for (std::size_t k = 0; k < c.size(); ++k) {
        const std::uint32_t i = k == 0 ? fan.middle : fan.around[k - 1].particle;
        const Eigen::Array3d size = c[k].array().abs();
        own_[i] += c[k].squaredNorm();
        excess_[i] += (size * (positive - size).max(0)).sum();
        for (std::size_t m = k + 1; m < c.size(); ++m) {
            const Fan::Polar& other = fan.around[m - 1];
            add({.i = std::min(i, other.particle),
                 .j = std::max(i, other.particle),
                 .weight = -c[k].dot(c[m]),
                 .length = k == 0 ? other.radius : distance_in(fan, fan.around[k - 1], other)});
        }
    }
}

std::vector<BendingPair> PairSums::pairs() const {
    constexpr double rounding = 3e-7;  // of q, which are floats
    std::vector<BendingPair> pairs;
    pairs.reserve(sums_.size());
    for (const std::uint32_t first : first_) {
        const std::size_t begin = pairs.size();
        for (std::uint32_t k = first; k != none; k = sums_[k].next) {
            const BendingPair& sum = sums_[k].pair;
            if (std::abs(sum.weight) > rounding * std::sqrt(own_[sum.i] * own_[sum.j])) pairs.push_back(sum);
        }
        std::ranges::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end(), {},
                          &BendingPair::j);
    }
    return pairs;
}

class Plate {
  public:
    explicit Plate(const ClothModel& model) : model_(model), bending_(bending_elements(model)) {}

    VertexBending operator()() {
        fans_.reserve(model_.particle_count);
        edges_.resize(bending_.hinges.size());
        for (std::size_t h = 0; h < edges_.size(); ++h) edges_[h].f = curvature_of(bending_.hinges[h]);
        for (std::uint32_t i = 0; i < model_.particle_count; ++i) find_fans(i);
        share_out();
        balance();
        return sum_up();
    }

  private:
    /// f: sum_k q_k x_k on a sheet, per unit of its curvatures xx, yy and sqrt 2 xy [m^2].
    static Tensor curvature_of(const Hinge& hinge) {
        const std::array<Eigen::Vector2d, 4> at = flat_hinge(hinge);
        Tensor f = Tensor::Zero();
        for (std::size_t k = 0; k < 4; ++k) {
            const double x = at[k].x(), y = at[k].y();
            f += static_cast<double>(hinge.q[k]) * Tensor(x * x / 2, y * y / 2, x * y / std::numbers::sqrt2);
        }
        return f;
    }
    void find_fans(std::uint32_t particle);
    void list_corners(std::uint32_t particle);
    void walk(std::uint32_t particle, std::size_t first, bool is_closed);
    void meet(std::uint32_t hinge, std::uint32_t particle, double angle, bool apex_0_is_before);
    void share_out();
    void balance();
    std::uint32_t find_elements(const Fan& fan, ElementsOfFan& c) const;
    [[nodiscard]] VertexBending sum_up() const;

    static bool bears_all(const Fan& fan) { return fan.bears.cols() == 3; }
    /// Projects the axis of an antisymmetric tensor onto the moments that the fan can bear.
    static Eigen::Vector3d within(const Fan& fan, const Eigen::Vector3d& axis) {
        if (bears_all(fan)) return axis;
        if (fan.bears.cols() < 2) return Eigen::Vector3d::Zero();
        const Eigen::Vector3d normal =
            Eigen::Vector3d(fan.bears.col(0)).cross(Eigen::Vector3d(fan.bears.col(1)));
        return normal.dot(axis) * normal;
    }
    using Axes = std::vector<Eigen::Vector3d>;
    [[nodiscard]] Axes twist_of(const std::vector<Tensor>& passed) const;
    [[nodiscard]] std::vector<Tensor> pull_back(const Axes& axes) const;

    const ClothModel& model_;
    Bending bending_;
    std::vector<SharedEdge> edges_;
    std::vector<Eigen::Matrix3d> exchanges_;
    std::vector<Fan> fans_;
    std::vector<Corner> corners_;
};

void Plate::list_corners(std::uint32_t particle) {
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

void Plate::find_fans(std::uint32_t particle) {
    list_corners(particle);
    for (const bool is_closed : {false, true})
        for (std::size_t c = 0; c < corners_.size(); ++c)
            if (!corners_[c].is_used &&
                (is_closed || corners_[c].forth.hinge == none || corners_[c].back.hinge == none))
                walk(particle, c, is_closed);
}

/// The particle is an end of the hinge's edge, which lies at that angle in the fan that was begun last. The
/// hinge's first apex is in the triangle before the edge, or in that behind it.
void Plate::meet(std::uint32_t hinge, std::uint32_t particle, double angle, bool apex_0_is_before) {
    const std::uint32_t end = bending_.hinges[hinge].particles[0] == particle ? 0 : 1;
    HingeEnd& here = edges_[hinge].ends[end];
    here.fan = static_cast<std::uint32_t>(fans_.size()) - 1;
    here.to_fan = Turn(angle, (end == 0) == apex_0_is_before);
    fans_.back().ends.push_back({hinge, end});
}

/// Goes from triangle to triangle, beginning at a border if there is one.
void Plate::walk(std::uint32_t particle, std::size_t first, bool is_closed) {
    Fan& fan = fans_.emplace_back();
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
    // Along the way in which the first triangle is wound, unless that comes from the border.
    Corner::Side from = is_closed || corner->forth.hinge == none ? corner->forth : corner->back;
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
            if (from.hinge != none && !other.is_used &&
                (other.forth.hinge == from.hinge || other.back.hinge == from.hinge))
                corner = &other;
        if (is_closed && corner == nullptr) break;  // back where it began
        fan.around.push_back({from.particle, fan.angle, from.length});
        if (from.hinge != none) met.push_back({from.hinge, fan.angle, first_apex(from.hinge) == apex});
    }
    const double scale = is_closed ? 2 * std::numbers::pi / fan.angle : 1;
    for (const auto& [hinge, at, before] : met) meet(hinge, particle, scale * at, before);
    if (is_closed) return;
    // A border bears no moment about itself. One that hardly turns is straight.
    Eigen::Matrix<double, 3, Eigen::Dynamic> free(3, 0);
    if (std::abs(fan.angle - std::numbers::pi) < std::numbers::pi / 6) {
        free.resize(3, 1);
        free.col(0) = across((fan.angle - std::numbers::pi) / 2);
    } else {
        free.resize(3, 2);
        free.col(0) = across(0);
        free.col(1) = across(fan.angle);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> split(free.transpose(), Eigen::ComputeFullV);
    fan.bears = split.matrixV().rightCols(3 - free.cols());
}

/// Each edge's n n^T by halves, but where one end cannot bear its half, by what the other can.
void Plate::share_out() {
    const Tensor all(0, 1, 0);
    for (SharedEdge& edge : edges_) {
        if (std::ranges::all_of(edge.ends, [&](const HingeEnd& end) { return bears_all(fans_[end.fan]); })) {
            for (HingeEnd& end : edge.ends) end.share = 0.5 * all;
            continue;
        }
        std::array<Eigen::Matrix3d, 2> bears;
        for (std::size_t k = 0; k < 2; ++k) {
            const HingeEnd& end = edge.ends[k];
            const Bearing& of_fan = fans_[end.fan].bears;
            const Eigen::Matrix3d to_fan = end.to_fan.matrix();
            bears[k] = to_fan.transpose() * (of_fan * of_fan.transpose()) * to_fan;
        }
        for (std::size_t k = 0; k < 2; ++k)
            edge.ends[k].share = bears[k] * (0.5 * all + 0.5 * (all - bears[1 - k] * all));
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> both(bears[0] + bears[1]);
        edge.exchange = static_cast<std::uint32_t>(exchanges_.size());
        Eigen::Matrix3d& exchange = exchanges_.emplace_back(Eigen::Matrix3d::Zero());
        for (Eigen::Index z = 0; z < 3; ++z)
            if (both.eigenvalues()[z] > 1.999)
                exchange += both.eigenvectors().col(z) * both.eigenvectors().col(z).transpose();
    }
    for (Fan& fan : fans_) {
        double squares = 0;
        for (const auto& [hinge, end] : fan.ends) squares += edges_[hinge].f.squaredNorm();
        fan.scale = squares > 0 ? 1 / std::sqrt(squares) : 0;
    }
}

/// What each fan's A gains that is antisymmetric if each edge passes so much from one end to the other: the
/// sum of f x p, which turns as tensors do.
Plate::Axes Plate::twist_of(const std::vector<Tensor>& passed) const {
    Axes axes(fans_.size(), Eigen::Vector3d::Zero());
    for (std::size_t h = 0; h < edges_.size(); ++h) {
        const Eigen::Vector3d axis = edges_[h].f.cross(passed[h]);
        const auto& [first, second] = edges_[h].ends;
        axes[first.fan] += first.to_fan.of_axis(axis);
        axes[second.fan] -= second.to_fan.of_axis(axis);
    }
    for (std::size_t n = 0; n < fans_.size(); ++n) axes[n] = fans_[n].scale * within(fans_[n], axes[n]);
    return axes;
}

/// The transpose of twist_of().
std::vector<Tensor> Plate::pull_back(const Axes& axes) const {
    Axes of_fans(fans_.size());
    for (std::size_t n = 0; n < fans_.size(); ++n) of_fans[n] = fans_[n].scale * within(fans_[n], axes[n]);
    std::vector<Tensor> passed(edges_.size());
    for (std::size_t h = 0; h < edges_.size(); ++h) {
        const auto& [first, second] = edges_[h].ends;
        const Eigen::Vector3d axis =
            first.to_fan.axis_back(of_fans[first.fan]) - second.to_fan.axis_back(of_fans[second.fan]);
        passed[h] = axis.cross(edges_[h].f);
        if (edges_[h].exchange != none) passed[h] = exchanges_[edges_[h].exchange] * passed[h];
    }
    return passed;
}

template <class Vectors>
double squares_of(const Vectors& vectors) {
    double sum = 0;
    for (const auto& v : vectors) sum += v.squaredNorm();
    return sum;
}

/// Makes A symmetric in all fans by the least exchange: conjugate gradients on the least squares.
void Plate::balance() {
    constexpr int iterations = 10;
    Axes left(fans_.size());
    for (std::size_t n = 0; n < fans_.size(); ++n) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [hinge, end] : fans_[n].ends) {
            const HingeEnd& of = edges_[hinge].ends[end];
            sum -= of.to_fan.of_axis(edges_[hinge].f.cross(of.share));
        }
        left[n] = fans_[n].scale * within(fans_[n], sum);
    }
    std::vector<Tensor> slope = pull_back(left), direction = slope;
    double size = squares_of(slope);
    // Where nothing but rounding is left, directions would be noise. All of this has no unit.
    const double least = std::max(1e-12 * size, 1e-24 * static_cast<double>(edges_.size()));
    for (int k = 0; k < iterations && size > least; ++k) {
        const Axes changed = twist_of(direction);
        const double squares = squares_of(changed);
        if (!(squares > 0)) break;
        const double step = size / squares;
        for (std::size_t h = 0; h < edges_.size(); ++h) edges_[h].passed += step * direction[h];
        for (std::size_t n = 0; n < fans_.size(); ++n) left[n] -= step * changed[n];
        slope = pull_back(left);
        const double next = squares_of(slope);
        for (std::size_t h = 0; h < edges_.size(); ++h) direction[h] = slope[h] + next / size * direction[h];
        size = next;
    }
    for (SharedEdge& edge : edges_) {
        edge.ends[0].share += edge.passed;
        edge.ends[1].share -= edge.passed;
    }
}

/// The c_i of up to three elements, and how many these are; those of others are 0.
std::uint32_t Plate::find_elements(const Fan& fan, ElementsOfFan& c) const {
    constexpr double least = 0.05;  // eigenvalue of A, of the fan's area: else its inverse is too stiff
    c.assign(fan.around.size() + 1, Eigen::Vector3d::Zero());
    const Eigen::Matrix3d bears = fan.bears * fan.bears.transpose();
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    for (const auto& [hinge, end] : fan.ends) {
        const HingeEnd& of = edges_[hinge].ends[end];
        a += (bears * (of.to_fan * edges_[hinge].f)) * (bears * (of.to_fan * of.share)).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes((a + a.transpose()) / 2);
    const Eigen::Vector3d scale = axes.eigenvalues().cwiseMax(least * fan.area).cwiseSqrt().cwiseInverse();
    const Eigen::Matrix3d to_parts = axes.eigenvectors().transpose() * bears;
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const auto& [hinge, end] : fan.ends) {
        const HingeEnd& of = edges_[hinge].ends[end];
        const Eigen::Vector3d along = to_parts * (of.to_fan * of.share);
        squares += along.cwiseAbs2();
        const Hinge& here = bending_.hinges[hinge];
        const Eigen::Vector3d parts = static_cast<double>(here.softening) * scale.cwiseProduct(along);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto at = std::ranges::find(fan.around, here.particles[k], &Fan::Polar::particle);
            const bool is_middle = here.particles[k] == fan.middle;
            c[is_middle ? 0 : static_cast<std::size_t>(at - fan.around.begin()) + 1] +=
                static_cast<double>(here.q[k]) * parts;
        }
    }
    const Eigen::Array3d are_any = (squares.array() >= 1e-10).cast<double>();
    for (Eigen::Vector3d& of_i : c) of_i.array() *= are_any;
    return static_cast<std::uint32_t>(are_any.sum());
}

VertexBending Plate::sum_up() const {
    VertexBending result;
    PairSums sums(model_.particle_count);
    ElementsOfFan c;
    for (const Fan& fan : fans_) {
        const std::uint32_t elements = find_elements(fan, c);
        if (elements > 0) sums.add(fan, c);
        result.elements += elements;
    }
    result.pairs = sums.pairs();
    result.excess = sums.excess();
    return result;
}

}  // namespace

VertexBending vertex_bending(const ClothModel& model) {
    return Plate(model)();
}

}  // namespace weft
