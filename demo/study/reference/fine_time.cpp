#include "demo/study/reference/fine_time.h"

#include <algorithm>
#include <cmath>

#include "cloth/fabric/springs/membrane.h"
#include "demo/study/stability/stability_causes.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

using Vector = Eigen::Vector3d;

/// Data of the inner loop: springs slot by slot, positions and velocities component by component.
struct SpringLoop {
    const std::uint32_t* neighbours;
    const double *stiffness, *rest_lengths, *bending;
    std::array<const double*, 3> x, v;
    double damping;
};

#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define WEFT_STUDY_WIDEST __attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#else
#define WEFT_STUDY_WIDEST
#endif

constexpr std::uint32_t lanes = FineTime::lanes;
using Forces = std::array<std::array<double, lanes>, 3>;

/// Sum of k (l - L + damping dl/dt) n and of bending over slots [first, last) of the particles from `begin`.
WEFT_STUDY_WIDEST void spring_forces(const SpringLoop& loop, std::uint32_t first, std::uint32_t last,
                                     std::uint32_t begin, Forces& forces) {
    const double *const x = loop.x[0], *const y = loop.x[1], *const z = loop.x[2];
    const double *const u = loop.v[0], *const v = loop.v[1], *const w = loop.v[2];
    const double damping = loop.damping;
    double fx[lanes] = {}, fy[lanes] = {},
           fz[lanes] = {};  // local, so that they cannot alias what the loop reads
    for (std::uint32_t slot = first; slot < last; ++slot) {
        const std::uint32_t* const neighbours = loop.neighbours + std::size_t{slot} * lanes;
        const double* const stiffness = loop.stiffness + std::size_t{slot} * lanes;
        const double* const rest_lengths = loop.rest_lengths + std::size_t{slot} * lanes;
        const double* const bending = loop.bending + std::size_t{slot} * lanes;
        for (std::uint32_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t i = begin + lane, j = neighbours[lane];
            const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
            const double length = std::sqrt(dx * dx + dy * dy + dz * dz + 1e-300);
            const double inverse = 1 / length;
            const double du = u[j] - u[i], dv = v[j] - v[i], dw = w[j] - w[i];
            const double stretching = (dx * du + dy * dv + dz * dw) * inverse;
            const double bend = bending[lane], viscous = bend * damping;
            const double tension =
                stiffness[lane] * (length - rest_lengths[lane] + damping * stretching) * inverse + bend;
            fx[lane] += tension * dx + viscous * du;
            fy[lane] += tension * dy + viscous * dv;
            fz[lane] += tension * dz + viscous * dw;
        }
    }
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        forces[0][lane] = fx[lane];
        forces[1][lane] = fy[lane];
        forces[2][lane] = fz[lane];
    }
}

/// The force of cloth/air/wind.cpp in double precision, without its slope.
Vector plate_force(const Vector& u, const Vector& area_normal, const Wind& wind) {
    const double speed = u.norm(), area = area_normal.norm();
    if (speed < 1e-6 || area < 1e-12) return Vector::Zero();
    const double through = u.dot(area_normal) / area, facing = std::abs(through);
    const Vector n = std::copysign(1.0, through) / area * area_normal;
    const double drag = static_cast<double>(wind.drag), lift = static_cast<double>(wind.lift);
    return 0.5 * static_cast<double>(wind.air_density) * area * facing *
           ((drag - lift * facing / speed) * u + lift * speed * n);
}

}  // namespace

FineTime::FineTime(const StudyScene& scene, int threads)
    : parallel_(thread_count(threads)),
      frame_(static_cast<double>(scene.frame)),
      damping_(static_cast<double>(scene.cloth.fabric.damping)),
      air_damping_(static_cast<double>(scene.cloth.air_damping)),
      gravity_(to_vector(scene.world.gravity).cast<double>()),
      wind_(scene.world.wind) {
    const Run start(scene, {"", "", "", [](ClothSettings&) {}, {}, false}, 1);
    const Cloth& cloth = start.cloth();
    particles_ = cloth.model.particle_count;
    triangles_.assign(cloth.model.triangles.begin(), cloth.model.triangles.end());
    corner_offsets_.assign(cloth.model.corner_offsets.span().begin(),
                           cloth.model.corner_offsets.span().end());
    corner_triangles_.assign(cloth.model.corner_triangles.span().begin(),
                             cloth.model.corner_triangles.span().end());
    triangle_forces_.resize(triangles_.size());

    const std::size_t padded = (particles_ + lanes - 1) / lanes * lanes;
    for (Components* components : {&x_, &v_, &predicted_, &a_, &air_}) components->fill(Component(padded));
    inverse_masses_.assign(padded, 0.0);
    for (std::uint32_t i = 0; i < particles_; ++i) {
        const Vec4 &x = cloth.state.positions[i], &v = cloth.state.velocities[i];
        inverse_masses_[i] = static_cast<double>(x.w);
        for (std::size_t c = 0; c < 3; ++c) {
            x_[c][i] = static_cast<double>((&x.x)[c]);
            v_[c][i] = predicted_[c][i] = static_cast<double>((&v.x)[c]);
        }
    }
    make_springs(cloth.model, scene.cloth.fabric);
    compute_air();
    finish(0);
}

