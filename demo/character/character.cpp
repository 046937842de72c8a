#include "demo/character/character.h"

#include <utility>

#include "demo/character/motion/generated_walk.h"
#include "demo/character/motion/recorded_motion.h"

namespace weft::demo {
namespace {

constexpr double standing = 0.3, blending_in = 0.9;  // [s]

Result<std::unique_ptr<Motion>> make_motion(const std::filesystem::path& file) {
    if (file.empty()) return std::unique_ptr<Motion>(std::make_unique<GeneratedWalk>());
    auto recording = read_bvh(file);
    if (!recording) return recording.error();
    return std::unique_ptr<Motion>(std::make_unique<RecordedMotion>(std::move(*recording)));
}

}  // namespace

Result<Character> Character::create(const CharacterSettings& settings) {
    auto motion = make_motion(settings.motion);
    if (!motion) return motion.error();
    const Skeleton& skeleton = (*motion)->skeleton();
    auto body = Body::create(skeleton);
    if (!body) return Error{body.error().code, settings.motion.string() + ": " + body.error().message};
    const JointAngles stance = body->stance(skeleton, 60);
    Pose pose;
    place_joints(skeleton, stance, pose);
    Garment garment = make_dress(*body, pose, settings.particles == 0 ? 3100 : settings.particles);
    Performance performance(std::move(*motion), stance, standing, blending_in, settings.speed);
    return Character(std::move(*body), std::move(performance), std::move(garment), settings);
}

Character::Character(Body body, Performance performance, Garment garment, const CharacterSettings& settings)
    : body_(std::move(body)),
      performance_(std::move(performance)),
      garment_(std::move(garment)),
      settings_(settings),
      targets_(garment_.fixed.size()) {
    follow(0);
    std::vector<Vec3> fixed;
    for (const std::uint32_t vertex : garment_.fixed) fixed.push_back(garment_.mesh.positions[vertex]);
    Pose stance;
    place_joints(performance_.skeleton(), performance_.stance(), stance);
    binding_ = Binding::to_nearest(body_, stance, fixed);
    for (Vec3& p : garment_.mesh.positions) p = to_vec3(to_vector(p) + to_vector(settings_.place));
}

void Character::follow(double time) {
    angles_ = performance_.at(time);
    angles_.root += to_vector(settings_.place);
    place_joints(performance_.skeleton(), angles_, pose_);
    body_.place(pose_, 1, capsules_);
}

Result<void> Character::enter(World& world) {
    const auto cloth = world.add_cloth(garment_.mesh, settings_.cloth);
    if (!cloth) return cloth.error();
    cloth_ = *cloth;
    if (auto pinned = world.pin(cloth_, garment_.fixed); !pinned) return pinned;
    for (const TaperedCapsule& capsule : capsules_) {
        const auto collider = world.add_collider({.shape = capsule});
        if (!collider) return collider.error();
        colliders_.push_back(*collider);
    }
    return {};
}

void Character::before_step(World& world, double time, float dt) {
    follow(time + static_cast<double>(dt));
    for (std::size_t limb = 0; limb < capsules_.size(); ++limb)
        (void)world.move_collider(colliders_[limb], {.shape = capsules_[limb]});
    binding_.place(pose_, targets_);
    (void)world.move_pins(cloth_, garment_.fixed, targets_);
}

}  // namespace weft::demo
