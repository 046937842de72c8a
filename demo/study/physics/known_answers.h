#pragma once
// Predictions of theory for cloth. Units are SI; angles are radians unless a name says degrees.

namespace weft::study {

/// A strip clamped horizontally at one end that hangs by its weight, in lengths of the strip.
struct HangingStrip {
    double drop, reach;                          ///< of the free end below the clamp, and out from it
    [[nodiscard]] double chord_degrees() const;  ///< below the horizontal, from the clamp to the free end
};
/// The heavy elastica, from 0 to 100 (demo/learn/elastica.h).
[[nodiscard]] HangingStrip heavy_elastica(double gamma);

/// Gamma at which a narrow strip clamped with its width upright gives way sideways under its weight, for
/// Poisson's ratio 0: GJ phi'' + q^2 (L - x)^4 / (4 EI) phi = 0, GJ = 2 EI (Prandtl, Michell 1899).
[[nodiscard]] double lateral_buckling_gamma();

/// Sag of a chain of `length` between two points `span` apart at one height; length > span.
[[nodiscard]] double catenary_sag(double span, double length);

/// Period of a stiff plate that swings about its upper edge by `amplitude` to either side.
[[nodiscard]] double plate_pendulum_period(double length, double amplitude, double gravity);
/// Period of a hanging chain's first mode, if small: 4 pi / j_0,1 sqrt(length / gravity) (Bernoulli 1733).
[[nodiscard]] double chain_pendulum_period(double length, double gravity);

/// Terminal speed of a flat sheet that falls facing the air.
[[nodiscard]] double terminal_speed(double areal_density, double gravity, double air_density, double drag);

/// The friction below which a strip over a horizontal cylinder of `radius` slips: `shorter` and `longer` hang
/// down on its two sides. Capstan equation (Eytelwein 1808) with the weight of the strip on the cylinder:
/// dT/dphi = w r cos phi + mu (T + w r sin phi).
[[nodiscard]] double capstan_friction(double shorter, double longer, double radius);

/// Acceleration of a body that slides down a slope; 0 where friction holds it.
[[nodiscard]] double slope_acceleration(double angle, double friction, double gravity);

}  // namespace weft::study
