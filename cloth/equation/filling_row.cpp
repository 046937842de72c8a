#include "cloth/equation/filling_row.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <functional>

#include "cloth/equation/sparse/vectors.h"

namespace weft {

double enclosed_volume(std::span<const Vec4> positions, std::span<const Triangle> triangles) {
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const auto at = [&](std::uint32_t i) -> Eigen::Vector3d {
            return (xyz(positions[i]) - xyz(positions[triangles.front()[0]])).cast<double>();
        };
        sum += at(a).dot(at(b).cross(at(c))) / 6;
    }
    return sum;
}

namespace {

/// The least volume that a gas is taken to have, of its own: an empty cushion is not blown up by force.
constexpr double least_part = 0.1;

double volume_of_gas(double own, double volume) {
    return std::max(volume, least_part * own);
}

}  // namespace

double gauge_pressure(const Filling& filling, double own, double volume) {
    const auto pressure = static_cast<double>(filling.pressure),
               outside = static_cast<double>(filling.outside);
    if (filling.kind == FillingKind::pressure) return pressure;
    if (filling.kind != FillingKind::gas) return 0;
    return (outside + pressure) * own / volume_of_gas(own, volume) - outside;
}

void FillingRow::lay_out(Scratch& scratch, std::uint32_t particles) {
    scratch.take(gradient_, particles);
    scratch.take(response_, has_slope() ? particles : 0);
    scratch.take(partials_, block_count(particles));
}

void FillingRow::begin() noexcept {
    pressure_ = 0;
    slope_ = give_ = 0;
}

// At a particle that closed triangles surround, the gradient is a sixth of the sum of their edges' cross
// products, from any origin. The volume is of third order in the places, so that it is a third of g . x.
void FillingRow::linearise(Parallel& parallel, const ClothModel& model, std::span<const Vec4> bases,
                           float gamma, std::span<const Vec4> velocities) {
    gamma_ = gamma;
    const auto at = [&](std::uint32_t i) -> Eigen::Vector4f {
        return load(bases[i]) + gamma * load(velocities[i]);  // w is of no use
    };
    const Eigen::Vector4f origin = at(0);
    const std::span<const std::uint32_t> offsets = model.corner_offsets.span(),
                                         corners = model.corner_triangles.span();
    const std::span<const Triangle> triangles = model.triangles.span();
    const auto of_particle = [&](std::uint32_t i) {
        const Eigen::Vector4f x = at(i);
        Eigen::Vector4f sum = Eigen::Vector4f::Zero();
        for (const std::uint32_t t : corners.subspan(offsets[i], offsets[i + 1] - offsets[i])) {
            const Triangle& triangle = triangles[t];
            const std::uint32_t k = corner_at(triangle, i);
            sum += (at(triangle[(k + 1) % 3]) - x).cross3(at(triangle[(k + 2) % 3]) - x);
        }
        const Vector3 gradient = sum.head<3>() / 6;
        gradient_[i] = bases[i].w > 0 ? to_vec4(gradient, 0) : Vec4{};
        return gradient.cast<double>().dot((x - origin).head<3>().cast<double>()) / 3;
    };
    volume_ = sum_over_particles(parallel, model.particle_count, partials_.span(), of_particle);
    if (keeps_volume()) return;
    pressure_ = static_cast<float>(gauge_pressure(filling_, own_volume_, volume_));
    const double g = static_cast<double>(gamma), outside = static_cast<double>(filling_.outside);
    slope_ = has_slope()
                 ? g * g * (static_cast<double>(pressure_) + outside) / volume_of_gas(own_volume_, volume_)
                 : 0;
}

double FillingRow::along_gradient(Parallel& parallel, std::span<const Vec4> x) {
    return dot(parallel, gradient(), x, partials_.span());
}

void FillingRow::set_response(Parallel& parallel) {
    give_ = along_gradient(parallel, response());
}

void FillingRow::find_pressure(Parallel& parallel, std::span<Vec4> right_side) {
    if (!keeps_volume() || !(give_ > 0)) return;
    const double work = dot(parallel, response(), right_side, partials_.span());
    const auto impulse = static_cast<float>(-work / give_);  // per gradient [Pa s]
    pressure_ += impulse / gamma_;
    fill_fours(parallel, right_side, [&](std::uint32_t i) -> FourRows {
        return load_four(&right_side[i]) + impulse * load_four(&gradient_[i]);
    });
}

void FillingRow::relieve(Parallel& parallel, std::span<Vec4> x) {
    if (!(give_ > 0)) return;
    const double part = keeps_volume() ? 1 : slope_ * give_ / (1 + slope_ * give_);
    scale_and_add(parallel, static_cast<float>(-part * along_gradient(parallel, x) / give_), response(), 1,
                  x);
}

double FillingRow::multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
    if (slope_ == 0) return 0;
    const double along = along_gradient(parallel, x);
    if (!product.empty()) scale_and_add(parallel, static_cast<float>(slope_ * along), gradient(), 1, product);
    return slope_ * along * along;
}

float FillingRow::factor_to_volume() const noexcept {
    if (!keeps_volume() || !(give_ > 0)) return 0;
    return static_cast<float>(missing_volume() / (static_cast<double>(gamma_) * give_));
}

}  // namespace weft
