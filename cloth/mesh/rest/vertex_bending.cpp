#include "cloth/mesh/rest/vertex_bending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Dense>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

namespace {

constexpr std::uint32_t none = Bending::no_hinge;

using Tensor = Eigen::Vector3d;  // xx, yy, sqrt 2 xy
/// Orthonormal columns: the moments that a fan can bear.
using Bearing = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

/// Rotates a tensor by an angle.
Eigen::Matrix3d turn(double angle) {
    const double c = std::cos(angle), s = std::sin(angle), r = std::numbers::sqrt2;
    Eigen::Matrix3d m;
    m << c * c, s * s, -r * c * s,  //
        s * s, c * c, r * c * s,    //
        r * c * s, -r * c * s, c * c - s * s;
    return m;
}

/// n n^T of the normal of an edge at that angle.
Tensor across(double angle) {
    return turn(angle) * Tensor(0, 1, 0);
}

/// HingeEnd is one end of a hinge's edge, in the fan of triangles there.
struct HingeEnd {
    std::uint32_t fan = none;
    Eigen::Matrix3d to_fan = Eigen::Matrix3d::Identity();  ///< of tensors, from the hinge's frame
    Tensor share = Tensor::Zero();                         ///< p, in the hinge's frame
};

struct SharedEdge {
    std::array<HingeEnd, 2> ends;
    Tensor f = Tensor::Zero();                                ///< in the hinge's frame
    Eigen::Matrix3d exchanged = Eigen::Matrix3d::Identity();  ///< on what both ends can bear
    Tensor passed = Tensor::Zero();                           ///< from the second end's share to the first's
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
double distance_in(const Fan& fan, std::uint32_t i, std::uint32_t j) {
    const auto at = [&](std::uint32_t particle) {
        return std::ranges::find(fan.around, particle, &Fan::Polar::particle);
    };
    const auto one = at(i), other = at(j);
    if (one == fan.around.end()) return other->radius;
    if (other == fan.around.end()) return one->radius;
    double between = std::abs(one->angle - other->angle);
    if (fan.is_closed) between = std::min(between, fan.angle - between);
    return std::hypot(one->radius - other->radius * std::cos(std::min(between, std::numbers::pi)),
                      other->radius * std::sin(std::min(between, std::numbers::pi)));
}

class Plate {
  public:
    explicit Plate(const ClothModel& model) : model_(model), bending_(bending_elements(model)) {}

