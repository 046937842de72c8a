#pragma once
// A scene in a World, step by step, through the interface that a host has; and measures of its state.

#include <Eigen/Core>
#include <vector>

#include "demo/study/contact/contact_scenes.h"
#include "demo/study/crossings/crossings.h"

namespace weft::study {

class ContactRun {
  public:
    /// A World of one thread. Throws std::runtime_error where it refuses the scene.
    ContactRun(ContactScene scene, SelfCollisionMethod method);

    /// Takes one step of ContactScene::step(); returns World::step's time on the processor [s].
    double step();
    [[nodiscard]] double time() const { return static_cast<double>(steps_) * ContactScene::step(); }
    [[nodiscard]] bool over() const { return time() > scene_.seconds - ContactScene::step() / 2; }

    [[nodiscard]] const ContactScene& scene() const { return scene_; }
    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const std::vector<ClothId>& cloths() const { return cloths_; }
    [[nodiscard]] const std::vector<ColliderId>& colliders() const { return colliders_; }
    [[nodiscard]] std::uint32_t particles() const;
    /// The triangles of all cloths, as they are now.
    [[nodiscard]] TriangleSoup soup() const;

    /// Greatest distance of a pinned vertex from its target of the last step [m]. Pins may have to give way
    /// where cloth is held against them.
    [[nodiscard]] double pin_lag() const;

  private:
    struct PinTarget {
        std::size_t cloth;
        std::uint32_t vertex;
        Vec3 place;
    };
    class Handles;

    ContactScene scene_;
    World world_;
    std::vector<ClothId> cloths_;
    std::vector<ColliderId> colliders_;
    std::vector<PinTarget> targets_;
    long steps_ = 0;
};

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
