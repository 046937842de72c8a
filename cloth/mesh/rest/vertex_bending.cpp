#include "cloth/mesh/rest/vertex_bending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "cloth/mesh/rest/fans.h"
#include "cloth/mesh/rest/rest_elements.h"
#include "engine/small_matrices.h"

namespace weft {

namespace {

constexpr std::uint32_t none = Bending::no_hinge;

struct SharedEdge {
    std::array<HingeEnd, 2> ends;
    std::array<Tensor, 2> shares{Tensor::Zero(), Tensor::Zero()};  ///< p of each end, in the hinge's frame
    Tensor whole{0, 1, 0};                                         ///< n n^T, of which both have a share
    Tensor f = Tensor::Zero();                                     ///< in the hinge's frame
    Tensor passed = Tensor::Zero();  ///< moved from the second end's share to the first's
    std::uint32_t exchange = none;  ///< at a border, in Plate::exchanges_: the projection onto what both bear
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

/// Sums the terms of pairs of particles.
class PairSums {
  public:
    explicit PairSums(std::uint32_t particles)
        : begins_(particles + 1), own_(particles), excess_(particles) {}

    void add(const Fan& fan, const ElementsOfFan& c);
    /// The pairs, ascending, without those whose terms cancel.
    [[nodiscard]] std::vector<BendingPair> pairs() const;
    [[nodiscard]] std::vector<double>&& excess() { return std::move(excess_); }

  private:
    [[nodiscard]] std::vector<BendingPair> terms_by_first() const;

    std::vector<BendingPair> terms_;
    std::vector<std::uint32_t> begins_;  // number of terms of particle i, at i + 1
    std::vector<double> own_;            // by particle: sum of c_i^2
    std::vector<double> excess_;
};

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
            const std::uint32_t first = std::min(i, other.particle);
            terms_.push_back({.i = first,
                              .j = std::max(i, other.particle),
                              .weight = -c[k].dot(c[m]),
                              .length = k == 0 ? other.radius : distance_in(fan, fan.around[k - 1], other)});
            ++begins_[first + 1];
        }
    }
}

/// The terms in order of i, and those of one i in the order in which they were added.
std::vector<BendingPair> PairSums::terms_by_first() const {
    std::vector<std::uint32_t> next(begins_.size());
    std::partial_sum(begins_.begin(), begins_.end(), next.begin());
    std::vector<BendingPair> terms(terms_.size());
    for (const BendingPair& term : terms_) terms[next[term.i]++] = term;
    return terms;
}

std::vector<BendingPair> PairSums::pairs() const {
    constexpr double rounding = 3e-7;  // of q, which are floats
    std::vector<BendingPair> terms = terms_by_first(), pairs;
    const auto is_of_other = [](const BendingPair& a, const BendingPair& b) { return a.i != b.i; };
    for (auto begin = terms.begin(); begin != terms.end();) {
        auto end = std::adjacent_find(begin, terms.end(), is_of_other);
        if (end != terms.end()) ++end;
        std::stable_sort(begin, end, [](const BendingPair& a, const BendingPair& b) { return a.j < b.j; });
        while (begin != end) {
            BendingPair sum = *begin;
            for (++begin; begin != end && begin->j == sum.j; ++begin) {
                sum.weight += begin->weight;
                sum.length = std::min(sum.length, begin->length);
            }
            if (std::abs(sum.weight) > rounding * std::sqrt(own_[sum.i] * own_[sum.j])) pairs.push_back(sum);
        }
    }
    return pairs;
}

class Plate {
  public:
    explicit Plate(const ClothModel& model) : model_(model), bending_(bending_elements(model)) {}

