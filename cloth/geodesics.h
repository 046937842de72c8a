#pragma once
// How far it is along the cloth.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/cook.h"

namespace weft {

/// Distances on the rest surface from given particles, by fast marching on its triangles (Kimmel and Sethian
/// 1998).
class Geodesics {
  public:
    static constexpr std::uint32_t none = ~0u;

    explicit Geodesics(const CookedCloth& model);

    /// Finds for each particle the source that is nearest along the cloth, and how far that is.
    void march(const CookedCloth& model, std::span<const std::uint32_t> sources);

    [[nodiscard]] std::span<const double> distances() const { return distances_; }  ///< [m]
    [[nodiscard]] std::span<const std::uint32_t> sources() const {
        return sources_;
    }  ///< none: cannot be reached
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Front {
        double distance;
        std::uint32_t particle;
    };
    void reach(std::uint32_t particle, double distance, std::uint32_t source);
    void cross_triangle(const CookedCloth& model, std::uint32_t triangle, std::uint32_t from);

    std::vector<std::array<double, 3>> sides_;  // of each triangle, side k being opposite to corner k [m]
    std::vector<double> distances_;
    std::vector<std::uint32_t> sources_;
    std::vector<Front> front_;  // a heap, the nearest first
};

}  // namespace weft
