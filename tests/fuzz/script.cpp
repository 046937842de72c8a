#include "tests/fuzz/script.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "tests/fuzz/random/random_settings.h"

namespace weft::fuzz {

namespace {

constexpr std::size_t operations = 50;
/// Particles times passes over them that a step may take: what a draw of settings may ask for.
constexpr std::uint64_t most_work = 400'000;

struct PlannedCloth {
    Mesh mesh;
    ClothSettings settings;
    bool removed = false;
    std::vector<std::uint32_t> pinned;
    bool may_have_maps = false;      ///< of mass or stiffness
    bool may_have_seams = false;     ///< which few methods have in their equation
    bool may_have_distance = false;  ///< of self-collision, which a mesh of more particles may refuse

    [[nodiscard]] std::uint64_t work() const {
        return removed ? 0 : mesh.positions.size() * passes_of(settings);
    }
};

struct PlannedCollider {
    Collider collider;
    bool removed = false;
};

struct PlannedShape {
    OwnedShape shape;
    bool removed = false;
};

void note_distance(PlannedCloth& cloth, const ClothSettings& settings) {
    cloth.may_have_distance |=
        settings.self_collision.method != SelfCollisionMethod::off && settings.self_collision.distance > 0;
}

/// Draws operation by operation, with what the earlier ones have left in mind.
class Author {
  public:
    explicit Author(std::uint64_t seed) : random_(seed) {
        script_.seed = seed;
        do {
            world_ = random_world_settings(random_, 4);
        } while (world_.answer == Answer::refused);
        script_.world = world_.value;
        is_apart_ = random_.chance(0.3);
    }

    Script write() {
        add_cloth();
        if (is_apart_ && random_.chance(0.6)) add_mistreated_cloth();
        while (script_.operations.size() < operations) {
            if (script_.mistreated && random_.chance(0.25))
                mistreat();
            else
                add_operation();
        }
        script_.cloths = cloths_.size();
        return std::move(script_);
    }

  private:
    void add_operation() {
        struct Choice {
            std::uint32_t weight;
            void (Author::*add)();
        };
        static constexpr Choice choices[] = {
            {36, &Author::step},
            {6, &Author::add_cloth},
            {1, &Author::measure_cloth},
            {2, &Author::remove_cloth},
            {5, &Author::recut},
            {9, &Author::pin},
            {12, &Author::move_pin},
            {4, &Author::unpin},
            {6, &Author::add_collider},
            {12, &Author::move_collider},
            {2, &Author::remove_collider},
            {3, &Author::add_body},
            {3, &Author::set_body},
            {1, &Author::remove_body},
            {3, &Author::attach_collider},
            {1, &Author::detach_collider},
            {3, &Author::attach},
            {1, &Author::detach},
            {4, &Author::set_enabled},
            {1, &Author::wake},
            {2, &Author::set_importance},
            {2, &Author::ask},
            {8, &Author::set_cloth_settings},
            {6, &Author::set_world_settings},
            {1, &Author::start_trace},
            {2, &Author::move_cloth},
            {2, &Author::reset_cloth},
            {6, &Author::set_frame},
            {6, &Author::set_map},
            {8, &Author::set_skin},
            {1, &Author::shift_origin},
            {4, &Author::move_pins},
            {4, &Author::add_shape},
            {5, &Author::add_instance},
            {5, &Author::deform_shape},
            {1, &Author::remove_shape},
            {4, &Author::save_or_restore},
            {3, &Author::stitch},
            {1, &Author::unstitch},
            {3, &Author::save_or_restore_cloth},
        };
        std::uint32_t all = 0;
        for (const Choice& choice : choices) all += choice.weight;
        std::uint32_t drawn = random_.below(all);
        for (const Choice& choice : choices) {
            if (drawn < choice.weight) return (this->*choice.add)();
            drawn -= choice.weight;
        }
    }