    VertexBending operator()() {
        Fans found = find_fans(model_, bending_);
        fans_ = std::move(found.list);
        edges_.resize(bending_.hinges.size());
        for (std::size_t h = 0; h < edges_.size(); ++h) edges_[h].ends = found.ends[h];
        for (std::size_t h = 0; h < edges_.size(); ++h) edges_[h].f = curvature_of(bending_.hinges[h]);
        if (!bending_.rigidities.empty()) weight_by_rigidity();
        find_bearings();
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
    void weight_by_rigidity();
    void find_bearings();
    void share_out();
    void balance();
    std::uint32_t find_elements(std::size_t of, ElementsOfFan& c) const;
    [[nodiscard]] VertexBending sum_up() const;

    static bool bears_all(const Fan& fan) { return fan.free.cols() == 0; }
    /// Projects the axis of an antisymmetric tensor onto the moments that a fan can bear.
    [[nodiscard]] Eigen::Vector3d within(std::size_t fan, const Eigen::Vector3d& axis) const {
        const Tensors& bears = bearings_[fan];
        if (bears.cols() == 3) return axis;
        if (bears.cols() < 2) return Eigen::Vector3d::Zero();
        const Eigen::Vector3d normal = Tensor(bears.col(0)).cross(Tensor(bears.col(1)));
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
    std::vector<Tensors> bearings_;  // of fans: orthonormal, the moments that each can bear
};

/// Changes variables: curvatures become D^1/2 K, and moments D^-1/2 M, by the mean D of the hinges at a fan.
void Plate::weight_by_rigidity() {
    const auto root_of = [](const Rigidity& d) {
        const SymmetricAxes axes = symmetric_axes(d);
        return Rigidity(axes.vectors * axes.values.cwiseSqrt().asDiagonal() * axes.vectors.transpose());
    };
    for (std::size_t h = 0; h < edges_.size(); ++h) {
        const Rigidity root = root_of(bending_.rigidities[h]);
        edges_[h].whole = root * edges_[h].whole;
        edges_[h].f = root.inverse() * edges_[h].f;
    }
    for (Fan& fan : fans_) {
        if (bears_all(fan) || fan.ends.empty()) continue;
        Rigidity sum = Rigidity::Zero();
        for (const auto& [hinge, end] : fan.ends) {
            const Eigen::Matrix3d to_fan = edges_[hinge].ends[end].to_fan.matrix();
            sum += to_fan * bending_.rigidities[hinge] * to_fan.transpose();
        }
        fan.free = root_of(sum / static_cast<double>(fan.ends.size())) * fan.free;
    }
}

/// A fan bears the moments that are normal to n n^T of its borders.
void Plate::find_bearings() {
    bearings_.reserve(fans_.size());
    for (const Fan& fan : fans_) {
        if (bears_all(fan)) {
            bearings_.push_back(Eigen::Matrix3d::Identity());
            continue;
        }
        const Eigen::Vector3d first = fan.free.col(0).normalized();
        Tensors bears(3, 3 - fan.free.cols());
        if (bears.cols() == 1) {
            bears.col(0) = first.cross(Eigen::Vector3d(fan.free.col(1))).normalized();
        } else {
            const Eigen::Vector3d across = first.unitOrthogonal();
            bears << across, first.cross(across);
        }
        bearings_.push_back(bears);
    }
}

/// Shares each edge's n n^T by halves. The part that one end cannot bear goes to the other, if that can.
void Plate::share_out() {
    for (SharedEdge& edge : edges_) {
        const Tensor& whole = edge.whole;
        if (std::ranges::all_of(edge.ends, [&](const HingeEnd& end) { return bears_all(fans_[end.fan]); })) {
            edge.shares = {0.5 * whole, 0.5 * whole};
            continue;
        }
        std::array<Eigen::Matrix3d, 2> bears;
        for (std::size_t k = 0; k < 2; ++k) {
            const HingeEnd& end = edge.ends[k];
            const Tensors& of_fan = bearings_[end.fan];
            const Eigen::Matrix3d to_fan = end.to_fan.matrix();
            bears[k] = to_fan.transpose() * (of_fan * of_fan.transpose()) * to_fan;
        }
        for (std::size_t k = 0; k < 2; ++k)
            edge.shares[k] = bears[k] * (0.5 * whole + 0.5 * (whole - bears[1 - k] * whole));
        const SymmetricAxes both = symmetric_axes(bears[0] + bears[1]);
        edge.exchange = static_cast<std::uint32_t>(exchanges_.size());
        Eigen::Matrix3d& exchange = exchanges_.emplace_back(Eigen::Matrix3d::Zero());
        for (Eigen::Index z = 0; z < 3; ++z)
            if (both.values[z] > 1.999) exchange += both.vectors.col(z) * both.vectors.col(z).transpose();
    }
    for (Fan& fan : fans_) {
        double squares = 0;
        for (const auto& [hinge, end] : fan.ends) squares += edges_[hinge].f.squaredNorm();
        fan.scale = squares > 0 ? 1 / std::sqrt(squares) : 0;
    }
}

/// The twist of a fan is the antisymmetric part that its A gains if each edge moves `passed` from the second
/// end to the first. It is the sum of f x p, which turns as tensors do.
Plate::Axes Plate::twist_of(const std::vector<Tensor>& passed) const {
    Axes axes(fans_.size(), Eigen::Vector3d::Zero());
    for (std::size_t h = 0; h < edges_.size(); ++h) {
        const Eigen::Vector3d axis = edges_[h].f.cross(passed[h]);
        const auto& [first, second] = edges_[h].ends;
        axes[first.fan] += first.to_fan.of_axis(axis);
        axes[second.fan] -= second.to_fan.of_axis(axis);
    }
    for (std::size_t n = 0; n < fans_.size(); ++n) axes[n] = fans_[n].scale * within(n, axes[n]);
    return axes;
}

/// The transpose of twist_of().
std::vector<Tensor> Plate::pull_back(const Axes& axes) const {
    Axes of_fans(fans_.size());
    for (std::size_t n = 0; n < fans_.size(); ++n) of_fans[n] = fans_[n].scale * within(n, axes[n]);
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
            const SharedEdge& edge = edges_[hinge];
            sum -= edge.ends[end].to_fan.of_axis(edge.f.cross(edge.shares[end]));
        }
        left[n] = fans_[n].scale * within(n, sum);
    }
    std::vector<Tensor> slope = pull_back(left), direction = slope;
    double size = squares_of(slope);
    // When only rounding is left, directions would be noise. These numbers have no unit.
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
        edge.shares[0] += edge.passed;
        edge.shares[1] -= edge.passed;
    }
}

