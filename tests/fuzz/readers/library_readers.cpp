// The library's readers of files.

#include <cstddef>
#include <cstring>
#include <memory>
#include <utility>

#include "cloth/store/save_format.h"
#include "engine/state_hash.h"
#include "tests/cooked_seal.h"
#include "tests/fuzz/readers/mutation.h"
#include "tests/fuzz/readers/reader.h"
#include "tests/fuzz/recording.h"

namespace weft::fuzz {

namespace {

using Bytes = std::vector<std::byte>;

void check_world(const World& world, std::span<const ClothId> cloths) {
    for (const ClothId id : cloths) {
        const auto view = world.cloth(id);
        if (!view) continue;
        check_finite(view->positions, "a position");
        check_finite(view->velocities, "a velocity");
        check_finite(view->normals, "a normal");
    }
}

/// As hosts have it: two cloths that meet each other and themselves, ground, an instance of a shape, a body.
struct FullWorld {
    World world = World::create({.threads = 1}).value();
    std::vector<ClothId> cloths;

    explicit FullWorld(Bytes* recorded = nullptr) {
        if (recorded != nullptr)
            must(world.start_recording(sink_to(*recorded)).ok(), "a World cannot be recorded");
        const auto sheet = make_sheet({.rows = 7, .columns = 6});
        ClothSettings settings;
        settings.self_collision.method = SelfCollisionMethod::contact;
        for (const float height : {0.3f, 0.4f}) {
            Mesh mesh = *sheet;
            for (Vec3& p : mesh.positions) p.y += height;
            settings.key = cloths.size() + 1;
            cloths.push_back(world.add_cloth(mesh, settings).value());
        }
        must(world.pin(cloths[0], 0).ok(), "a vertex cannot be pinned");
        must(world.add_collider({.shape = Plane{}}).ok(), "ground cannot be added");
        const Mesh closed = tube(6, 3);
        const auto shape = world.add_shape(
            TriangleMesh{.vertices = closed.positions, .triangles = closed.triangles, .closed = false});
        must(shape.ok(), "a shape cannot be added");
        must(world.add_collider({.shape = PlacedShape{.shape = *shape}}).ok(), "a shape cannot be placed");
        const auto body = world.add_body({.mass = 1}, {.position = {0.5f, 0.6f, 0.5f}});
        const auto ball = world.add_collider({.shape = Sphere{{}, 0.05f}});
        must(body.ok() && ball.ok() && world.attach_collider(*body, *ball).ok(), "a body cannot be added");
        must(world.attach(*body, cloths[1], std::vector<std::uint32_t>{0}).ok(),
             "a vertex cannot be attached");
        step(6);
    }
    void step(int count) {
        for (int k = 0; k < count; ++k) world.step(1.0f / 60);
    }
};

void spoil_words(Random& random, std::span<std::byte> bytes) {
    for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits) {
        if (random.chance(0.3))
            bytes[random.below(bytes.size())] ^= std::byte(1u << random.below(8));
        else
            spoil_word(random, bytes);
    }
}

bool read_obj(Random& random, const std::filesystem::path& folder) {
    static const std::string text =
        "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 1 0\nv 1 1 0 0 1 0\nv 0 1 0.5 0 0 1\nv 0 2 0 1 1 1\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl aFree\nf 1/1/1 2/2/1 3/3/1\nf 1//1 3//1 4//1\n"
        "f -2 -1 -3\nf 1 2 3 4 5\nv 0.5 0.9 0\nv 0.4 0.5 0\nv 0.6 0.5 0\nf 1 2 3 6 4\nf 1 3 2 4\n"
        "f 1 2 3 4 1 7 6 8 7\nf 3 6 8 6 7 2 2 5 1 4 8\n# end\n";
    const auto file = folder / "damaged.obj";
    write_file(file, mutated_text(random, text));
    ObjReport report;
    const auto mesh = load_obj(file, {.texcoords_are_pattern = random.chance(0.3)}, &report);
    if (!mesh) check_error(mesh.error(), "damaged.obj");
    if (mesh) check_mesh(*mesh, "the mesh");
    return mesh.ok();
}

bool read_cooked(Random& random, const std::filesystem::path&) {
    static const Bytes saved = [] {
        ClothSettings settings;
        settings.self_collision.method = SelfCollisionMethod::contact;
        const CookedCloth cooked = CookedCloth::create(tube(8, 6), settings).value();
        Bytes bytes(cooked.save_size());
        must(cooked.save(bytes).ok(), "a cooked cloth cannot be saved");
        return bytes;
    }();
    Bytes bytes = saved;
    if (random.chance(0.1)) bytes.resize(random.below(bytes.size()));
    if (bytes.size() > test::cooked_head) {
        spoil_words(random, std::span(bytes).subspan(random.chance(0.2) ? 0 : test::cooked_head));
        if (random.chance(0.95)) test::seal_cooked(bytes);
    }
    ClothSettings settings;
    settings.self_collision.method = SelfCollisionMethod::contact;
    const auto cooked = CookedCloth::load(bytes, settings);
    if (!cooked) {
        must(!cooked.error().message.empty(), "a refusal without a word");
        return false;
    }
    World world = World::create({.threads = 1}).value();
    const auto cloth = world.add_cloth(*cooked);
    if (!cloth) return false;
    for (int k = 0; k < 2; ++k) world.step(1.0f / 60);
    check_world(world, std::span(&*cloth, 1));
    return true;
}

void seal_save(Bytes& bytes) {
    SaveHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    StateHash hash;
    hash.add(std::span<const std::byte>(bytes).subspan(sizeof head));
    head.hash = hash.value();
    std::memcpy(bytes.data(), &head, sizeof head);
}

/// The cloths of a save that the World as a whole refuses.
bool restores_by_key(World& world, std::span<const std::byte> bytes) {
    const std::uint64_t before = world.state_hash();
    const auto restored = world.restore_cloths(bytes);
    must(restored.ok() || world.state_hash() == before, "cloths were refused, and the World has changed");
    if (restored) world.step(1.0f / 60);
    return restored.ok() && *restored > 0;
}

bool read_cloth_save(Random& random, const std::filesystem::path&) {
    static const std::unique_ptr<FullWorld> full = std::make_unique<FullWorld>();
    World& world = full->world;
    const ClothId cloth = full->cloths[random.below(full->cloths.size())];
    Bytes saved(world.cloth_save_size(cloth));
    must(world.save_cloth(cloth, saved).ok(), "a cloth cannot be saved");
    Bytes bytes = saved;
    spoil_words(random, std::span(bytes).subspan(random.chance(0.1) ? 0 : sizeof(SaveHead)));
    if (random.chance(0.95)) seal_save(bytes);
    const std::uint64_t before = world.state_hash();
    const auto restored = world.restore_cloth(cloth, bytes);
    must(restored.ok() || world.state_hash() == before, "a cloth was refused, and the World has changed");
    if (!restored) return false;
    full->step(2);
    check_world(world, full->cloths);
    must(world.restore_cloth(cloth, saved).ok(), "after a damaged save the whole one is refused");
    return true;
}

bool read_save(Random& random, const std::filesystem::path&) {
    static const std::unique_ptr<FullWorld> full = std::make_unique<FullWorld>();
    static const Bytes saved = [] {
        Bytes bytes(full->world.save_size());
        must(full->world.save(bytes).ok(), "a World cannot be saved");
        return bytes;
    }();
    Bytes bytes = saved;
    if (random.chance(0.05)) bytes.resize(random.below(bytes.size()));
    if (bytes.size() > sizeof(SaveHead)) {
        spoil_words(random, std::span(bytes).subspan(random.chance(0.1) ? 0 : sizeof(SaveHead)));
        if (random.chance(0.95)) seal_save(bytes);
    }
    World& world = full->world;
    const std::uint64_t before = world.state_hash();
    const auto restored = world.restore(bytes);
    if (!restored) {
        must(!restored.error().message.empty(), "a refusal without a word");
        must(world.state_hash() == before,
             "a save was refused (" + restored.error().message + ") and changed the World");
        return restores_by_key(world, bytes);
    }
    full->step(2);
    check_world(world, full->cloths);
    must(world.restore(saved).ok(), "after a damaged save the whole one is refused");
    return true;
}

bool read_recording(Random& random, const std::filesystem::path&) {
    static const Bytes recorded = [] {
        Bytes bytes;
        FullWorld full(&bytes);
        must(full.world.stop_recording().ok(), "a recording cannot be ended");
        return bytes;
    }();
    static const std::vector<std::size_t> records = harmless_records(recorded);
    Bytes bytes = recorded;
    if (random.chance(0.1)) {
        const std::string damaged =
            mutated_bytes(random, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        const auto raw = std::as_bytes(std::span(damaged));
        bytes.assign(raw.begin(), raw.end());
    } else {
        const std::size_t record = records[random.below(records.size())];
        RecordHead head;
        std::memcpy(&head, bytes.data() + record, sizeof head);
        spoil_words(random, std::span(bytes).subspan(record + sizeof head, head.bytes));
        seal(bytes, record);
    }
    const auto replayed = replay(bytes, {.threads = 1});
    must(replayed.ok() || !replayed.error().message.empty(), "a refusal without a word");
    return replayed.ok();
}

}  // namespace

std::vector<Reader> library_readers() {
    return {{"obj", read_obj},
            {"cooked", read_cooked},
            {"save", read_save},
            {"cloth_save", read_cloth_save},
            {"recording", read_recording}};
}

}  // namespace weft::fuzz