    VertexBending operator()() {
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
    using Element = std::vector<std::pair<std::uint32_t, double>>;  // c_i by particles
    [[nodiscard]] Element element_of(const Fan& fan, const Eigen::VectorXd& parts) const;
    void add(const Fan& fan, const Element& c, VertexBending& to);
    void add_elements(const Fan& fan, VertexBending& to);
    [[nodiscard]] std::vector<BendingPair> merged(std::vector<BendingPair> terms) const;
    VertexBending sum_up();

    /// Projects the axis of an antisymmetric tensor onto the moments that the fan can bear.
    static Eigen::Vector3d within(const Fan& fan, const Eigen::Vector3d& axis) {
        if (fan.bears.cols() == 3) return axis;
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
    std::vector<Fan> fans_;
    std::vector<Corner> corners_;
    std::vector<double> own_;  // sum of c_i^2 of each particle
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
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    if ((end == 0) == apex_0_is_before) mirror(2, 2) = -1;
    HingeEnd& here = edges_[hinge].ends[end];
    here.fan = static_cast<std::uint32_t>(fans_.size()) - 1;
    here.to_fan = turn(angle) * mirror;
    fans_.back().ends.push_back({hinge, end});
}

/// Goes from triangle to triangle, beginning at a border if there is one.
void Plate::walk(std::uint32_t particle, std::size_t first, bool is_closed) {
    Fan& fan = fans_.emplace_back();
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
        std::array<Eigen::Matrix3d, 2> bears;
        for (std::size_t k = 0; k < 2; ++k) {
            const HingeEnd& end = edge.ends[k];
            const Bearing& of_fan = fans_[end.fan].bears;
            bears[k] = end.to_fan.transpose() * (of_fan * of_fan.transpose()) * end.to_fan;
        }
        for (std::size_t k = 0; k < 2; ++k)
            edge.ends[k].share = bears[k] * (0.5 * all + 0.5 * (all - bears[1 - k] * all));
        if (fans_[edge.ends[0].fan].bears.cols() == 3 && fans_[edge.ends[1].fan].bears.cols() == 3) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> both(bears[0] + bears[1]);
        edge.exchanged.setZero();
        for (Eigen::Index z = 0; z < 3; ++z)
            if (both.eigenvalues()[z] > 1.999)
                edge.exchanged += both.eigenvectors().col(z) * both.eigenvectors().col(z).transpose();
    }
    for (Fan& fan : fans_) {
        double squares = 0;
        for (const auto& [hinge, end] : fan.ends) squares += edges_[hinge].f.squaredNorm();
        fan.scale = squares > 0 ? 1 / std::sqrt(squares) : 0;
    }
}

/// The antisymmetric part that each fan's A gains if each edge passes so much from one end to the other.
Plate::Axes Plate::twist_of(const std::vector<Tensor>& passed) const {
    Axes axes(fans_.size());
    for (std::size_t n = 0; n < fans_.size(); ++n) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [hinge, end] : fans_[n].ends) {
            const SharedEdge& edge = edges_[hinge];
            const Eigen::Vector3d axis =
                (edge.ends[end].to_fan * edge.f).cross(edge.ends[end].to_fan * passed[hinge]);
            sum += end == 0 ? axis : Eigen::Vector3d(-axis);
        }
        axes[n] = fans_[n].scale * within(fans_[n], sum);
    }
    return axes;
}

/// The transpose of twist_of().
std::vector<Tensor> Plate::pull_back(const Axes& axes) const {
    std::vector<Tensor> passed(edges_.size());
    for (std::size_t h = 0; h < edges_.size(); ++h) {
        const SharedEdge& edge = edges_[h];
        Tensor sum = Tensor::Zero();
        for (std::size_t k = 0; k < 2; ++k) {
            const HingeEnd& end = edge.ends[k];
            const Fan& fan = fans_[end.fan];
            const Eigen::Vector3d axis = fan.scale * within(fan, axes[end.fan]);
            const Tensor back = end.to_fan.transpose() * axis.cross(end.to_fan * edge.f);
            sum += k == 0 ? back : Tensor(-back);
        }
        passed[h] = edge.exchanged * sum;
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
            sum -= (of.to_fan * edges_[hinge].f).cross(of.to_fan * of.share);
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

/// The c_i of one element: of the hinges' phi times their parts.
Plate::Element Plate::element_of(const Fan& fan, const Eigen::VectorXd& parts) const {
    Element c;
    for (std::size_t e = 0; e < fan.ends.size(); ++e) {
        const Hinge& hinge = bending_.hinges[fan.ends[e].hinge];
        const double part = parts[static_cast<Eigen::Index>(e)] * static_cast<double>(hinge.softening);
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t i = hinge.particles[k];
            const double more = part * static_cast<double>(hinge.q[k]);
            const auto found = std::ranges::find(c, i, &Element::value_type::first);
            if (found != c.end())
                found->second += more;
            else
                c.emplace_back(i, more);
        }
    }
    return c;
}

void Plate::add(const Fan& fan, const Element& c, VertexBending& to) {
    ++to.elements;
    double positive = 0;
    for (const auto& [i, of_i] : c) positive += std::max(of_i, 0.0);
    for (const auto& [i, of_i] : c) {
        own_[i] += of_i * of_i;
        to.excess[i] += std::abs(of_i) * std::max(positive - std::abs(of_i), 0.0);
        for (const auto& [j, of_j] : c)
            if (i < j) to.pairs.push_back({i, j, -of_i * of_j, distance_in(fan, i, j)});
    }
}

/// Adds up to three elements.
void Plate::add_elements(const Fan& fan, VertexBending& to) {
    constexpr double least = 0.05;  // eigenvalue of A, of the fan's area: else its inverse is too stiff
    const Eigen::Index moments = fan.bears.cols(), count = static_cast<Eigen::Index>(fan.ends.size());
    if (moments == 0 || count == 0) return;
    Eigen::MatrixXd f(count, moments), p(count, moments);
    for (Eigen::Index e = 0; e < count; ++e) {
        const auto& [hinge, end] = fan.ends[static_cast<std::size_t>(e)];
        const HingeEnd& of = edges_[hinge].ends[end];
        f.row(e) = (of.to_fan * edges_[hinge].f).transpose() * fan.bears;
        p.row(e) = (of.to_fan * of.share).transpose() * fan.bears;
    }
    const Eigen::MatrixXd a = f.transpose() * p;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes((a + a.transpose()) / 2);
    const Eigen::MatrixXd along = p * axes.eigenvectors();
    for (Eigen::Index z = 0; z < moments; ++z) {
        if (along.col(z).squaredNorm() < 1e-10) continue;
        const double scale = 1 / std::sqrt(std::max(axes.eigenvalues()[z], least * fan.area));
        add(fan, element_of(fan, scale * along.col(z)), to);
    }
}

/// Sums the terms of each pair, and leaves out pairs whose terms cancel.
std::vector<BendingPair> Plate::merged(std::vector<BendingPair> terms) const {
    constexpr double rounding = 3e-7;  // of q, which are floats
    std::vector<BendingPair> pairs;
    std::ranges::stable_sort(terms, [](const BendingPair& l, const BendingPair& r) {
        return std::tie(l.i, l.j) < std::tie(r.i, r.j);
    });
    for (std::size_t first = 0; first < terms.size();) {
        BendingPair sum{terms[first].i, terms[first].j, 0, terms[first].length};
        for (; first < terms.size() && terms[first].i == sum.i && terms[first].j == sum.j; ++first) {
            sum.weight += terms[first].weight;
            sum.length = std::min(sum.length, terms[first].length);
        }
        if (std::abs(sum.weight) > rounding * std::sqrt(own_[sum.i] * own_[sum.j])) pairs.push_back(sum);
    }
    return pairs;
}

VertexBending Plate::sum_up() {
    VertexBending result;
    result.excess.resize(model_.particle_count);
    own_.assign(model_.particle_count, 0);
    for (const Fan& fan : fans_) add_elements(fan, result);
    result.pairs = merged(std::move(result.pairs));
    return result;
}

}  // namespace

VertexBending vertex_bending(const ClothModel& model) {
    return Plate(model)();
}

}  // namespace weft