    void add_cloth() {
        if (cloths_.size() >= 6) return;
        Drawn<Mesh> mesh = random_mesh(random_);
        if (is_apart_) put_apart(mesh.value);
        const Drawn<ClothSettings> settings =
            random_cloth_settings(random_, passes_left(mesh.value.positions.size(), work()));
        const bool refused = mesh.answer == Answer::refused || settings.answer == Answer::refused;
        const bool accepted = mesh.answer == Answer::accepted && settings.answer == Answer::accepted;
        // A refused cloth keeps its number, and counts as removed.
        cloths_.push_back({mesh.value, settings.value, refused, {}});
        note_distance(cloths_.back(), settings.value);
        const bool cooked = random_.chance(0.4);
        const Vec3 place = cooked ? random_.point(0.3f) : Vec3{};
        const std::uint32_t damaged = cooked ? random_.below(1u << 31) : 0;
        add(AddCloth{std::move(mesh.value), settings.value, cooked, place, damaged},
            refused    ? Answer::refused
            : accepted ? Answer::accepted
                       : Answer::either,
            cloths_.size() - 1);
    }

    void add_mistreated_cloth() {
        Mesh mesh = make_sheet({.rows = 9, .columns = 9, .u = {0.4f, 0, 0}, .v = {0, 0, 0.4f}}).value();
        put_apart(mesh);
        ClothSettings settings;
        settings.self_collision.method =
            random_.one_of({SelfCollisionMethod::contact, SelfCollisionMethod::impact_zones});
        settings.self_collision.distance = random_.one_of({0.0f, 0.05f});
        script_.mistreated = cloths_.size();
        cloths_.push_back({mesh, settings, false, {}});
        note_distance(cloths_.back(), settings);
        add(AddCloth{std::move(mesh), settings}, Answer::accepted, *script_.mistreated);
    }

    /// Its pins bring it to one place, where no list has room for what is near, or far apart, or nowhere; it
    /// is let go; it is squeezed; its settings change.
    void mistreat() {
        const std::size_t chosen = *script_.mistreated;
        PlannedCloth& cloth = cloths_[chosen];
        const auto count = static_cast<std::uint32_t>(cloth.mesh.positions.size());
        const Vec3 place = cloth.mesh.positions.front();
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0u);
        const auto move_all = [&](const auto& target_of) {
            MovePins call{all, {}};
            for (const std::uint32_t v : all) call.targets.push_back(target_of(v));
            cloth.pinned = all;
            add(Pin{all}, Answer::accepted, chosen);
            add(std::move(call), Answer::either, chosen);
            step();
        };
        switch (random_.below(6)) {
            case 0:
                return move_all([&](std::uint32_t v) {
                    const auto way = [&](std::uint32_t k) { return 1e-4f * static_cast<float>(v * k % 97); };
                    return Vec3{place.x + way(5), place.y + way(7), place.z + way(11)};
                });
            case 1:
                return move_all([&](std::uint32_t v) {
                    const float farther = random_.of_any_size(0.01f, 100);
                    return Vec3{place.x, place.y + (v % 2 == 0 ? farther : -farther), place.z};
                });
            case 2: {
                MovePins nowhere{all, std::vector<Vec3>(count, place)};
                nowhere.targets[random_.below(count)].z = std::numeric_limits<float>::quiet_NaN();
                return add(std::move(nowhere), Answer::refused, chosen);
            }
            case 3:
                return squeeze(place);
            case 4: {
                const Drawn<ClothSettings> settings =
                    random_cloth_settings(random_, passes_left(count, work() - cloth.work()));
                if (settings.answer != Answer::refused) cloth.settings = settings.value;
                note_distance(cloth, settings.value);
                return add(SetClothSettings{settings.value},
                           settings.answer == Answer::refused ? Answer::refused : Answer::either, chosen);
            }
            default:
                cloth.pinned.clear();
                add(Unpin{all}, Answer::accepted, chosen);
                return step();
        }
    }

    /// Between two spheres that overlap by more than it is thick.
    void squeeze(const Vec3& place) {
        if (colliders_.size() > 10) return;
        for (const float side : {-1.0f, 1.0f}) {
            const Collider collider{.shape =
                                        Sphere{{place.x + 0.2f, place.y + 0.95f * side, place.z + 0.2f}, 1}};
            colliders_.push_back({collider, false});
            add(AddCollider{collider});
        }
        step();
    }

