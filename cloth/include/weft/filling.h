#pragma once
// What fills a closed cloth: balloons, cushions, airbags, balls.

#include <cstdint>

namespace weft {

/// Kinds of fillings.
enum class FillingKind : std::uint32_t {
    none,      ///< nothing, at no cost
    pressure,  ///< a gauge pressure that does not depend on the volume, as from a fan or a pump
    gas,       ///< an amount of gas at one temperature: its pressure times its volume is constant
    volume,    ///< a volume that stays the same: water, or cushions that must not yield
};

/// What fills a cloth whose mesh is closed: each edge has two triangles, wound alike, counter-clockwise from
/// outside. Its pressure acts on each triangle along the normal, in the cloth's equation, so that no step is
/// too long for it. `gas` and `volume` need Method Multilevel; `pressure` acts in every method. Pieces of one
/// mesh share one filling, which has no weight. Faces that cross count with the sign of their winding.
struct Filling {
    FillingKind kind = FillingKind::none;
    /// Gauge pressure, above that outside [Pa], -1e5 to 1e7: of `pressure` always, of `gas` at `volume`. A
    /// balloon has some 3000, a football 80000. A sphere of radius r bears p r / 2 as tension per width.
    float pressure = 0;
    /// Volume [m^3], up to 1e9: that which `volume` keeps, or at which `gas` has `pressure`. 0, the default:
    /// that of the mesh as it was given. `volume` reaches it within the next step: let it grow over some
    /// steps. Fabric stretches where its area does not enclose as much.
    float volume = 0;
    /// Absolute pressure outside, of `gas` [Pa], 0 to 1e7; the default is the atmosphere's. With less, or
    /// none, the same `pressure` is that of less gas, which yields more.
    float outside = 101325;
    friend bool operator==(const Filling&, const Filling&) = default;
};

/// A cloth's filling as it is now.
struct FillingInfo {
    /// Edges that have one triangle, or two that are wound against each other. 0: the mesh is closed, and can
    /// be filled.
    std::uint32_t open_edges = 0;
    float volume = 0;       ///< that the mesh encloses now [m^3]; 0 if it is open
    float rest_volume = 0;  ///< that the mesh encloses as it was given [m^3]; 0 if it is open
    /// Gauge pressure [Pa]; 0 without a filling. That of FillingKind::volume is of the last substep, and 0
    /// before the first step and after restore().
    float pressure = 0;
};

}  // namespace weft
