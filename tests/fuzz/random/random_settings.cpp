#include "tests/fuzz/random/random_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace weft::fuzz {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Draws fields: reasonable ones within the range that is given, extreme ones up to ten times beyond its
/// ends, which the documented ranges still hold.
class Fields {
  public:
    Fields(Random& random, bool extreme) : random_(random), extreme_(extreme) {}

    [[nodiscard]] float positive(float low, float high) {
        if (beyond_reason()) return random_.of_any_size(0.1f * low, 10 * high);
        return random_.of_any_size(low, high);
    }
    [[nodiscard]] float zero_or_more(float low, float high) {
        return random_.chance(0.2) ? 0.0f : positive(low, high);
    }
    [[nodiscard]] Vec3 vector(float reach) {
        if (beyond_reason()) return random_.point(10 * reach);
        return random_.point(reach);
    }
    /// A combination that is not refused, but that a method may have no use for.
    [[nodiscard]] bool odd_choice() { return beyond_reason(); }

  private:
    bool beyond_reason() { return extreme_ && random_.chance(0.15); }

    Random& random_;
    bool extreme_;
};

Method random_method(Random& random, int most_iterations) {
    const int iterations = random.whole(1, std::max(1, most_iterations));
    switch (random.below(8)) {
        case 0:
            return Jacobi{random.chance(0.1) ? 0 : iterations, random.chance(0.5)};
        case 1:
            return Chebyshev{iterations, random.chance(0.5)};
        case 2:
            return ConjugateGradient{iterations};
        case 3:
            return Xpbd{iterations};
        case 4: {
            const auto solver = [&] {
                return random.chance(0.5) ? Fibres::SetSolver::ldlt : Fibres::SetSolver::gauss_seidel;
            };
            const Fibres::SetSolver vertical = solver(), horizontal = solver(), shear = solver();
            return Fibres{iterations, vertical, horizontal, shear};
        }
        case 5:
            return SymplecticEuler{};
        default: {
            const int passes = random.whole(1, std::clamp(iterations, 1, 8));
            return Multilevel{.passes = passes,
                              .tolerance = random.chance(0.2) ? 0.0f : random.of_any_size(1e-3f, 1e3f)};
        }
    }
}

bool is_positional(const Method& method) {
    return std::holds_alternative<Xpbd>(method) || std::holds_alternative<Fibres>(method);
}

FiniteElements random_elements(Random& random, Fields& fields, const Method& method) {
    const bool positional = is_positional(method);
    const bool is_explicit = std::holds_alternative<SymplecticEuler>(method);
    FiniteElements elements;
    elements.enabled = random.chance(0.4) && (!positional || fields.odd_choice());
    elements.poisson = random.chance(0.5) ? 0 : random.between(0, 0.499f);
    elements.dihedral = random.chance(0.5);
    elements.consistent_mass = random.chance(0.3) && ((!is_explicit && !positional) || fields.odd_choice());
    return elements;
}

/// Puts one number out of its range.
template <class Settings>
void spoil(Random& random, Settings& settings) {
    const std::vector<SettingNumber> numbers = numbers_of(settings).value();
    const SettingNumber& number = numbers[random.below(numbers.size())];
    if (auto* const* const whole = std::get_if<int*>(&number.value)) {
        const int least = static_cast<int>(number.least), greatest = static_cast<int>(number.greatest);
        **whole = random.one_of({least - 1, greatest + 1, std::numeric_limits<int>::min()});
        return;
    }
    auto* const* const vector = std::get_if<Vec3*>(&number.value);
    (vector ? (*vector)->y : *std::get<float*>(number.value)) =
        random.one_of({std::nextafter(number.least, -infinity), not_a_number, infinity, -infinity});
}

/// Reasonable in most draws, extreme in some, out of range in few.
Answer random_answer(Random& random) {
    return random.chance(0.1) ? Answer::refused : random.chance(0.2) ? Answer::either : Answer::accepted;
}