    void measure_cloth() {
        const Drawn<Mesh> mesh = random_mesh(random_);
        const Drawn<ClothSettings> settings = random_cloth_settings(random_, 100);
        const bool refused = mesh.answer == Answer::refused || settings.answer == Answer::refused;
        add(MeasureCloth{mesh.value, settings.value}, refused ? Answer::refused : Answer::either);
    }

    void remove_cloth() {
        const std::size_t cloth = any_of(cloths_);
        cloths_[cloth].removed = true;
        add(RemoveCloth{}, Answer::accepted, cloth);
    }

    /// Along edges at random: few, or most. In some draws what is told of where vertices come from is wrong.
    void recut() {
        const std::size_t chosen = any_of(cloths_);
        PlannedCloth& cloth = cloths_[chosen];
        std::vector<MeshEdge> edges;
        const double part = random_.chance(0.2) ? 0.0 : random_.chance(0.8) ? 0.1 : 0.8;
        for (const Triangle& t : cloth.mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                if (random_.chance(part)) edges.push_back({t[k], t[(k + 1) % 3]});
        auto cut = cut_mesh(cloth.mesh, edges);
        if (!cut) return;  // of a mesh that was refused, or edges of triangles that cooking leaves out
        const bool is_wrong = random_.chance(0.05);
        if (is_wrong)
            cut->from[random_.below(cut->from.size())] =
                static_cast<std::uint32_t>(cloth.mesh.positions.size());
        else
            cloth.mesh = cut->mesh;
        const Answer answer = is_wrong                  ? Answer::refused
                              : cloth.may_have_distance ? Answer::either
                                                        : Answer::accepted;
        add(Recut{*std::move(cut)}, answer, chosen);
    }

    void set_cloth_settings() {
        const std::size_t chosen = any_of(cloths_);
        PlannedCloth& cloth = cloths_[chosen];
        const Drawn<ClothSettings> settings =
            random_cloth_settings(random_, passes_left(cloth.mesh.positions.size(), work() - cloth.work()));
        const bool may_refuse =
            cloth.may_have_seams || (cloth.may_have_maps && settings.value.finite_elements.consistent_mass);
        if (settings.answer != Answer::refused && !may_refuse) cloth.settings = settings.value;
        note_distance(cloth, settings.value);
        add(SetClothSettings{settings.value},
            settings.answer == Answer::accepted && may_refuse ? Answer::either : settings.answer, chosen);
    }

    void pin() {
        const std::size_t chosen = any_of(cloths_);
        PlannedCloth& cloth = cloths_[chosen];
        if (random_.chance(0.05)) {
            const auto beyond =
                static_cast<std::uint32_t>(cloth.mesh.positions.size()) + random_.below(1u << 30);
            return add(Pin{{beyond}}, Answer::refused, chosen);
        }
        const std::vector<std::uint32_t> vertices = pattern_of_vertices(cloth.mesh);
        cloth.pinned.insert(cloth.pinned.end(), vertices.begin(), vertices.end());
        add(Pin{vertices}, Answer::accepted, chosen);
    }

    void move_pin() {
        const std::size_t chosen = any_of(cloths_);
        const PlannedCloth& cloth = cloths_[chosen];
        if (cloth.pinned.empty()) return pin();
        const std::uint32_t vertex = cloth.pinned[random_.below(cloth.pinned.size())];
        const Vec3 from = cloth.mesh.positions[vertex];
        if (random_.chance(0.05))
            return add(MovePin{vertex, {from.x, std::numeric_limits<float>::quiet_NaN(), 2e9f}},
                       Answer::refused, chosen);
        const float reach = random_.chance(0.8) ? 0.05f : random_.of_any_size(0.1f, 1e4f);
        const Vec3 by = random_.point(reach);
        // Refused if it is no longer pinned.
        add(MovePin{vertex, {from.x + by.x, from.y + by.y, from.z + by.z}}, Answer::either, chosen);
    }

    void unpin() {
        const std::size_t chosen = any_of(cloths_);
        PlannedCloth& cloth = cloths_[chosen];
        if (cloth.pinned.empty() || random_.chance(0.1))
            return add(Unpin{{random_.below(cloth.mesh.positions.size())}}, Answer::accepted, chosen);
        if (random_.chance(0.3)) {
            add(Unpin{std::move(cloth.pinned)}, Answer::accepted, chosen);
            cloth.pinned.clear();
            return;
        }
        const std::uint32_t which = random_.below(cloth.pinned.size());
        add(Unpin{{cloth.pinned[which]}}, Answer::accepted, chosen);
        cloth.pinned.erase(cloth.pinned.begin() + which);
    }

    void add_collider() {
        if (colliders_.size() >= 12) return;
        const Drawn<Collider> collider = random_collider(random_);
        colliders_.push_back({collider.value, collider.answer == Answer::refused});
        add(AddCollider{collider.value}, collider.answer);
    }

    void move_collider() {
        if (colliders_.empty()) return add_collider();
        const std::size_t chosen = any_of(colliders_);
        const bool is_instance = std::holds_alternative<PlacedShape>(colliders_[chosen].collider.shape);
        if (!is_instance && random_.chance(0.05)) {  // another kind of shape, mostly
            const Drawn<Collider> other = random_collider(random_);
            const bool same = other.value.shape.index() == colliders_[chosen].collider.shape.index();
            return add(MoveCollider{chosen, other.value}, same ? Answer::either : Answer::refused);
        }
        const Drawn<Collider> moved = random_move(random_, colliders_[chosen].collider);
        if (moved.answer != Answer::refused) colliders_[chosen].collider = moved.value;
        if (random_.chance(0.2)) return add(PlaceCollider{chosen, moved.value}, moved.answer);
        add(MoveCollider{chosen, moved.value}, moved.answer);
    }

    void remove_collider() {
        if (colliders_.empty()) return;
        const std::size_t chosen = any_of(colliders_);
        colliders_[chosen].removed = true;
        add(RemoveCollider{chosen});
    }

    void add_body() {
        if (is_apart_ || bodies_ >= 5) return;  // bodies can tie cloths together
        ++bodies_;
        const Drawn<BodySettings> settings = random_body(random_);
        add(AddBody{settings.value, random_body_state(random_)}, settings.answer);
    }

    void set_body() {
        if (bodies_ == 0) return add_body();
        const Drawn<BodySettings> settings = random_body(random_);
        add(SetBody{random_.below(bodies_), settings.value, random_body_state(random_)}, Answer::either);
    }

    void remove_body() {
        if (bodies_ > 0) add(RemoveBody{random_.below(bodies_)}, Answer::either);
    }

    void attach_collider() {
        if (bodies_ == 0 || colliders_.empty()) return add_body();
        add(AttachCollider{random_.below(bodies_), any_of(colliders_)}, Answer::either);
    }

    void detach_collider() {
        if (colliders_.empty()) return add_collider();
        add(DetachCollider{any_of(colliders_)}, Answer::either);
    }

    void attach() {
        if (bodies_ == 0) return add_body();
        const std::size_t chosen = any_of(cloths_);
        add(Attach{random_.below(bodies_), pattern_of_vertices(cloths_[chosen].mesh)}, Answer::either,
            chosen);
    }

    void detach() {
        const std::size_t chosen = any_of(cloths_);
        add(Detach{pattern_of_vertices(cloths_[chosen].mesh)}, Answer::either, chosen);
    }

    /// Threads that are short or long, weak or never break.
    void stitch() {
        if (is_apart_) return;  // seams tie cloths together
        const std::size_t a = any_of(cloths_), b = random_.chance(0.2) ? a : any_of(cloths_);
        Stitch call{b, pattern_of_vertices(cloths_[a].mesh), {}, {}};
        if (call.vertices.size() > 12) call.vertices.resize(12);
        for (std::size_t k = 0; k < call.vertices.size(); ++k)
            call.others.push_back(random_.below(cloths_[b].mesh.positions.size()));
        call.settings.rest_length = random_.chance(0.5) ? 0 : random_.of_any_size(1e-3f, 1);
        if (random_.chance(0.5)) call.settings.break_force = random_.of_any_size(1e-2f, 100);
        if (random_.chance(0.3)) call.settings.stiffness = random_.of_any_size(1, 1e4f);
        Answer answer = Answer::either;
        if (random_.chance(0.05)) {
            call.settings.stiffness = -1;
            answer = Answer::refused;
        } else {
            cloths_[a].may_have_seams = cloths_[b].may_have_seams = true;
        }
        ++seams_;
        add(std::move(call), answer, a);
    }

    void unstitch() {
        if (seams_ > 0) add(Unstitch{random_.below(seams_)}, Answer::either);
    }

    void set_enabled() { add(SetEnabled{random_.chance(0.6)}, Answer::accepted, any_of(cloths_)); }

    void wake() { add(Wake{}, Answer::accepted, any_of(cloths_)); }

    void set_importance() {
        const bool is_wrong = random_.chance(0.1);
        const float wrong = random_.one_of({-1.0f, std::numeric_limits<float>::quiet_NaN(), 1.1e6f});
        add(SetImportance{is_wrong ? wrong : random_.one_of({0.0f, 1e-3f, 1.0f, 1e6f})},
            is_wrong ? Answer::refused : Answer::accepted, any_of(cloths_));
    }

    void ask() { add(Ask{}, Answer::either, any_of(cloths_)); }

    void set_world_settings() {
        const std::uint64_t all = std::max<std::uint64_t>(work(), 1);
        const Drawn<WorldSettings> drawn =
            random_world_settings(random_, static_cast<int>(std::min<std::uint64_t>(most_work / all, 256)));
        if (drawn.answer != Answer::refused) world_ = drawn;
        add(SetWorldSettings{drawn.value}, drawn.answer);
    }

    void step() {
        const float infinity = std::numeric_limits<float>::infinity();
        const bool apart = random_.chance(0.2);
        if (random_.chance(0.05))
            return add(Step{random_.one_of({0.0f, -1.0f / 60, infinity, -infinity, 1.01f, 1e-38f,
                                            0.99f * least_step, std::numeric_limits<float>::quiet_NaN()}),
                            apart},
                       Answer::refused);
        const float dt = random_.chance(0.7) ? 1.0f / 60 : random_.of_any_size(least_step, greatest_step);
        for (std::uint32_t n = random_.chance(0.3) ? 1 + random_.below(6) : 1; n > 0; --n)
            add(Step{dt, apart});
        if (random_.chance(0.03)) add(MoveWorld{});
    }

    void start_trace() { add(StartTrace{random_.below(2000)}); }

    void move_cloth() {
        const Drawn<Transform> by = random_transform(random_);
        add(MoveCloth{by.value}, by.answer, any_of(cloths_));
    }

    void reset_cloth() {
        const std::size_t cloth = any_of(cloths_);
        ResetCloth call;
        const Vec3 by = random_.point(random_.chance(0.1) ? random_.of_any_size(1, 1e4f) : 1.0f);
        for (const Vec3& p : cloths_[cloth].mesh.positions)
            call.positions.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
        if (random_.chance(0.05)) call.positions.emplace_back();
        if (random_.chance(0.5)) {
            const Vec3 velocity = random_.point(random_.of_any_size(1e-3f, 1e4f));
            call.velocities.assign(call.positions.size(), velocity);
            for (const Vec3& p : call.positions)
                call.previous_positions.push_back(
                    {p.x - velocity.x / 60, p.y - velocity.y / 60, p.z - velocity.z / 60});
            if (random_.chance(0.05)) call.velocities.back().x = std::numeric_limits<float>::infinity();
        }
        add(std::move(call), Answer::either, cloth);
    }

    void set_frame() {
        const std::size_t cloth = any_of(cloths_);
        if (random_.chance(0.1)) return add(LeaveFrame{}, Answer::accepted, cloth);
        const Drawn<Transform> pose = random_transform(random_);
        add(SetFrame{pose.value}, pose.answer, cloth);
    }

    void set_map() {
        const std::size_t cloth = any_of(cloths_);
        const Drawn<Map> map = random_map(random_);
        std::vector<float> values;
        if (!random_.chance(0.15))
            for (std::size_t v = 0; v < cloths_[cloth].mesh.positions.size(); ++v)
                values.push_back(map_value(random_, map.value));
        Answer answer = map.answer;
        if (!values.empty() && random_.chance(0.05)) {
            values[random_.below(values.size())] = -20;
            answer = Answer::refused;
        }
        cloths_[cloth].may_have_maps |= map.value == Map::mass || map.value == Map::stiffness;
        add(SetMap{map.value, std::move(values)}, answer, cloth);
    }

    void set_skin() {
        const std::size_t cloth = any_of(cloths_);
        SetSkin call;
        const Vec3 by = random_.point(random_.chance(0.1) ? random_.of_any_size(1, 1e4f) : 0.1f);
        const Vec3 normal{by.z, 1, by.x};
        for (const Vec3& p : cloths_[cloth].mesh.positions) {
            call.places.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
            call.normals.push_back(normal);
        }
        add(std::move(call), Answer::either, cloth);
    }

    void shift_origin() {
        const Vec3 to = random_.point(random_.chance(0.5) ? 10 : 500);
        add(ShiftOrigin{to}, Answer::either);
    }

    void move_pins() {
        const std::size_t chosen = any_of(cloths_);
        const PlannedCloth& cloth = cloths_[chosen];
        if (cloth.pinned.empty()) return pin();
        MovePins call;
        const Vec3 by = random_.point(0.05f);
        for (const std::uint32_t vertex : cloth.pinned) {
            const Vec3& from = cloth.mesh.positions[vertex];
            call.vertices.push_back(vertex);
            call.targets.push_back({from.x + by.x, from.y + by.y, from.z + by.z});
        }
        Answer answer = Answer::either;
        if (random_.chance(0.05)) {
            call.targets.back().y = std::numeric_limits<float>::infinity();
            answer = Answer::refused;
        } else if (random_.chance(0.05)) {
            call.targets.pop_back();
            answer = Answer::refused;
        }
        add(std::move(call), answer, chosen);
    }

    void add_shape() {
        if (shapes_.size() >= 6) return;
        const Drawn<OwnedShape> drawn = random_shape(random_);
        shapes_.push_back({drawn.value, drawn.answer == Answer::refused});
        add(AddShape{drawn.value}, drawn.answer);
    }

    /// Refused if the shape is not there.
    void add_instance() {
        if (shapes_.empty()) return add_shape();
        if (colliders_.size() >= 12) return;
        const std::size_t shape = any_of(shapes_);
        const Drawn<Collider> collider = random_instance(random_, shape);
        colliders_.push_back({collider.value, collider.answer == Answer::refused});
        add(AddCollider{collider.value},
            collider.answer == Answer::refused ? Answer::refused : Answer::either);
    }

    void deform_shape() {
        if (shapes_.empty()) return add_shape();
        const std::size_t shape = any_of(shapes_);
        const Drawn<std::vector<Vec3>> drawn = random_deformation(random_, shapes_[shape].shape);
        const bool is_there = !shapes_[shape].removed;
        add(DeformShape{shape, drawn.value},
            drawn.answer == Answer::accepted && !is_there ? Answer::either : drawn.answer);
    }

    /// Refused if a collider is one of it.
    void remove_shape() {
        if (shapes_.empty()) return;
        const std::size_t shape = any_of(shapes_);
        add(RemoveShape{shape}, Answer::either);
    }

    void save_or_restore() {
        if (saves_ == 0 || random_.chance(0.4)) {
            ++saves_;
            return add(Save{});
        }
        const bool damaged = random_.chance(0.2);
        add(Restore{random_.below(saves_), damaged, static_cast<std::uint32_t>(random_.next())},
            damaged ? Answer::refused : Answer::either);
    }

    void save_or_restore_cloth() {
        if (cloth_saves_.empty() || random_.chance(0.4)) {
            cloth_saves_.push_back(any_of(cloths_));
            return add(SaveCloth{}, Answer::either, cloth_saves_.back());
        }
        const std::size_t save = random_.below(cloth_saves_.size());
        add(RestoreCloth{save}, Answer::either, cloth_saves_[save]);
    }

    void add(decltype(Operation::call) call, Answer answer = Answer::accepted,
             std::size_t cloth = Operation::no_cloth) {
        script_.operations.push_back({std::move(call), answer, cloth});
    }
    /// Passes that a cloth of so many particles may take in each substep of the World.
    [[nodiscard]] std::uint64_t passes_left(std::size_t particles, std::uint64_t others_work) const {
        const std::uint64_t per_substep = most_work / static_cast<std::uint64_t>(world_.value.substeps);
        const std::uint64_t left = per_substep > others_work ? per_substep - others_work : 0;
        return std::max<std::uint64_t>(left / std::max<std::size_t>(particles, 1), 9);
    }
    [[nodiscard]] std::uint64_t work() const {
        return std::accumulate(
            cloths_.begin(), cloths_.end(), std::uint64_t{0},
            [](std::uint64_t sum, const PlannedCloth& cloth) { return sum + cloth.work(); });
    }
    /// The index of an object that exists in most draws, and of a removed one in a few.
    template <class Planned>
    std::size_t any_of(const std::vector<Planned>& all) {
        std::size_t chosen = random_.below(all.size());
        for (int tries = 0; tries < 5 && all[chosen].removed; ++tries) chosen = random_.below(all.size());
        return chosen;
    }

    /// One, the corners, a row, two rows, a column, the border, a part at random, all.
    std::vector<std::uint32_t> pattern_of_vertices(const Mesh& mesh) {
        const auto count = static_cast<std::uint32_t>(mesh.positions.size());
        const std::uint32_t columns = std::clamp(mesh.columns, 1u, count), rows = count / columns;
        const auto choose = [&](const auto& is_chosen) {
            std::vector<std::uint32_t> chosen;
            for (std::uint32_t v = 0; v < count; ++v)
                if (is_chosen(v / columns, v % columns)) chosen.push_back(v);
            return chosen;
        };
        const std::uint32_t last_row = rows - 1, last_column = columns - 1;
        const double part = random_.unit();
        switch (random_.below(9)) {
            case 0:
                return choose([&](auto row, auto column) {
                    return (row == 0 || row == last_row) && (column == 0 || column == last_column);
                });
            case 1:
                return choose([&](auto row, auto) { return row == 0; });
            case 2:
                return choose([&](auto row, auto) { return row == 0 || row == last_row; });
            case 3:
                return choose([&](auto, auto column) { return column == 0; });
            case 4:
                return choose([&](auto row, auto column) {
                    return row == 0 || row == last_row || column == 0 || column == last_column;
                });
            case 5:
                return choose([&](auto row, auto column) { return row == column; });
            case 6:
                return choose([&](auto, auto) { return random_.chance(part); });
            case 7:
                return choose([](auto, auto) { return true; });
            default:
                return {random_.below(count)};
        }
    }

    /// Far from the others, so that it must not matter to them, whatever it is given. Without precision to
    /// lose: a mesh that is far out stays there.
    void put_apart(Mesh& mesh) const {
        constexpr float apart = 500, farthest = 1000;  // [m]
        for (const Vec3& p : mesh.positions)
            if (!(std::abs(p.x) < farthest)) return;
        for (Vec3& p : mesh.positions) p.x += apart * static_cast<float>(cloths_.size());
    }

    Random random_;
    Script script_;
    bool is_apart_ = false;  ///< cloths are far from each other, and there are no bodies
    Drawn<WorldSettings> world_;
    std::vector<PlannedCloth> cloths_;
    std::vector<PlannedCollider> colliders_;
    std::size_t bodies_ = 0;
    std::vector<PlannedShape> shapes_;
    std::size_t saves_ = 0;
    std::size_t seams_ = 0;
    std::vector<std::size_t> cloth_saves_;  ///< of which cloth each is
};

}  // namespace

Script random_script(std::uint64_t seed) {
    return Author(seed).write();
}

}  // namespace weft::fuzz
