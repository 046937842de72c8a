#include "demo/character/character.h"

#include <algorithm>
#include <utility>

#include "demo/character/garment/fitting.h"
#include "demo/character/garment/garment_file.h"
#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/gltf_file.h"
#include "demo/character/motion/generated_walk.h"
#include "demo/character/motion/live_motion.h"
#include "demo/character/motion/motion.h"
#include "demo/must.h"

namespace weft::demo {
namespace {

constexpr double growing = 1.0;                      // duration of the body's growth into a garment [s]
constexpr double standing = 0.3, blending_in = 0.9;  // [s]

Result<std::unique_ptr<Motion>> make_motion(const CharacterSettings& settings) {
    const std::filesystem::path& file = settings.motion;
    if (file.empty())
        return std::unique_ptr<Motion>(std::make_unique<GeneratedWalk>(settings.runs ? running : Gait{}));
    if (std::filesystem::is_fifo(file)) {
        auto live = LiveMotion::open(file);
        if (!live) return live.error();
        return std::unique_ptr<Motion>(std::move(*live));
    }
    auto recording = read_bvh(file);
    if (!recording) return recording.error();
    return std::unique_ptr<Motion>(std::make_unique<RecordedMotion>(std::move(*recording)));
}

Result<Garment> make_garment(const CharacterSettings& settings, const Skeleton& skeleton, const Body& body) {
    if (!settings.garment.empty()) {
        auto read = read_garment(settings.garment, settings.unit, settings.y_is_up);
        if (!read || settings.simulated == 0) return read;
        if (auto made = simulate_proxy(*read, settings.simulated); !made) return made.error();
        return read;
    }
    Pose pose;
    place_joints(skeleton, body.stance(skeleton, Fit().arms), pose);
    Garment dress = make_dress(body, pose, settings.particles == 0 ? 3100 : settings.particles);
    if (settings.drawn > 0) dress.fine = make_dress(body, pose, settings.drawn).mesh;
    return dress;
}

/// Makes the skin that of a coarser mesh: each vertex gets the joints and weights of one of the finer mesh.
void take_vertices(SkinnedMesh& skinned, const std::vector<std::uint32_t>& vertices, const Mesh& coarse) {
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    for (const std::uint32_t v : vertices)
        for (std::size_t k = skinned.influences * v; k < skinned.influences * (v + std::size_t{1}); ++k) {
            joints.push_back(skinned.joints[k]);
            weights.push_back(skinned.weights[k]);
        }
    skinned = {coarse, skinned.influences, std::move(joints), std::move(weights), {}};
}

/// A point is beyond a limb if it is outside of a ball about the limb's middle that holds all of it. For half
/// its length l and its greater radius r the ball has sqrt(2 l^2 + 2 r^2), which is at least l + r.
bool is_beyond(const TaperedCapsule& limb, const Vector3& point) {
    const Vector3 a = to_vector(limb.a), b = to_vector(limb.b);
    const float radius = std::max(limb.radius_a, limb.radius_b);
    return (point - 0.5f * (a + b)).squaredNorm() > 0.5f * (b - a).squaredNorm() + 2 * radius * radius;
}

/// Moves a target out of all limbs. A point that follows one limb may be inside another that bends into it,
/// and contact cannot move pinned particles.
Vec3 outside(const std::vector<TaperedCapsule>& body, const Vec3& point) {
    constexpr int rounds = 3;  // a point moved out of one limb may be inside the next
    Vector3 moved = to_vector(point);
    bool is_inside = true;
    for (int round = 0; round < rounds && std::exchange(is_inside, false); ++round)
        for (const TaperedCapsule& limb : body) {
            if (is_beyond(limb, moved)) continue;
            const SurfaceDistance to = distance_to(limb, moved);
            if (!(to.distance < 0)) continue;
            moved -= to.distance * to.normal;
            is_inside = true;
        }
    return to_vec3(moved);
}

}  // namespace

/// A character of a glTF file with its own skeleton, motion and weights, at first in the file's rest pose.
Result<Character> Character::create_skinned(const CharacterSettings& settings) {
    if (!settings.motion.empty())
        return Error{
            ErrorCode::invalid_argument,
            settings.garment.string() + " has a motion of its own; leave out " + settings.motion.string()};
    const bool has_skin = settings.surface == BodySurface::skin;
    auto read = read_gltf(settings.garment, has_skin);
    if (!read) return read.error();
    auto body = Body::create(read->recording.skeleton);
    if (!body) return Error{body.error().code, settings.garment.string() + ": " + body.error().message};
    SkinnedMesh& worn = read->worn;
    if (settings.simulated > 0) {
        const auto nearest = simulate_proxy(read->garment, settings.simulated);
        if (!nearest) return nearest.error();
        take_vertices(worn, *nearest, read->garment.mesh);
    }
    Fit fit;
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    for (const std::uint32_t vertex : read->garment.fixed) {
        fit.held.push_back(read->garment.mesh.positions[vertex]);
        const std::size_t first = worn.influences * vertex;
        joints.insert(joints.end(), &worn.joints[first], &worn.joints[first] + worn.influences);
        weights.insert(weights.end(), &worn.weights[first], &worn.weights[first] + worn.influences);
    }
    Pose pose;
    place_joints(read->recording.skeleton, read->rest, pose);
    const auto in_file = [&](const char* what, const Error& error) {
        return Error{error.code, settings.garment.string() + ": " + what + error.message};
    };
    auto binding = Binding::by_weights(pose, fit.held, joints, weights);
    if (!binding) return in_file("fixed ", binding.error());
    auto all = Binding::by_weights(pose, worn.mesh.positions, worn.joints, worn.weights);
    if (!all) return in_file("", all.error());
    Skin skin;
    if (has_skin) {
        auto made = Skin::by_weights(read->body.mesh, pose, read->body.joints, read->body.weights);
        if (!made) return in_file("the body's ", made.error());
        skin = std::move(*made);
    }
    Performance performance(std::make_unique<RecordedMotion>(std::move(read->recording)), read->rest,
                            standing, blending_in, settings.speed, settings.ahead);
    Character character(std::move(*body), std::move(performance), std::move(read->garment), std::move(fit),
                        settings);
    character.binding_ = std::move(*binding);
    character.bind_limits(pose, &*all);
    if (has_skin) character.take_skin(std::move(skin));
    character.go_to(0);
    return character;
}

Result<Character> Character::create(const CharacterSettings& settings) {
    if (is_gltf(settings.garment)) return create_skinned(settings);
    auto motion = make_motion(settings);
    if (!motion) return motion.error();
    const Skeleton& skeleton = (*motion)->skeleton();
    auto body = Body::create(skeleton);
    if (!body) return Error{body.error().code, settings.motion.string() + ": " + body.error().message};
    auto garment = make_garment(settings, skeleton, *body);
    if (!garment) return garment.error();
    auto fitted = fit(skeleton, *body, *garment);
    if (!fitted) return Error{fitted.error().code, settings.garment.string() + ": " + fitted.error().message};
    Performance performance(std::move(*motion), body->stance(skeleton, fitted->arms),
                            standing + (fitted->inside > 0 ? growing : 0), blending_in, settings.speed,
                            settings.ahead);
    return Character(std::move(*body), std::move(performance), std::move(*garment), std::move(*fitted),
                     settings);
}

Character::Character(Body body, Performance performance, Garment garment, Fit fit,
                     const CharacterSettings& settings)
    : body_(std::move(body)),
      performance_(std::move(performance)),
      garment_(std::move(garment)),
      fit_(std::move(fit)),
      settings_(settings),
      fitting_(fit_.inside > 0 ? growing : 0),
      place_(to_vector(settings_.place)),
      targets_(garment_.fixed.size()) {
    Pose stance;
    place_joints(performance_.skeleton(), performance_.stance(), stance);
    binding_ = Binding::to_nearest(body_, stance, fit_.held);
    bind_limits(stance, nullptr);
    if (settings_.surface == BodySurface::skin && !is_gltf(settings_.garment))
        take_skin(Skin::round_limbs(body_, performance_.skeleton(), fit_.girth));
    for (std::vector<Vec3>* positions : {&garment_.mesh.positions, &garment_.fine.positions}) {
        for (Vec3& p : *positions) p = to_vec3(to_vector(p) + to_vector(settings_.place));
    }
    go_to(0);
}

void Character::take_skin(Skin skin) {
    skin_ = std::move(skin);
    skin_places_ = std::make_shared<std::vector<Vec3>>(skin_.size());
}

void Character::go_to(double time) {
    follow(time);
    before_ = now_;
}

/// Binds skin targets, which are used if the garment has leashes or backstops. `own`: a file's weights, or
/// null.
void Character::bind_limits(const Pose& stance, const Binding* own) {
    const std::vector<Vec3>& positions = garment_.mesh.positions;
    limits_ = own != nullptr ? *own : Binding::to_nearest(body_, stance, positions);
    limits_bound_ = stance;
    normals_.clear();
    for (const Vector3& normal : outward_normals(garment_.mesh)) normals_.push_back(to_vec3(normal));
    const auto limits = [](const PaintedMap& painted) {
        return painted.map == Map::leash || painted.map == Map::backstop;
    };
    if (std::ranges::any_of(garment_.maps, limits)) use_limits();
}

void Character::use_limits() {
    has_limits_ = true;
    limit_places_.resize(limits_.size());
    limit_normals_.resize(limits_.size());
}

Result<void> Character::give_skin(World& world) {
    if (has_limits_) return {};
    use_limits();
    follow(followed_);
    return world.set_skin(cloth_, limit_places_, limit_normals_);
}

void Character::follow(double time) {
    followed_ = time;
    angles_ = performance_.at(time);
    angles_.root = turn_ * angles_.root + place_;
    angles_.rotations[0] = turn_ * angles_.rotations[0];
    place_joints(performance_.skeleton(), angles_, now_.pose);
    const float growth = growth_at(time, fitting_);
    body_.place(now_.pose, fit_.girth * growth, now_.capsules);
    binding_.place(now_.pose, targets_);
    if (settings_.surface == BodySurface::capsules)
        for (Vec3& target : targets_) target = outside(now_.capsules, target);
    if (has_limits_) {
        limits_.place(now_.pose, limit_places_);
        limits_.turn(limits_bound_, now_.pose, normals_, limit_normals_);
    }
    if (skin_places_) skin_.place(now_.pose, now_.capsules, growth, *skin_places_);
    if (growth == 1) return;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const Vector3 start = to_vector(garment_.mesh.positions[garment_.fixed[i]]);
        targets_[i] = to_vec3(start + smooth_step(time / fitting_) * (to_vector(targets_[i]) - start));
    }
}