Drawn<Collider> finished(Random& random, Collider collider, bool extreme) {
    if (!random.chance(0.05)) return {collider, extreme ? Answer::either : Answer::accepted};
    if (random.chance(0.5)) {
        float* const fields[] = {&collider.friction, &collider.thickness, &collider.restitution};
        *fields[random.below(std::size(fields))] = random.one_of({-1.0f, not_a_number, infinity});
    } else if (auto* const placed = std::get_if<PlacedShape>(&collider.shape)) {
        (random.chance(0.5) ? placed->rotation.w : placed->position.x) = not_a_number;
    } else if (auto* const sphere = std::get_if<Sphere>(&collider.shape)) {
        (random.chance(0.5) ? sphere->radius : sphere->center.x) = not_a_number;
    } else if (auto* const capsule = std::get_if<Capsule>(&collider.shape)) {
        (random.chance(0.5) ? capsule->radius : capsule->b.y) = not_a_number;
    } else if (auto* const tapered = std::get_if<TaperedCapsule>(&collider.shape)) {
        (random.chance(0.5) ? tapered->radius_b : tapered->a.z) = random.one_of({-infinity, not_a_number});
    } else if (auto* const box = std::get_if<Box>(&collider.shape)) {
        float* const fields[] = {&box->center.y, &box->rotation.x, &box->half_extents.z};
        *fields[random.below(std::size(fields))] = random.one_of({infinity, not_a_number});
        if (random.chance(0.3)) box->half_extents.x = -1;
    } else {
        std::get<Plane>(collider.shape).normal = random.chance(0.5) ? Vec3{} : Vec3{0, infinity, 0};
    }
    return {collider, Answer::refused};
}

/// Draws the collider's fields besides shape and friction; most keep their defaults.
void draw_surface(Random& random, Fields& fields, Collider& collider) {
    if (random.chance(0.3)) collider.thickness = std::min(fields.zero_or_more(1e-3f, 0.1f), 10.0f);
    if (random.chance(0.3)) collider.restitution = random.between(0, 1);
    if (random.chance(0.3)) collider.layers = random.below(4);
    if (random.chance(0.15)) collider.is_trigger = true;
}

Rotation turned(Random& random) {
    const Vec3 axis = random.point(1);
    const float w = random.between(0.1f, 1);  // never of no length
    const float length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z + w * w);
    return {axis.x / length, axis.y / length, axis.z / length, w / length};
}

Vec3 moved(Random& random, const Vec3& from) {
    const float reach = random.chance(0.2) ? random.of_any_size(1, 1e4f) : 0.1f;
    const Vec3 by = random.point(reach);
    return {from.x + by.x, from.y + by.y, from.z + by.z};
}

}  // namespace

Drawn<Transform> random_transform(Random& random) {
    Transform drawn{.translation = random.point(random.chance(0.1) ? random.of_any_size(1, 1e4f) : 0.3f)};
    if (random.chance(0.7)) drawn.rotation = turned(random);
    if (!random.chance(0.05)) return {drawn, Answer::either};
    (random.chance(0.5) ? drawn.translation.y : drawn.rotation.z) = random.one_of({infinity, not_a_number});
    return {drawn, Answer::refused};
}

Drawn<Map> random_map(Random& random) {
    const auto map = static_cast<Map>(random.below(9));
    const bool may_refuse =
        map == Map::mass || map == Map::stiffness || map == Map::leash || map == Map::backstop;
    return {map, may_refuse ? Answer::either : Answer::accepted};
}

float map_value(Random& random, Map map) {
    switch (map) {
        case Map::mass:
            return random.of_any_size(0.1f, 10);
        case Map::pin:
            return random.chance(0.9) ? 0.0f : 1.0f;
        case Map::leash:
            return random.chance(0.3) ? infinity : random.chance(0.1) ? 0 : random.of_any_size(1e-4f, 1);
        case Map::backstop:
            return random.chance(0.3) ? infinity : random.between(-0.001f, 0.1f);
        case Map::backstop_radius:
            return random.chance(0.3) ? infinity : random.of_any_size(1e-3f, 1e5f);
        case Map::friction:
            return random.between(0, 2);
        case Map::thickness:
            return random.unit() < 0.5 ? 1.0f : random.between(0, 1);
        case Map::stiffness:
            return random.of_any_size(0.1f, 10);
        case Map::collider_mask:
            return static_cast<float>(random.below(4));
    }
    return 1;
}

std::uint64_t passes_of(const ClothSettings& settings) {
    const auto passes = std::visit(
        [](const auto& method) -> std::int64_t {
            using M = std::decay_t<decltype(method)>;
            if constexpr (std::is_same_v<M, SymplecticEuler>) {
                return 1;
            } else if constexpr (std::is_same_v<M, Multilevel>) {
                constexpr std::int64_t more = 3;  // passes that a hard step adds
                return 8 * (method.passes + more);
            } else {
                return method.iterations;
            }
        },
        settings.method);
    return static_cast<std::uint64_t>(std::max(settings.substeps, 1)) *
           (8 + static_cast<std::uint64_t>(std::max<std::int64_t>(passes, 0)));
}

