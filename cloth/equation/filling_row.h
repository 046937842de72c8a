#pragma once
// What fills a closed cloth, in the implicit step.

#include <cstdint>
#include <span>

#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/filling.h"

namespace weft {

/// Volume within closed triangles, of which some may be missing [m^3].
[[nodiscard]] double enclosed_volume(std::span<const Vec4> positions, std::span<const Triangle> triangles);
/// Gauge pressure of a filling whose volume is `volume`; `own` is the volume that Filling::volume stands for.
/// 0 for FillingKind::volume, whose pressure is whatever keeps it.
[[nodiscard]] double gauge_pressure(const Filling& filling, double own, double volume);

/// A filling acts on the particles with the force p g, where g is the gradient of the enclosed volume V by
/// their places: a third of p times the area, along the normal, from each triangle. Its slope by the places
/// is dp/dV g g^T + p dg/dx. The equation's matrix has the first term, which is of rank one, and lets all
/// particles act on all. The second is small beside the fabric's own stiffness, and is left to further
/// passes.
///
/// With P an approximation of W^-1, z = P g is how the cloth gives way to pressure. P less its part along z
/// is one of (W + slope)^-1 (Sherman, Morrison 1950). For FillingKind::volume the slope is infinite: what is
/// left changes no volume.
class FillingRow {
  public:
    FillingRow(const Filling& filling, double own_volume) : filling_(filling), own_volume_(own_volume) {}
    void lay_out(Scratch& scratch, std::uint32_t particles);
    [[nodiscard]] bool keeps_volume() const noexcept { return filling_.kind == FillingKind::volume; }
    /// Whether the pressure depends on the volume.
    [[nodiscard]] bool has_slope() const noexcept { return filling_.kind != FillingKind::pressure; }

    /// Begins a solve: a pressure that keeps the volume is 0 until it is found.
    void begin() noexcept;
    /// Finds volume, gradient and pressure at the places bases + gamma velocities.
    void linearise(Parallel& parallel, const ClothModel& model, std::span<const Vec4> bases, float gamma,
                   std::span<const Vec4> velocities);
    [[nodiscard]] double volume() const noexcept { return volume_; }                        ///< [m^3]
    [[nodiscard]] double missing_volume() const noexcept { return own_volume_ - volume_; }  ///< [m^3]
    [[nodiscard]] float pressure() const noexcept { return pressure_; }                     ///< gauge [Pa]
    /// g of the free particles, 0 at others [m^2].
    [[nodiscard]] std::span<const Vec4> gradient() const noexcept {
        return {gradient_.data(), gradient_.size()};
    }

    /// z, to be written; then set_response() takes it. Precondition: has_slope().
    [[nodiscard]] std::span<Vec4> response() noexcept { return response_.span(); }
    void set_response(Parallel& parallel);
    /// Raises the pressure by what makes the right-hand side do no work along z.
    void find_pressure(Parallel& parallel, std::span<Vec4> right_side);
    /// x -= z times what (W + slope)^-1 has less of it than P.
    void relieve(Parallel& parallel, std::span<Vec4> x);
    /// product += C x unless `product` is empty, with C the slope. Returns x . C x.
    double multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product);
    /// The factor of z, as a change of velocity, that makes up for the missing volume at first order [Pa s].
    [[nodiscard]] float factor_to_volume() const noexcept;

  private:
    [[nodiscard]] double along_gradient(Parallel& parallel, std::span<const Vec4> x);

    Filling filling_;
    double own_volume_;
    double volume_ = 0;
    double slope_ = 0;  // gamma^2 times -dp/dV [kg/m^4]
    double give_ = 0;   // g . z [m^4/kg]
    float gamma_ = 0;
    float pressure_ = 0;
    ScratchArray<Vec4> gradient_, response_;
    ScratchArray<double> partials_;
};

}  // namespace weft
