#pragma once
// A scene in which cloth meets cloth: as plain data, which the demo shows and the study judges.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "weft/weft.h"

namespace weft::demo {

/// A cloth of a scene. Where the mesh has a pattern, that is its rest shape.
struct PlacedCloth {
    Mesh mesh;
    ClothSettings settings{};
    std::vector<std::uint32_t> pins{};  ///< vertices held from the start
    /// Vertices, each the first of a layer that ends before the next: the lowest layer first. Empty: no order
    /// is looked at.
    std::vector<std::uint32_t> layers{};
};

/// What a scene may move before each step: its own cloths and colliders, by their places in its lists.
class SceneHandles {
  public:
    virtual void move_pin(std::size_t cloth, std::uint32_t vertex, const Vec3& target) const = 0;
    virtual void unpin(std::size_t cloth, const std::vector<std::uint32_t>& vertices) const = 0;
    virtual void move_collider(std::size_t collider, const Collider& target) const = 0;

  protected:
    ~SceneHandles() = default;
};

struct ContactScene {
    std::string name;
    double seconds = 0;
    std::vector<PlacedCloth> cloths{};
    std::vector<Collider> colliders{};
    WorldSettings world{};
    /// Puts pins and colliders where they are to be at `time` [s], the end of the step that follows.
    std::function<void(const SceneHandles&, double time)> move{};
    bool tangled = false;  ///< triangles cross at the start
    bool rests = false;    ///< at its end nothing is moved, and cloth should be still
    /// Mass times speed [kg m/s] of what is in motion, where no force acts from outside; 0: one does.
    double free_momentum = 0;
    /// The step from which momentum should stay as it is.
    double free_from = 0;
    [[nodiscard]] static constexpr double step() { return 1.0 / 60; }
};

/// A scene by its name, made for about so many particles (0: its own number).
struct SceneMaker {
    std::string name;
    bool quick;  ///< one of those that `--quick` runs
    std::function<ContactScene(std::uint32_t particles)> make;
    bool needs_garments = false;
};

/// Of a scene that `--quick` runs.
inline constexpr std::uint32_t quick_contact_particles = 1000;

/// Those of one file each.
[[nodiscard]] std::vector<SceneMaker> fold_scenes();
[[nodiscard]] std::vector<SceneMaker> stack_scenes();
[[nodiscard]] std::vector<SceneMaker> drape_scenes();
[[nodiscard]] std::vector<SceneMaker> forced_scenes();
[[nodiscard]] std::vector<SceneMaker> meeting_scenes();
[[nodiscard]] std::vector<SceneMaker> tangle_scenes();

/// Those that are only shown.
[[nodiscard]] std::vector<SceneMaker> shown_scenes();

/// All of the others.
[[nodiscard]] std::vector<SceneMaker> contact_scenes();

}  // namespace weft::demo