/// Finds the c_i of a fan's up to three elements and returns how many there are; those of others are 0.
std::uint32_t Plate::find_elements(std::size_t of, ElementsOfFan& c) const {
    const Fan& fan = fans_[of];
    constexpr double least = 0.05;  // eigenvalue of A over the fan's area: with less its inverse is too stiff
    c.assign(fan.around.size() + 1, Eigen::Vector3d::Zero());
    const Eigen::Matrix3d bears = bearings_[of] * bearings_[of].transpose();
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    for (const auto& [hinge, end] : fan.ends) {
        const SharedEdge& edge = edges_[hinge];
        const Turn& to_fan = edge.ends[end].to_fan;
        a += (bears * (to_fan * edge.f)) * (bears * (to_fan * edge.shares[end])).transpose();
    }
    const SymmetricAxes axes = symmetric_axes((a + a.transpose()) / 2);
    const Eigen::Vector3d scale = axes.values.cwiseMax(least * fan.area).cwiseSqrt().cwiseInverse();
    const Eigen::Matrix3d to_parts = axes.vectors.transpose() * bears;
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const auto& [hinge, end] : fan.ends) {
        const SharedEdge& edge = edges_[hinge];
        const Eigen::Vector3d along = to_parts * (edge.ends[end].to_fan * edge.shares[end]);
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
    for (std::size_t n = 0; n < fans_.size(); ++n) {
        const std::uint32_t elements = find_elements(n, c);
        if (elements > 0) sums.add(fans_[n], c);
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
