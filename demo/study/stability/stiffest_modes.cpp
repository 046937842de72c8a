#include "demo/study/stability/stiffest_modes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "cloth/equation/implicit_system.h"
#include "cloth/solver/make_system.h"

namespace weft::study {

namespace {

/// The flat sheet's system W, without drag.
class FlatSystem {
  public:
    FlatSystem(const StudyScene& scene, float gamma, float spring_damping)
        : cloth_(cook(scene.mesh).value(), scene.cloth) {
        cloth_.settings.air_damping = 0;
        cloth_.settings.fabric.damping = spring_damping;
        for (const std::uint32_t vertex : scene.pins) cloth_.pin(cloth_.model.vertex_to_particle[vertex]);
        system_ = make_system(cloth_.model, cloth_.settings);
        const std::span<const Vec4> positions = cloth_.state.positions.span();
        const std::span<const Vec4> velocities = cloth_.state.velocities.span();
        system_->linearise(serial_,
                           {.settings = cloth_.settings,
                            .h = gamma,
                            .gamma = gamma,
                            .rigidity = cloth_.settings.fabric.bending,
                            .positions = positions,
                            .velocities = velocities,
                            .base_positions = positions,
                            .base_velocities = velocities,
                            .external = {}},
                           velocities, LinearisedAbout::base);
    }

    /// The largest eigenvalue of a positive operator: apply(x, y) sets y.
    template <class Operator>
    double largest_eigenvalue(const Operator& apply) {
        const std::uint32_t n = cloth_.state.size();
        std::mt19937 random(1);
        AlignedBuffer<Vec4> x(n), y(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto next = [&] { return static_cast<float>(random()) * 0x1p-31f - 1; };
            if (inverse_mass(i) > 0) x[i] = {next(), next(), next(), 0};
        }
        double eigenvalue = 0;
        for (int iteration = 0; iteration < 400; ++iteration) {
            apply(x, y);
            double squared = 0;
            for (const Vec4& v : y.span()) squared += static_cast<double>(xyz(v).squaredNorm());
            eigenvalue = std::sqrt(squared);
            for (std::uint32_t i = 0; i < n; ++i)
                x[i] = to_vec4(xyz(y[i]) / static_cast<float>(eigenvalue), 0);
        }
        return eigenvalue;
    }

    [[nodiscard]] float inverse_mass(std::uint32_t i) const { return cloth_.state.positions[i].w; }
    ImplicitSystem& operator*() { return *system_; }
    Parallel& serial() { return serial_; }

  private:
    Cloth cloth_;
    Parallel serial_{1};
    std::unique_ptr<ImplicitSystem> system_;
};

}  // namespace

// The eigenvalue is that of M^-1 K: with gamma = 1 and no damping W = M + K.
double stiffest_frequency(const StudyScene& scene) {
    FlatSystem system(scene, 1, 0);
    return std::sqrt(system.largest_eigenvalue([&](AlignedBuffer<Vec4>& x, AlignedBuffer<Vec4>& y) {
        (*system).multiply(system.serial(), x.span(), y.span());
        for (std::uint32_t i = 0; i < x.size(); ++i)
            y[i] = to_vec4(system.inverse_mass(i) * xyz(y[i]) - xyz(x[i]), 0);
    }));
}

double largest_relaxed(const StudyScene& scene) {
    FlatSystem system(scene, scene.frame, scene.cloth.fabric.damping);
    AlignedBuffer<Vec4> product(scene.mesh.positions.size());
    return system.largest_eigenvalue([&](AlignedBuffer<Vec4>& x, AlignedBuffer<Vec4>& y) {
        (*system).multiply(system.serial(), x.span(), product.span());
        (*system).precondition(system.serial(), product.span(), 1, y.span());
    });
}

double left_by_jacobi(int iterations, double lambda) {
    return std::pow(1 - lambda, iterations + 1);
}

}  // namespace weft::study
