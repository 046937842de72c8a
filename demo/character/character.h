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

/// The body's colliders.
enum class BodySurface : std::uint8_t {
    capsules,  ///< of limbs, swept over each step: for fast motion
    skin,      ///< triangles that follow the skeleton, at their places at the end of each step
};

struct CharacterSettings {
    std::filesystem::path motion;   ///< a BVH file, or a pipe (live_motion.h); empty: the walk that ships
    bool runs = false;              ///< without a motion file: the run that ships
    std::filesystem::path garment;  ///< an OBJ or glTF file; empty: the dress that ships
    float unit = 0;                 ///< metres in a unit of an OBJ file; 0: a garment's size decides
    bool y_is_up = false;           ///< up in an OBJ file without "Free" materials is +Y; else +Z
    std::uint32_t particles = 0;    ///< of the dress that ships, about; 0: 3100
    std::uint32_t drawn = 0;        ///< vertices of a finer dress that is drawn instead, about; 0: none
    std::uint32_t simulated = 0;    ///< particles of a proxy of a file's garment, about; 0: none is made
    double speed = 1;               ///< factor on the motion's own speed
    Vec3 place{};                   ///< the motion's origin on the ground [m]
    double ahead = 0;               ///< the motion's own time at its start [s]
    BodySurface surface = BodySurface::capsules;
    ClothSettings cloth{};
};

class Character {
  public:
    /// Reads the files that the settings name. Error: a file that cannot be read, or a garment that does not
    /// fit, and why; with BodySurface::skin, a glTF file without triangles of a body.
    [[nodiscard]] static Result<Character> create(const CharacterSettings& settings);

    /// Adds cloth, pins, maps and colliders to the World. Error: the World's; earlier additions stay.
    [[nodiscard]] Result<void> enter(World& world);
    /// Moves colliders, pins and the skin targets of leashes and backstops to their places at the end of the
    /// step from `time` to `time + dt` [s].
    void before_step(World& world, double time, float dt);

    /// Places the body as at that time [s], without the World's colliders and pins.
    void go_to(double time);

    /// Gives the cloth a skin, to which leashes and backstops refer, if it has none. Error: the World's.
    [[nodiscard]] Result<void> give_skin(World& world);

    /// Transforms body and garment at once, about the World's origin. The garment keeps its shape and motion
    /// relative to the body. Error: the World's. If the cloth cannot be moved, nothing is.
    [[nodiscard]] Result<void> teleport(World& world, const Transform& by);

    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] const Garment& garment() const { return garment_; }
    [[nodiscard]] const std::vector<ColliderId>& colliders() const { return colliders_; }
    /// The body at one moment.
    struct PlacedBody {
        Pose pose;
        std::vector<TaperedCapsule> capsules;
    };
    /// The body at the end of the step that before_step() prepared, and at its start.
    [[nodiscard]] const PlacedBody& body_now() const { return now_; }
    [[nodiscard]] const PlacedBody& body_before() const { return before_; }
    /// The limbs at the end of that step.
    [[nodiscard]] const std::vector<TaperedCapsule>& capsules() const { return now_.capsules; }
    /// The skin's vertices at the same time [m]; null without a skin. Later steps overwrite this memory.
    [[nodiscard]] const std::shared_ptr<std::vector<Vec3>>& skin_places() const { return skin_places_; }
    [[nodiscard]] const Skin& skin() const { return skin_; }
    /// The points that leashes and backstops refer to, by vertex [m]; empty without give_skin() where
    /// the garment has neither.
    [[nodiscard]] const std::vector<Vec3>& skin_targets() const { return limit_places_; }
    [[nodiscard]] const Skeleton& skeleton() const { return performance_.skeleton(); }
    [[nodiscard]] const Fit& fitted() const { return fit_; }
    [[nodiscard]] const Body& body() const { return body_; }
    [[nodiscard]] const Pose& pose() const { return now_.pose; }

  private:
    Character(Body body, Performance performance, Garment garment, Fit fit,
              const CharacterSettings& settings);
    static Result<Character> create_skinned(const CharacterSettings& settings);
    void follow(double time);
    void add_body(World& world);
    void add_maps(World& world);
    void bind_limits(const Pose& stance, const Binding* own);
    void use_limits();
    void take_skin(Skin skin);

    Body body_;
    Performance performance_;
    Garment garment_;
    Fit fit_;
    CharacterSettings settings_;
    double fitting_ = 0, followed_ = 0;         // followed_: the time of this pose [s]
    Quaternion turn_ = Quaternion::Identity();  // from the motion's axes to the World's
    Vector3 place_;                             // the motion's origin in the World [m]
    Binding binding_;
    PlacedBody now_, before_;
    JointAngles angles_;
    std::vector<Vec3> targets_;
    Skin skin_;
    std::shared_ptr<std::vector<Vec3>> skin_places_;
    ShapeId skin_shape_;
    Binding limits_;  // skin targets of all vertices, for leashes and backstops
    Pose limits_bound_;
    bool has_limits_ = false;  // the cloth has the skin
    std::vector<Vec3> normals_, limit_places_, limit_normals_;
    ClothId cloth_;
    std::vector<ColliderId> colliders_;
};

}  // namespace weft::demo
