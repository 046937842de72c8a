#pragma once
// A script: calls of a World, drawn from a seed before any of them is made, so that the same calls can be
// made again with other threads or without one of the cloths.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/fuzz/random/random.h"
#include "tests/fuzz/random/random_settings.h"

namespace weft::fuzz {

struct AddCloth {
    Mesh mesh;
    ClothSettings settings;
    bool cooked = false;       ///< apart, and by way of its bytes
    Vec3 place{};              ///< where, if it is cooked
    std::uint32_t damage = 0;  ///< by which its bytes are damaged
};
struct MeasureCloth {
    Mesh mesh;
    ClothSettings settings;
};
struct RemoveCloth {};
struct Recut {
    MeshCut cut;  ///< of the mesh that it has
};
struct SetEnabled {
    bool on;
};
struct Wake {};
struct SetImportance {
    float importance;
};
struct SetClothSettings {
    ClothSettings settings;
};
struct Pin {
    std::vector<std::uint32_t> vertices;
};
struct MovePin {
    std::uint32_t vertex;
    Vec3 target;
};
struct MovePins {
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3> targets;
};
struct Unpin {
    std::vector<std::uint32_t> vertices;
};
struct AddCollider {
    Collider collider;
};
struct MoveCollider {
    std::size_t collider;  ///< its place among all that were added
    Collider target;
};
struct PlaceCollider {
    std::size_t collider;
    Collider place;
};
struct RemoveCollider {
    std::size_t collider;
};
struct AddBody {
    BodySettings settings;
    BodyState state;
};
struct SetBody {
    std::size_t body;  ///< its place among all that were added
    BodySettings settings;
    BodyState state;
};
struct RemoveBody {
    std::size_t body;
};
struct AttachCollider {
    std::size_t body, collider;
};
struct DetachCollider {
    std::size_t collider;
};
struct Attach {
    std::size_t body;
    std::vector<std::uint32_t> vertices;
};
struct Detach {
    std::vector<std::uint32_t> vertices;
};
/// Sews vertices to those of another cloth, or of the same.
struct Stitch {
    std::size_t other;  ///< its place among all cloths that were added
    std::vector<std::uint32_t> vertices, others;
    SeamSettings settings;
};
struct Unstitch {
    std::size_t seam;  ///< its place among all that were sewn
};
struct SetWorldSettings {
    WorldSettings settings;
};
struct Step {
    float dt;
    bool apart = false;  ///< by begin_step(), work() and end_step()
};
/// All that a host can ask without changing anything.
struct Ask {};
struct StartTrace {
    std::size_t max_events;
};
struct MoveWorld {};
struct MoveCloth {
    Transform by;
};
struct ResetCloth {
    std::vector<Vec3> positions;
    std::vector<Vec3> previous_positions, velocities;  ///< for resume_cloth(); empty: reset_cloth()
};
struct SetFrame {
    Transform pose;
};
struct LeaveFrame {};
struct SetMap {
    Map map;
    std::vector<float> values;
};
/// The mesh as it was given, moved.
struct SetSkin {
    std::vector<Vec3> places, normals;
};
struct ShiftOrigin {
    Vec3 to;
};
struct AddShape {
    OwnedShape shape;
};
struct DeformShape {
    std::size_t shape;  ///< its place among all that were added
    std::vector<Vec3> vertices;
};
struct RemoveShape {
    std::size_t shape;
};
struct Save {};
struct Restore {
    std::size_t save;  ///< its place among all of them
    bool damaged;
    std::uint32_t where;  ///< the byte, but for whole saves
};
struct SaveCloth {};
struct RestoreCloth {
    std::size_t save;  ///< its place among all saves of cloths
};

struct Operation {
    static constexpr std::size_t no_cloth = ~std::size_t{0};

    std::variant<AddCloth, MeasureCloth, RemoveCloth, SetClothSettings, Pin, MovePin, Unpin, AddCollider,
                 MoveCollider, PlaceCollider, RemoveCollider, AddBody, SetBody, RemoveBody, AttachCollider,
                 Attach, Detach, SetWorldSettings, Step, StartTrace, MoveWorld, MoveCloth, ResetCloth,
                 SetFrame, LeaveFrame, SetMap, SetSkin, ShiftOrigin, MovePins, AddShape, DeformShape,
                 RemoveShape, Save, Restore, Recut, SetEnabled, Wake, SetImportance, DetachCollider, Ask,
                 Stitch, Unstitch, SaveCloth, RestoreCloth>
        call;
    Answer answer = Answer::accepted;  ///< as far as the call's own values go: an id may be stale, too
    std::size_t cloth = no_cloth;      ///< its place among all that were added
};

struct Script {
    std::uint64_t seed = 0;
    WorldSettings world;
    std::vector<Operation> operations;
    std::size_t cloths = 0;  ///< added in the course of it
    /// A cloth far from the others that is crushed, torn and given bad values: no other may feel it.
    std::optional<std::size_t> mistreated = {};
};

[[nodiscard]] Script random_script(std::uint64_t seed);

/// For people: a line for each operation.
[[nodiscard]] std::string text_of(const Operation& operation);
[[nodiscard]] std::string text_of(const Script& script);

}  // namespace weft::fuzz