static Filling random_filling(Random& random, Fields& fields) {
    Filling filling;
    filling.kind = random.one_of({FillingKind::pressure, FillingKind::gas, FillingKind::volume});
    filling.pressure = random.chance(0.2) ? -fields.positive(1, 1000) : fields.zero_or_more(1, 5000);
    filling.volume = random.chance(0.7) ? 0 : fields.positive(1e-3f, 1);
    if (random.chance(0.2)) filling.outside = fields.zero_or_more(1, 1e5f);
    return filling;
}

Drawn<ClothSettings> random_cloth_settings(Random& random, std::uint64_t most_passes) {
    Drawn<ClothSettings> drawn;
    drawn.answer = random_answer(random);
    Fields fields(random, drawn.answer == Answer::either);
    ClothSettings& s = drawn.value;
    s.fabric.areal_density = fields.positive(0.02f, 5);
    s.fabric.warp = fields.zero_or_more(0.1f, 1e6f);
    s.fabric.weft = fields.zero_or_more(0.1f, 1e6f);
    s.fabric.shear = fields.zero_or_more(0.1f, 1e5f);
    s.fabric.bending = fields.zero_or_more(1e-8f, 1);
    s.fabric.damping = fields.zero_or_more(1e-6f, 1);
    s.substeps = random.chance(0.5)
                     ? 1
                     : random.whole(1, static_cast<int>(std::min<std::uint64_t>(1024, most_passes / 9)));
    const auto passes = most_passes / static_cast<std::uint64_t>(s.substeps);
    s.method = random_method(random, static_cast<int>(std::min<std::uint64_t>(passes / 9, 200)));
    s.finite_elements = random_elements(random, fields, s.method);
    if (s.finite_elements.enabled && !fields.odd_choice())
        for (float* k : {&s.fabric.warp, &s.fabric.weft, &s.fabric.shear}) *k = std::max(*k, 1e-3f);
    s.time_scheme = random.one_of({TimeScheme::of_method, TimeScheme::backward_euler, TimeScheme::bdf2});
    s.tethers.enabled = random.chance(0.3);
    s.tethers.slack = random.chance(0.5) ? 1 : 1 + fields.zero_or_more(1e-3f, 1);
    if (random.chance(0.3))
        s.self_collision.method =
            random.one_of({SelfCollisionMethod::contact, SelfCollisionMethod::impact_zones,
                           SelfCollisionMethod::avoidance, SelfCollisionMethod::avoidance_by_shifted_grids,
                           SelfCollisionMethod::avoidance_by_sorted_sweep});
    if (s.self_collision.method == SelfCollisionMethod::impact_zones && random.chance(0.5))
        s.self_collision.restitution = random.between(0, 1);
    s.self_collision.layers = random.chance(0.8) ? 1u : 2u;
    s.self_collision.mask = random.chance(0.8) ? ~0u : 1u;
    s.self_collision.distance = fields.zero_or_more(1e-3f, 0.1f);
    s.self_collision.friction = fields.zero_or_more(1e-2f, 2);
    if (random.chance(0.5))
        s.frame_inertia = {random.between(0, 1), random.chance(0.3) ? 1.0f : random.between(0, 1),
                           random.between(0, 1)};
    // A distance of very many edges is refused, by the mesh.
    if (s.self_collision.method != SelfCollisionMethod::off && s.self_collision.distance > 0 &&
        drawn.answer == Answer::accepted)
        drawn.answer = Answer::either;
    const bool stiffens = !is_positional(s.method) && !s.finite_elements.enabled;
    if (random.chance(0.3) && (stiffens || fields.odd_choice()))
        s.fabric.stiffening = std::min(fields.positive(0.1f, 100), 1000.0f);
    if (random.chance(0.2)) s.fabric.bending_ratio = std::exp2(random.between(-6, 6));
    s.air_damping = fields.zero_or_more(1e-2f, 20);
    s.thickness = fields.zero_or_more(1e-4f, 0.1f);
    s.friction = fields.zero_or_more(1e-2f, 2);
    if (random.chance(0.2)) s.restitution = random.between(0, 1);
    if (random.chance(0.3)) s.sleep_speed = fields.zero_or_more(1e-3f, 10);
    s.enabled = !random.chance(0.05);
    s.importance = random.one_of({0.0f, 1e-3f, 1.0f, 1e6f});
    // No teleports by frames: they take pins along, and a script expects pins where it has moved them.
    if (random.chance(0.2)) s.gravity_scale = random.between(-10, 10);
    if (random.chance(0.2)) s.wind_scale = random.between(0, 10);
    if (random.chance(0.1)) s.drag_scale = random.between(0, 10);
    if (random.chance(0.1)) s.lift_scale = random.between(0, 10);
    if (random.chance(0.1)) s.max_speed_in_frame = random.between(0, 20);
    if (random.chance(0.3)) s.collider_mask = random.below(4);
    if (random.chance(0.1)) s.collider_response = ColliderResponse::velocity_filter;
    if (random.chance(0.2)) s.back_friction_ratio = fields.zero_or_more(1e-2f, 10);
    if (random.chance(0.3)) {
        s.filling = random_filling(random, fields);
        // A filling of a mesh that is not closed, by another method, or with less than no gas is refused.
        if (drawn.answer == Answer::accepted) drawn.answer = Answer::either;
    }
    if (drawn.answer == Answer::refused) spoil(random, s);
    return drawn;
}