void Character::add_body(World& world) {
    const auto add = [&](const Collider& collider) {
        colliders_.push_back(must(world.add_collider(collider)));
    };
    if (skin_places_) {
        TriangleMesh mesh{.vertices = *skin_places_, .triangles = skin_.triangles()};
        auto shape = world.add_shape(mesh);
        mesh.closed = false;
        if (!shape)
            if (auto open = world.add_shape(mesh)) {
                garment_.notes.push_back(
                    "the body's skin is open, as at a neck or a wrist: it keeps cloth on the side where it "
                    "starts, and pushes none out; close its holes where it is to do so");
                shape = open;
            }
        if (!shape) throw Refusal({shape.error().code, "the body's skin: " + shape.error().message});
        skin_shape_ = *shape;
        return add({.shape = PlacedShape{.shape = *shape}});
    }
    for (const TaperedCapsule& capsule : now_.capsules) add({.shape = capsule});
}

void Character::add_maps(World& world) {
    for (const PaintedMap& painted : garment_.maps) must(world.set_map(cloth_, painted.map, painted.values));
    if (has_limits_) must(world.set_skin(cloth_, limit_places_, limit_normals_));
}

Result<void> Character::enter(World& world) {
    return caught([&] {
        cloth_ = must(world.add_cloth(garment_.mesh, settings_.cloth));
        must(world.pin(cloth_, garment_.fixed));
        add_maps(world);
        add_body(world);
    });
}

