#pragma once
// Measures of the state of a scene of contact.

#include <Eigen/Core>
#include <vector>

#include "demo/study/contact/contact_run.h"

namespace weft::study {

/// Edges that carry structural springs, or all edges of a general mesh, between particles, with the length
/// that they have at rest.
class EdgeStretch {
  public:
    explicit EdgeStretch(const ContactRun& run);

    struct Stretch {
        double mean = 0, most = 0;  ///< length over length at rest
    };
    [[nodiscard]] Stretch of(const ContactRun& run) const;

  private:
    struct Edge {
        std::uint32_t a, b;
        double rest;
    };
    std::vector<std::vector<Edge>> edges_;  // of each cloth
};

[[nodiscard]] double rms_speed(const ContactRun& run);  ///< of all free particles, weighted by mass [m/s]

/// Penetration depth of the deepest free particle into the distance kept from colliders [m]. From
/// ClothSettings::thickness on it is inside the solid. 0 or less: none is inside.
[[nodiscard]] double deepest_in_colliders(const ContactRun& run);

/// Sum of mass times velocity of all free particles [kg m/s].
[[nodiscard]] Eigen::Vector3d momentum(const ContactRun& run);

/// Mean heights of the scene's layers [m], in their order at the start, the lowest first.
[[nodiscard]] std::vector<double> layer_heights(const ContactRun& run);

/// Number of layers whose mean height is above that of the layer below them at the start.
[[nodiscard]] std::size_t layers_in_order(const std::vector<double>& heights);

}  // namespace weft::study
