#pragma once
// Somebody dressed, in a World: a motion, the body that follows it, and the garment on the body.

#include <filesystem>
#include <memory>
#include <vector>

#include "demo/character/body/binding.h"
#include "demo/character/body/skin.h"
#include "demo/character/garment/fitting.h"
#include "demo/character/motion/motion.h"
#include "weft/world.h"

namespace weft::demo {

/// What of the body cloth meets.
enum class BodySurface : std::uint8_t {
    capsules,  ///< of limbs, on their way: whatever moves fast
    skin,      ///< triangles that follow the skeleton, where they are at the end of each step
};

struct CharacterSettings {
    std::filesystem::path motion;   ///< a BVH file, or a pipe (live_motion.h); empty: the walk that ships
    bool runs = false;              ///< without a motion file: the run that ships
    std::filesystem::path garment;  ///< an OBJ or glTF file; empty: the dress that ships
    std::uint32_t particles = 0;    ///< of the dress, about; 0: 3100
    std::uint32_t drawn = 0;        ///< vertices of a finer dress to draw over it, about; 0: none
    double speed = 1;               ///< of the motion, times its own
    Vec3 place{};                   ///< on the ground [m]
    double ahead = 0;               ///< how far into the motion it starts [s]
    BodySurface surface = BodySurface::capsules;
    ClothSettings cloth{};
};

class Character {
  public:
    /// Reads what the settings name. Error: what cannot be read, or who cannot be dressed, and why; of a glTF
    /// file, whose own body is the skin, also that it has none.
    [[nodiscard]] static Result<Character> create(const CharacterSettings& settings);

    /// Adds cloth, pins, maps and colliders. Error: the World's; what was added before it stays.
    [[nodiscard]] Result<void> enter(World& world);
    /// Moves colliders, pins and, where the garment has leashes or backstops, the places they are about, to
    /// where they are at the end of the step from `time` to `time + dt` [s].
    void before_step(World& world, double time, float dt);

    /// Goes there at once, by this about the World's origin, and what is worn goes along as it hangs and
    /// moves. Error: the World's; who cannot go stays, but for a skin that has no memory.
    [[nodiscard]] Result<void> teleport(World& world, const Transform& by);

    /// The garment's vertices as they are drawn and written: those that are simulated from the World, fixed
    /// ones where the body has them. Precondition: one for each of the garment's mesh.
    void write_back(const World& world, std::span<Vec3> vertices) const;

    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] const Garment& garment() const { return garment_; }
    [[nodiscard]] const std::vector<ColliderId>& colliders() const { return colliders_; }
    /// As they are at the end of the step that before_step prepared.
    [[nodiscard]] const std::vector<TaperedCapsule>& capsules() const { return capsules_; }
    /// Likewise, of BodySurface::skin. The same memory as long as somebody holds it.
    [[nodiscard]] const std::shared_ptr<std::vector<Vec3>>& skin_places() const { return skin_places_; }
    [[nodiscard]] const Skin& skin() const { return skin_; }
    /// Of all vertices, where leashes and backstops are about them; none, where the garment has neither.
    [[nodiscard]] const std::vector<Vec3>& skin_targets() const { return limit_places_; }
    [[nodiscard]] const Skeleton& skeleton() const { return performance_.skeleton(); }
    [[nodiscard]] const Fit& fitted() const { return fit_; }
    [[nodiscard]] const Body& body() const { return body_; }
    [[nodiscard]] const Pose& pose() const { return pose_; }
    [[nodiscard]] double dressed_after() const { return fitting_; }  ///< when the fitting is over [s]

  private:
    Character(Body body, Performance performance, Garment garment, Fit fit,
              const CharacterSettings& settings);
    static Result<Character> create_skinned(const CharacterSettings& settings);
    void follow(double time);
    [[nodiscard]] Result<void> add_body(World& world);
    [[nodiscard]] Result<void> add_maps(World& world);
    void bind_limits(const Pose& stance, const Binding* own);
    void take_skin(Skin skin);

    Body body_;
    Performance performance_;
    Garment garment_;
    Fit fit_;
    CharacterSettings settings_;
    double fitting_ = 0, followed_ = 0;         // followed_: the time of this pose [s]
    Quaternion turn_ = Quaternion::Identity();  // of the ground that is stood on
    Vector3 place_;                             // likewise [m]
    Binding binding_;
    Pose pose_;
    JointAngles angles_;
    std::vector<TaperedCapsule> capsules_;
    std::vector<Vec3> targets_;
    Skin skin_;
    std::shared_ptr<std::vector<Vec3>> skin_places_;
    ShapeId skin_shape_;
    Binding limits_;  // all vertices, where leashes and backstops are about them
    Pose limits_bound_;
    std::vector<Vec3> normals_, limit_places_, limit_normals_;
    ClothId cloth_;
    std::vector<ColliderId> colliders_;
};

}  // namespace weft::demo