void Character::before_step(World& world, double time, float dt) {
    std::swap(now_, before_);
    follow(time + static_cast<double>(dt));
    if (skin_places_) {
        (void)world.deform_shape(skin_shape_, *skin_places_);
    } else {
        for (std::size_t limb = 0; limb < now_.capsules.size(); ++limb)
            (void)world.move_collider(colliders_[limb], {.shape = now_.capsules[limb]});
    }
    (void)world.move_pins(cloth_, garment_.fixed, targets_);
    if (has_limits_) (void)world.set_skin(cloth_, limit_places_, limit_normals_);
}

Result<void> Character::teleport(World& world, const Transform& by) {
    if (auto moved = world.move_cloth(cloth_, by); !moved) return moved;
    const Quaternion turn =
        Quaternion(by.rotation.w, by.rotation.x, by.rotation.y, by.rotation.z).normalized();
    turn_ = (turn * turn_).normalized();
    place_ = turn * place_ + to_vector(by.translation);
    go_to(followed_);
    return caught([&] {
        if (skin_places_) {  // deforming the shape would drag cloth on its way
            must(world.remove_collider(colliders_.front()));
            must(world.remove_shape(skin_shape_));
            colliders_.clear();
            return add_body(world);
        }
        for (std::size_t limb = 0; limb < now_.capsules.size(); ++limb)
            must(world.place_collider(colliders_[limb], {.shape = now_.capsules[limb]}));
    });
}

}  // namespace weft::demo
