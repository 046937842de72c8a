#pragma once
// Strips of cloth as finite elements, brought to rest.

#include <cstdint>
#include <functional>
#include <random>

#include "tests/cloth/fixtures.h"

namespace weft::test {

/// A strip in the plane y = 0, rows along +X (the warp), of `columns` x `rows` cells of size `cell`; x starts
/// at -cell. An irregular one has its inner vertices moved at random by up to 0.15 cells, and the shorter
/// diagonals.
inline Mesh strip(std::uint32_t columns, std::uint32_t rows, float cell, bool irregular) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> offset(-0.15f * cell, 0.15f * cell);
    Mesh mesh;
    for (std::uint32_t r = 0; r <= rows; ++r) {
        for (std::uint32_t c = 0; c <= columns; ++c) {
            const bool inner_x = irregular && c > 1 && c < columns, inner_z = inner_x && r > 0 && r < rows;
            const float x = cell * (static_cast<float>(c) - 1), z = cell * static_cast<float>(r);
            mesh.positions.push_back({inner_x ? x + offset(random) : x, 0, inner_z ? z + offset(random) : z});
        }
    }
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
        return (to_vector(mesh.positions[b]) - to_vector(mesh.positions[a])).norm();
    };
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = r * (columns + 1) + c, b = a + columns + 1;
            if (irregular ? distance(a, b + 1) < distance(b, a + 1) : (r + c) % 2 == 0) {
                mesh.triangles.push_back({a, b, b + 1});
                mesh.triangles.push_back({a, b + 1, a + 1});
            } else {
                mesh.triangles.push_back({a, b, a + 1});
                mesh.triangles.push_back({a + 1, b, b + 1});
            }
        }
    }
    for (const Vec3& x : mesh.positions) mesh.pattern.push_back({x.x, x.z});
    return mesh;
}

/// W x = b by conjugate gradients with the system's own preconditioner, to `tolerance` of the start or for so
/// many iterations.
inline void solve(ImplicitSystem& system, std::span<Vec4> x, int iterations, double tolerance) {
    Parallel serial(1);
    const std::size_t n = x.size();
    AlignedBuffer<Vec4> z(n), p(n), wp(n);
    Eigen::VectorXd r = flat(system.right_side().span()), solution = Eigen::VectorXd::Zero(r.size()),
                    direction = Eigen::VectorXd::Zero(r.size());
    const auto store = [](const Eigen::VectorXd& from, std::span<Vec4> to) {
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] = to_vec4(from.segment<3>(3 * static_cast<Eigen::Index>(i)).cast<float>(), 0);
    };
    double rz = 0, start = 0;
    for (int k = 0; k < iterations; ++k) {
        store(r, p.span());
        system.precondition(serial, p.span(), 1, z.span());
        const Eigen::VectorXd preconditioned = flat(z.span());
        const double next = r.dot(preconditioned);
        if (k == 0) start = next;
        if (next <= tolerance * tolerance * start) break;
        direction = preconditioned + (k == 0 ? 0 : next / rz) * direction;
        rz = next;
        store(direction, p.span());
        system.multiply(serial, p.span(), wp.span());
        const Eigen::VectorXd product = flat(wp.span());
        const double alpha = rz / direction.dot(product);
        solution += alpha * direction;
        r -= alpha * product;
    }
    store(solution, x);
}

/// Steps of length h from rest to rest: Newton's method whose Hessian has the mass over h^2 added.
inline void relax_to_rest(Cloth& cloth, const Vector3& gravity, float h, int steps) {
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    AlignedBuffer<Vec4> dv(cloth.state.size());
    for (int k = 0; k < steps; ++k) {
        std::ranges::fill(cloth.state.velocities.span(), Vec4{});
        system->linearise(serial, equation_of(cloth, h, gravity), cloth.state.velocities.span(),
                          LinearisedAbout::base);
        solve(*system, dv.span(), 400, 1e-3);
        for (std::size_t i = 0; i < cloth.state.size(); ++i) {
            set_xyz(cloth.state.positions[i], xyz(cloth.state.positions[i]) + h * xyz(dv[i]));
        }
    }
}

}  // namespace weft::test