static void draw_sources(Random& random, Fields& fields, Wind& wind) {
    for (AirSource& source : wind.sources) {
        if (random.chance(0.6)) continue;
        source = {.kind = static_cast<AirSourceKind>(random.below(4)),
                  .position = random.point(random.chance(0.1) ? 1e4f : 2.0f),
                  .velocity = random.chance(0.1) ? Vec3{} : fields.vector(20),
                  .radius = fields.positive(1e-2f, 10)};
    }
}

static void draw_shelters(Random& random, Fields& fields, Wind& wind) {
    for (AirShelter& shelter : wind.shelters) {
        if (random.chance(0.6)) continue;
        shelter = {.kind = static_cast<AirShelterKind>(random.below(3)),
                   .position = random.point(random.chance(0.1) ? 1e4f : 2.0f),
                   .half_extents = {fields.positive(1e-2f, 10), fields.positive(1e-2f, 10),
                                    fields.positive(1e-2f, 10)},
                   .radius = fields.positive(1e-2f, 10),
                   .border = fields.positive(1e-2f, 10),
                   .exposure = random.between(0, 1)};
    }
}

Drawn<WorldSettings> random_world_settings(Random& random, int most_substeps) {
    Drawn<WorldSettings> drawn;
    drawn.answer = random_answer(random);
    Fields fields(random, drawn.answer == Answer::either);
    WorldSettings& s = drawn.value;
    s.gravity = random.chance(0.5) ? Vec3{0, -9.81f, 0} : fields.vector(30);
    s.wind.velocity = random.chance(0.5) ? Vec3{} : fields.vector(20);
    s.wind.gust = fields.zero_or_more(1e-2f, 2);
    s.wind.gust_length = fields.positive(0.05f, 50);
    s.wind.air_density = fields.zero_or_more(0.1f, 5);
    s.wind.drag = fields.zero_or_more(0.1f, 3);
    s.wind.lift = fields.zero_or_more(0.1f, 3);
    s.wind.seed = static_cast<std::uint32_t>(random.next());
    if (random.chance(0.3)) draw_sources(random, fields, s.wind);
    if (random.chance(0.3)) draw_shelters(random, fields, s.wind);
    s.max_speed = fields.positive(0.1f, 1000);
    s.substeps = random.whole(1, std::clamp(most_substeps, 1, 256));
    s.contact_reports = random.one_of({0, 0, 1, 100, 10000});
    // So little that what is chosen does not depend on time.
    s.budget = random.one_of({0.0f, 0.0f, 0.0f, 1e-6f});
    s.threads = random.one_of({0, 1, 1, 2, 2, 3, 5});
    if (random.chance(0.1)) s.executor = backwards_executor();
    if (drawn.answer == Answer::refused) spoil(random, s);
    return drawn;
}

Drawn<Collider> random_collider(Random& random) {
    const bool extreme = random.chance(0.1);
    Fields fields(random, extreme);
    Collider collider;
    collider.friction = fields.zero_or_more(1e-2f, 2);
    const float radius = fields.positive(0.01f, 1);
    switch (random.below(5)) {
        case 0:
            collider.shape = Sphere{fields.vector(2), radius};
            break;
        case 1: {
            const Vec3 a = fields.vector(2);
            collider.shape = Capsule{a, random.chance(0.2) ? a : fields.vector(2), radius};
            break;
        }
        case 2: {
            const Vec3 a = fields.vector(2);
            collider.shape = TaperedCapsule{a, random.chance(0.2) ? a : fields.vector(2), radius,
                                            fields.positive(0.01f, 1)};
            break;
        }
        case 3: {
            const Vec3 center = fields.vector(2);
            collider.shape = Box{center,
                                 random.chance(0.3) ? Rotation{} : turned(random),
                                 {radius, fields.positive(0.01f, 1), fields.positive(0.01f, 1)}};
            break;
        }
        default: {
            Vec3 normal = random.chance(0.5) ? Vec3{0, 1, 0} : fields.vector(3);
            normal.y += normal.y < 0 ? -0.01f : 0.01f;  // never of no length
            collider.shape = Plane{normal, random.between(-2, 1)};
            break;
        }
    }
    draw_surface(random, fields, collider);
    return finished(random, collider, extreme);
}

