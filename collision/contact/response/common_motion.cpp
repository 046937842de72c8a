#include "collision/contact/response/common_motion.h"

#include <cmath>
#include <Eigen/LU>

#include "engine/small_matrices.h"

namespace weft {

namespace {

using Vector3d = Eigen::Vector3d;
using Matrix3d = Eigen::Matrix3d;

// Fraction of the mean square extent that is added in every direction. The map of a sheet of 1 m then follows
// the rigid motion across layers less than 0.1 mm thick in all, and the layers' own across thicker ones.
constexpr double regularisation = 1e-8;

// Least sum of singular values, as a fraction of the largest, that determines the rotation about an axis.
constexpr double no_extent = 1e-6;

bool is_finite(const Vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The first finite position, the origin of sums: from a distant origin they would lose the extents.
Vec4 point_near(std::span<const ParticleRange> group, std::span<const Vec4> positions) {
    for (const ParticleRange& range : group) {
        for (const Vec4& x : positions.subspan(range.first, range.count)) {
            if (is_finite(x)) return x;
        }
    }
    return {};
}

/// Finds the rotation nearest to a covariance of places after and before (Kabsch, 1976). Returns false if a
/// whole family is equally near.
bool nearest_rotation(const Matrix3d& covariance, Matrix3d& rotation) {
    const SingularValues svd = singular_values(covariance);
    const Vector3d& s = svd.values;
    const double side = (svd.u * svd.v.transpose()).determinant() < 0 ? -1 : 1;
    if (!(s[1] + side * s[2] > no_extent * s[0])) return false;
    rotation = svd.u * Vector3d(1, 1, side).asDiagonal() * svd.v.transpose();
    return true;
}

bool keeps_its_orientation_well(const Matrix3d& map) {
    if (!map.allFinite()) return false;
    const Vector3d s = singular_values(map).values;
    return map.determinant() > 0 && s[2] >= CommonMotionFit::least_scale &&
           s[0] <= CommonMotionFit::most_scale;
}

void set_map(CommonMotion& motion, const Matrix3d& map, CommonMotionKind kind) {
    motion.linear = (map - Matrix3d::Identity()).cast<float>();
    motion.inverse = map.inverse().cast<float>();
    motion.kind = kind;
}

}  // namespace

void CommonMotionFit::lay_out(Scratch& scratch, std::size_t particles, std::size_t ranges) {
    scratch.take(partials_, block_count(static_cast<std::uint32_t>(particles)) + ranges);
}

CommonMotionFit::Moments CommonMotionFit::add(const Moments& a, const Moments& b) {
    Moments sum = a;
    sum.count += b.count;
    for (int i = 0; i < 3; ++i) {
        sum.u[i] += b.u[i];
        sum.v[i] += b.v[i];
        for (int j = 0; j < 3; ++j) {
            sum.uu[i][j] += b.uu[i][j];
            sum.vu[i][j] += b.vu[i][j];
        }
    }
    return sum;
}

CommonMotion CommonMotionFit::fit(Parallel& parallel, std::span<const ParticleRange> group,
                                  std::span<const Vec4> positions, std::span<const Vec4> displacements,
                                  CommonMotionKind most) {
    const Vec4 near = point_near(group, positions);
    const auto sum_block = [&](const BlockRange& block) {
        Moments sum;
        for (std::uint32_t p = block.begin; p < block.end; ++p) {
            const Vec4 &x = positions[p], &d = displacements[p];
            if (!is_finite(x) || !is_finite(d)) continue;
            const double u[3] = {double{x.x} - double{near.x}, double{x.y} - double{near.y},
                                 double{x.z} - double{near.z}};
            const double v[3] = {double{d.x}, double{d.y}, double{d.z}};
            sum.count += 1;
            for (int i = 0; i < 3; ++i) {
                sum.u[i] += u[i];
                sum.v[i] += v[i];
                for (int j = 0; j < 3; ++j) {
                    sum.uu[i][j] += u[i] * u[j];
                    sum.vu[i][j] += v[i] * u[j];
                }
            }
        }
        return sum;
    };
    const Moments sums = reduce_ranges(parallel, group, partials_.span(), Moments{}, sum_block, add);

    CommonMotion motion;
    if (sums.count == 0) return motion;
    const Vector3d u = Vector3d(sums.u) / sums.count, v = Vector3d(sums.v) / sums.count;
    motion.kind = CommonMotionKind::translation;
    motion.centre = (u + xyz(near).cast<double>()).cast<float>();
    motion.translation = v.cast<float>();
    if (!motion.centre.allFinite() || !motion.translation.allFinite()) return {};

    Matrix3d extents, changes;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            extents(i, j) = sums.uu[i][j] / sums.count - u[i] * u[j];
            changes(i, j) = sums.vu[i][j] / sums.count - v[i] * u[j];
        }
    }
    Matrix3d rotation;
    if (!extents.allFinite() || !changes.allFinite()) return motion;
    if (!nearest_rotation(extents + changes, rotation)) return motion;
    // Cloth that flies through another in one step would look like both turning about each other.
    const bool is_a_quarter_turn = !(rotation.trace() > 1);
    if (is_a_quarter_turn) return motion;
    const double added = regularisation * extents.trace();
    const Matrix3d map =
        (extents + changes + added * rotation) * (extents + added * Matrix3d::Identity()).inverse();
    if (most == CommonMotionKind::affine && keeps_its_orientation_well(map)) {
        set_map(motion, map, CommonMotionKind::affine);
    } else {
        set_map(motion, rotation, CommonMotionKind::rigid);
    }
    return motion;
}

void take_out(Parallel& parallel, const CommonMotion& common, std::span<const ParticleRange> group,
              std::span<const Vec4> positions, std::span<const Vec4> displacements,
              std::span<Vec4> relative) {
    for_ranges(parallel, group, [&](const BlockRange& block) {
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            const Vector3 left = xyz(displacements[i]) - common.of(xyz(positions[i]));
            set_xyz(relative[i], common.inverse * left);
        }
    });
}

}  // namespace weft
