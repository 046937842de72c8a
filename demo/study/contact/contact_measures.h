#pragma once
// What is measured on a scene's state.

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

[[nodiscard]] double rms_speed(const ContactRun& run);  ///< of all that is free, weighted by mass [m/s]

/// How far the deepest particle that is free is inside the distance that is kept from colliders [m]; from
/// ClothSettings::thickness on it is in the solid. 0 or less: none is.
[[nodiscard]] double deepest_in_colliders(const ContactRun& run);

/// Sum of mass times velocity of all that is free [kg m/s].
[[nodiscard]] Eigen::Vector3d momentum(const ContactRun& run);

/// Mean heights of the scene's layers, the one first that was lowest at the start [m].
[[nodiscard]] std::vector<double> layer_heights(const ContactRun& run);

/// How many layers are, by their mean heights, above the one that was below them at the start.
[[nodiscard]] std::size_t layers_in_order(const std::vector<double>& heights);

}  // namespace weft::study