Drawn<Collider> random_instance(Random& random, std::size_t shape) {
    const bool extreme = random.chance(0.1);
    Fields fields(random, extreme);
    Collider collider;
    collider.shape = PlacedShape{.shape = {static_cast<std::uint32_t>(shape), 1},
                                 .position = fields.vector(1),
                                 .rotation = random.chance(0.5) ? Rotation{} : turned(random)};
    draw_surface(random, fields, collider);
    return finished(random, collider, extreme);
}

Drawn<Collider> random_move(Random& random, const Collider& from) {
    Collider to = from;
    if (auto* const sphere = std::get_if<Sphere>(&to.shape)) {
        sphere->center = moved(random, sphere->center);
        if (random.chance(0.2)) sphere->radius *= random.between(0.5f, 2);
    } else if (auto* const capsule = std::get_if<Capsule>(&to.shape)) {
        capsule->a = moved(random, capsule->a);
        capsule->b = moved(random, capsule->b);
    } else if (auto* const tapered = std::get_if<TaperedCapsule>(&to.shape)) {
        tapered->a = moved(random, tapered->a);
        if (random.chance(0.2)) tapered->radius_b *= random.between(0.5f, 2);
    } else if (auto* const box = std::get_if<Box>(&to.shape)) {
        box->center = moved(random, box->center);
        if (random.chance(0.5)) box->rotation = turned(random);
        if (random.chance(0.1)) box->half_extents.y *= random.between(0.5f, 2);
    } else if (auto* const placed = std::get_if<PlacedShape>(&to.shape)) {
        placed->position = moved(random, placed->position);
        if (random.chance(0.5)) placed->rotation = turned(random);
    } else {
        auto& plane = std::get<Plane>(to.shape);
        plane.offset += random.between(-0.5f, 0.5f);
        if (random.chance(0.2)) plane.normal = {-plane.normal.x, -plane.normal.y, -plane.normal.z};
    }
    if (random.chance(0.1)) {
        Fields fields(random, false);
        draw_surface(random, fields, to);
    }
    // The collider may have been extreme before its move.
    Drawn<Collider> drawn = finished(random, to, true);
    return drawn;
}

Executor backwards_executor() {
    return {.run =
                [](void*, std::uint32_t count, Executor::Body body, void* context) {
                    while (count-- > 0) body(context, count);
                },
            .user = nullptr,
            .width = 2};
}

Drawn<BodySettings> random_body(Random& random) {
    BodySettings settings;
    settings.mass = random.chance(0.2) ? 0 : random.of_any_size(random.chance(0.8) ? 1e-2f : 1e-6f, 1e3f);
    const auto inertia = [&] { return random.chance(0.2) ? 0 : random.of_any_size(1e-6f, 1e3f); };
    const float x = inertia(), y = inertia(), z = inertia();
    settings.inertia = {x, y, z};
    settings.gravity_scale = random.chance(0.8) ? 1 : random.between(-2, 2);
    if (random.chance(0.3)) settings.damping = random.of_any_size(1e-3f, 1e6f);
    if (random.chance(0.3)) settings.angular_damping = random.of_any_size(1e-3f, 1e6f);
    if (!random.chance(0.05)) return {settings};
    settings.mass = random.one_of({-1.0f, 1e-7f, 2e9f, std::numeric_limits<float>::quiet_NaN()});
    return {settings, Answer::refused};
}

BodyState random_body_state(Random& random) {
    const float fast = random.chance(0.8) ? 1.0f : 1e4f;
    const Vec3 position = random.point(random.chance(0.9) ? 1.0f : 1e5f), velocity = random.point(fast),
               spin = random.point(fast), axis = random.point(0.5f);
    const float w = std::sqrt(std::max(1 - axis.x * axis.x - axis.y * axis.y - axis.z * axis.z, 0.0f));
    return {position, {axis.x, axis.y, axis.z, w}, velocity, spin};
}

}  // namespace weft::fuzz