void FineTime::make_springs(const ClothModel& model, const Fabric& fabric) {
    std::vector<float> stiffness(model.neighbours.size());
    spring_stiffness(model, fabric, stiffness);
    group_slots_.push_back(0);
    for (std::uint32_t begin = 0; begin < particles_; begin += lanes) {
        const std::uint32_t end = std::min(begin + lanes, particles_);
        const auto degree = [&](std::uint32_t i) {
            return model.spring_offsets[i + 1] - model.spring_offsets[i];
        };
        std::uint32_t slots = 0;
        for (std::uint32_t i = begin; i < end; ++i) slots = std::max(slots, degree(i));
        for (std::uint32_t slot = 0; slot < slots; ++slot) {
            for (std::uint32_t i = begin; i < begin + lanes; ++i) {
                const bool used = i < end && slot < degree(i);
                const std::uint32_t e = used ? model.spring_offsets[i] + slot : 0;
                neighbours_.push_back(used ? model.neighbours[e] : i);
                stiffness_.push_back(used ? static_cast<double>(stiffness[e]) : 0.0);
                bending_.push_back(
                    used ? static_cast<double>(fabric.bending) * static_cast<double>(model.bending[e]) : 0.0);
                rest_lengths_.push_back(used ? static_cast<double>(model.rest_lengths[e]) : 1.0);
            }
        }
        group_slots_.push_back(group_slots_.back() + slots);
    }
}

void FineTime::step(int substeps) {
    const double h = frame_ / substeps;
    for (int s = 0; s < substeps; ++s) {
        predict(h);
        compute_air();
        finish(h);
    }
}

// Computes x' and v + h a.
void FineTime::predict(double h) {
    parallel_.ranges(particles_, [&](const BlockRange& range) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                x_[c][i] += h * (v_[c][i] + 0.5 * h * a_[c][i]);
                predicted_[c][i] = v_[c][i] + h * a_[c][i];
            }
        }
    });
}

void FineTime::compute_air() {
    if (wind_.air_density == 0) return;
    const Vector wind = to_vector(wind_.velocity).cast<double>();
    const auto at = [](const Components& values, std::uint32_t i) {
        return Vector(values[0][i], values[1][i], values[2][i]);
    };
    parallel_.ranges(static_cast<std::uint32_t>(triangles_.size()), [&](const BlockRange& range) {
        for (std::uint32_t t = range.begin; t < range.end; ++t) {
            const auto [a, b, c] = triangles_[t];
            const Vector velocity = (at(predicted_, a) + at(predicted_, b) + at(predicted_, c)) / 3;
            const Vector corner = at(x_, a);
            const Vector area = 0.5 * (at(x_, b) - corner).cross(at(x_, c) - corner);
            triangle_forces_[t] = plate_force(wind - velocity, area, wind_) / 3;
        }
    });
    parallel_.ranges(particles_, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector sum = Vector::Zero();
            for (std::uint32_t c = corner_offsets_[i]; c < corner_offsets_[i + 1]; ++c)
                sum += triangle_forces_[corner_triangles_[c]];
            for (std::size_t c = 0; c < 3; ++c) air_[c][i] = sum[static_cast<Eigen::Index>(c)];
        }
    });
}

// Computes a' and v'. Blocks are whole groups of lanes.
void FineTime::finish(double h) {
    static_assert(block_size % lanes == 0);
    const SpringLoop loop{neighbours_.data(),
                          stiffness_.data(),
                          rest_lengths_.data(),
                          bending_.data(),
                          {x_[0].data(), x_[1].data(), x_[2].data()},
                          {predicted_[0].data(), predicted_[1].data(), predicted_[2].data()},
                          damping_};
    parallel_.ranges(particles_, [&](const BlockRange& range) {
        for (std::uint32_t begin = range.begin; begin < range.end; begin += lanes) {
            const std::uint32_t group = begin / lanes;
            Forces force;
            spring_forces(loop, group_slots_[group], group_slots_[group + 1], begin, force);
            for (std::size_t c = 0; c < 3; ++c) {
                const double g = gravity_[static_cast<Eigen::Index>(c)];
                for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                    const std::uint32_t i = begin + lane;
                    const double acceleration = inverse_masses_[i] * (force[c][lane] + air_[c][i]) + g -
                                                air_damping_ * predicted_[c][i];
                    const double next = inverse_masses_[i] > 0 ? acceleration : 0.0;
                    v_[c][i] += 0.5 * h * (a_[c][i] + next);
                    a_[c][i] = next;
                }
            }
        }
    });
}

// 1.1: stretched springs have slightly higher frequencies, and power iteration stops slightly short.
int FineTime::safe_substeps(const StudyScene& scene) {
    const double frequency = 1.1 * stiffest_frequency(scene);
    const double rate = static_cast<double>(scene.cloth.fabric.damping) * frequency * frequency;
    const double h = std::min(0.7 / rate, 1 / frequency);
    return std::max(64, static_cast<int>(std::ceil(static_cast<double>(scene.frame) / h)));
}

std::vector<Vector> FineTime::vectors(const Components& components) const {
    std::vector<Vector> result;
    for (std::uint32_t i = 0; i < particles_; ++i)
        result.emplace_back(components[0][i], components[1][i], components[2][i]);
    return result;
}

std::vector<Vector> FineTime::positions() const {
    return vectors(x_);
}

std::vector<Vector> FineTime::velocities() const {
    return vectors(v_);
}

}  // namespace weft::study
