#pragma once
// Triangles about a particle, laid flat, and the rotation of tensors from an edge's frame into theirs.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "cloth/mesh/rest/rest_elements.h"
#include "cloth/mesh/rest/rigidity.h"

namespace weft {

/// Turn rotates tensors by an angle, and before that may mirror them in the first axis.
class Turn {
  public:
    Turn() = default;
    explicit Turn(double angle, bool mirrors = false)
        : cosine_(std::cos(2 * angle)), sine_(std::sin(2 * angle)), handedness_(mirrors ? -1 : 1) {}

    Tensor operator*(const Tensor& v) const { return rotated({v.x(), v.y(), handedness_ * v.z()}, sine_); }
    /// Applies the inverse.
    [[nodiscard]] Tensor back(const Tensor& v) const {
        const Tensor turned = rotated(v, -sine_);
        return {turned.x(), turned.y(), handedness_ * turned.z()};
    }
    /// These rotate a cross product of two tensors, whose sign a mirror changes, and rotate it back.
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

/// HingeEnd is one end of a hinge's edge, in the fan of triangles there.
struct HingeEnd {
    std::uint32_t fan = Bending::no_hinge;
    Turn to_fan;  ///< rotates tensors from the hinge's frame, whose x runs along the edge
};

/// Up to three tensors, its columns.
using Tensors = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

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
    std::uint32_t middle = Bending::no_hinge;
    std::vector<End> ends;
    std::vector<Polar> around;
    double angle = 0;  ///< sum over its triangles
    bool is_closed = false;
    /// n n^T of the normals of its borders, along which it bears no moment. A border that hardly turns counts
    /// as straight.
    Tensors free = Tensors(3, 0);
    double area = 0;   ///< a third of its triangles' area [m^2]
    double scale = 0;  ///< 1 / norm of its hinges' f
};

/// All fans of a mesh, and where its hinges lie in them.
struct Fans {
    std::vector<Fan> list;
    std::vector<std::array<HingeEnd, 2>> ends;  ///< of the edges of hinges
};
/// Finds the fans: triangles at a particle are one fan where hinges join them.
[[nodiscard]] Fans find_fans(const ClothModel& model, const Bending& bending);

}  // namespace weft
