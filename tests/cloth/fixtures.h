#pragma once
// Cloths and dense references that several test files share.

#include <Eigen/Dense>
#include <random>

#include "cloth/cloth.h"
#include "cloth/forces/springs.h"
#include "cloth/simulation.h"
#include "weft/weft.h"

namespace weft::test {

inline Mesh sheet(std::uint32_t rows, std::uint32_t columns) {
    return make_sheet({.rows = rows, .columns = columns}).value();
}

/// A cloth without air, pins or damping, whose particles are displaced and moving at random: springs in
/// tension and in compression, all directions. Inertia and stiffness are of the same order, so that
/// iterations converge quickly.
inline Cloth crumpled(const Mesh& mesh, float displacement, float stiffness, std::uint32_t seed = 7) {
    ClothSettings settings;
    settings.fabric = {
        .areal_density = 2.0f, .stretch = stiffness, .shear = 0.3f * stiffness, .bend = 0.1f * stiffness};
    settings.air_damping = 0;
    Cloth cloth(cook(mesh).value(), settings);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> offset(-displacement, displacement), speed(-1, 1);
    for (Vec4& x : cloth.state.positions.span()) {
        x.x += offset(random);
        x.y += offset(random);
        x.z += offset(random);
    }
    for (Vec4& v : cloth.state.velocities.span()) v = {speed(random), speed(random), speed(random), 0};
    return cloth;
}

/// The cloth's system of one step of length h under gravity.
inline void assemble_step(Cloth& cloth, float h, const Vector3& gravity = {0, -9.81f, 0}) {
    Parallel serial(1);
    assemble(serial, cloth.model, cloth.state, cloth.settings.fabric,
             {.gravity = gravity, .air_damping = cloth.settings.air_damping, .triangle_air_forces = {}}, h,
             cloth.system);
}

/// W and b of the assembled system in double precision, free particles only; row 3 i of pinned ones is the
/// identity.
struct DenseSystem {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right_side;
};

inline DenseSystem dense(const Cloth& cloth) {
    const Eigen::Index n = cloth.model.particle_count;
    DenseSystem system{Eigen::MatrixXd::Zero(3 * n, 3 * n), Eigen::VectorXd::Zero(3 * n)};
    for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
        const Vec4& b = cloth.system.right_side[i];
        auto diagonal = system.matrix.block<3, 3>(3 * i, 3 * i);
        if (b.w == 0) {
            diagonal.setIdentity();
            continue;
        }
        system.right_side.segment<3>(3 * i) = xyz(b).cast<double>();
        diagonal = static_cast<double>(b.w) * Eigen::Matrix3d::Identity();
        for (std::uint32_t e = cloth.model.spring_offsets[i]; e < cloth.model.spring_offsets[i + 1]; ++e) {
            const Vec4& c = cloth.system.coefficients[e];
            const Eigen::Vector3d d = xyz(c).cast<double>();
            const Eigen::Matrix3d a =
                static_cast<double>(c.w) * Eigen::Matrix3d::Identity() + d * d.transpose();
            diagonal += a;
            const std::uint32_t j = cloth.model.neighbours[e];
            if (cloth.system.right_side[j].w != 0) system.matrix.block<3, 3>(3 * i, 3 * j) = -a;
        }
    }
    return system;
}

inline Eigen::VectorXd solution(const Cloth& cloth) {
    Eigen::VectorXd dv(3 * static_cast<Eigen::Index>(cloth.model.particle_count));
    for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
        dv.segment<3>(3 * i) = xyz(cloth.system.velocity_change[i]).cast<double>();
    }
    return dv;
}

}  // namespace weft::test
