#include "demo/character/body/binding.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace weft::demo {
namespace {

constexpr std::size_t nearest_joints = 4;
constexpr float least_distance = 0.01f;  // added to all distances, to keep weights finite [m]

Error misfit(std::size_t point, const std::string& what) {
    return {ErrorCode::invalid_argument, "point " + std::to_string(point) + " " + what};
}

}  // namespace

float part_along(const TaperedCapsule& capsule, const Vector3& point) {
    const Vector3 a = to_vector(capsule.a), axis = to_vector(capsule.b) - a;
    return std::clamp((point - a).dot(axis) / std::max(axis.squaredNorm(), 1e-12f), 0.0f, 1.0f);
}

Binding::Bond Binding::bond(const Pose& pose, const Vector3& point, std::span<const float> weight_of_joint,
                            std::size_t kept) {
    std::vector<std::uint32_t> order(weight_of_joint.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::uint32_t j) { return weight_of_joint[j]; });
    Bond bond;
    float sum = 0;
    kept = std::min(kept, order.size());
    for (std::size_t k = 0; k < kept; ++k) sum += weight_of_joint[order[k]];
    for (std::size_t k = 0; k < most; ++k) {
        const std::uint32_t joint = order[std::min(k, kept - 1)];
        bond.joints[k] = joint;
        bond.weights[k] = k < kept ? weight_of_joint[joint] / sum : 0;
        bond.local[k] = pose.rotations[joint].conjugate() * (point - pose.positions[joint]);
    }
    return bond;
}

Binding Binding::to_nearest(const Body& body, const Pose& pose, std::span<const Vec3> points,
                            Blending blending) {
    std::vector<TaperedCapsule> capsules;
    body.place(pose, 1, capsules);
    Binding binding;
    std::vector<float> weights(pose.positions.size());
    for (const Vec3& p : points) {
        const Vector3 point = to_vector(p);
        std::ranges::fill(weights, 0.0f);
        for (std::size_t limb = 0; limb < capsules.size(); ++limb) {
            const float distance =
                std::max(distance_to(capsules[limb], point).distance, 0.0f) + least_distance;
            const float weight = 1e-8f / (distance * distance * distance * distance);
            const float t = part_along(capsules[limb], point);
            weights[body.limbs()[limb].a.joint] += (1 - t) * weight;
            weights[body.limbs()[limb].b.joint] += t * weight;
        }
        if (blending == Blending::rigid) {
            const auto greatest = std::ranges::max_element(weights) - weights.begin();
            std::ranges::fill(weights, 0.0f);
            weights[static_cast<std::size_t>(greatest)] = 1;
        }
        binding.bonds_.push_back(bond(pose, point, weights, nearest_joints));
    }
    return binding;
}

Result<Binding> Binding::by_weights(const Pose& pose, std::span<const Vec3> points,
                                    std::span<const std::uint32_t> joints, std::span<const float> weights) {
    const std::size_t each = points.empty() ? 0 : joints.size() / points.size();
    if (joints.size() != each * points.size() || weights.size() != joints.size())
        return Error{ErrorCode::invalid_argument, std::to_string(joints.size()) + " joints and " +
                                                      std::to_string(weights.size()) + " weights for " +
                                                      std::to_string(points.size()) +
                                                      " points; each needs as many of both"};
    Binding binding;
    std::vector<float> of_joint(pose.positions.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::ranges::fill(of_joint, 0.0f);
        float sum = 0;
        for (std::size_t k = each * i; k < each * (i + 1); ++k) {
            if (!(weights[k] >= 0 && weights[k] <= 1e6f))
                return misfit(i,
                              "has a weight of " + std::to_string(weights[k]) + "; it must be from 0 to 1");
            if (joints[k] >= of_joint.size())
                return misfit(i, "hangs on joint " + std::to_string(joints[k]) + "; the skeleton has " +
                                     std::to_string(of_joint.size()));
            of_joint[joints[k]] += weights[k];
            sum += weights[k];
        }
        if (!(sum > 1e-6f))
            return misfit(i, "has weights that sum to " + std::to_string(sum) + "; it needs 1");
        binding.bonds_.push_back(bond(pose, to_vector(points[i]), of_joint, most));
    }
    return binding;
}

void Binding::place(const Pose& pose, std::span<Vec3> to) const {
    for (std::size_t i = 0; i < bonds_.size(); ++i) {
        const Bond& bond = bonds_[i];
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < most && bond.weights[k] > 0; ++k)
            sum += bond.weights[k] * pose.at(bond.joints[k], bond.local[k]);
        to[i] = to_vec3(sum);
    }
}

void Binding::turn(const Pose& bound, const Pose& pose, std::span<const Vec3> vectors,
                   std::span<Vec3> to) const {
    for (std::size_t i = 0; i < bonds_.size(); ++i) {
        const Bond& bond = bonds_[i];
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < most && bond.weights[k] > 0; ++k) {
            const Vector3 local = bound.rotations[bond.joints[k]].conjugate() * to_vector(vectors[i]);
            sum += bond.weights[k] * (pose.rotations[bond.joints[k]] * local);
        }
        to[i] = to_vec3(sum);
    }
}

}  // namespace weft::demo
