#pragma once
// A scene in a World, step by step, through the interface that a host has.

#include <vector>

#include "demo/study/contact/contact_scenes.h"
#include "demo/study/crossings/triangle_soup.h"

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

}  // namespace weft::study
