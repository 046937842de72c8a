// What a host gives in place of the process's own memory, log and profiler.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>
#include <vector>

#include "engine/platform.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::hooked {
namespace {

/// A host that counts and keeps what it is told, while it lives.
struct Host {
    explicit Host(bool with_memory = true) {
        Hooks hooks;
        hooks.user = this;
        if (with_memory) {
            hooks.allocate = [](void* user, std::size_t bytes, std::size_t alignment) {
                return static_cast<Host*>(user)->allocate(bytes, alignment);
            };
            hooks.release = [](void* user, void* memory, std::size_t bytes, std::size_t alignment) {
                static_cast<Host*>(user)->release(memory, bytes, alignment);
            };
        }
        hooks.log = [](void* user, LogLevel level, const char* line) {
            static_cast<Host*>(user)->lines.push_back((level == LogLevel::warning ? "! " : "") +
                                                      std::string(line));
        };
        hooks.begin_zone = [](void* user, const char* name) { static_cast<Host*>(user)->zone(name); };
        hooks.end_zone = [](void* user, const char* name) {
            static_cast<Host*>(user)->zone(("/" + std::string(name)).c_str());
        };
        EXPECT_TRUE(set_hooks(hooks));
    }
    ~Host() {
        EXPECT_EQ(bytes, 0);
        EXPECT_EQ(blocks, 0);
        EXPECT_TRUE(set_hooks({}));
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    void* allocate(std::size_t count, std::size_t alignment) {
        EXPECT_EQ(alignment, 64u);
        EXPECT_EQ(count % 16, 0u);
        if (left-- == 0) return nullptr;
        bytes += static_cast<std::int64_t>(count);
        ++blocks;
        ++calls;
        return std::aligned_alloc(alignment, (count + 63) / 64 * 64);
    }
    void release(void* memory, std::size_t count, std::size_t alignment) {
        EXPECT_EQ(alignment, 64u);
        bytes -= static_cast<std::int64_t>(count);
        --blocks;
        std::free(memory);
    }
    void zone(const char* name) {
#ifndef WEFT_WITHOUT_THREADS
        const std::lock_guard lock(mutex);
#endif
        zones.emplace_back(name);
    }

    std::atomic<std::int64_t> bytes = 0, blocks = 0, calls = 0;
    std::atomic<std::int64_t> left = -1;  ///< allocations until one fails
    std::vector<std::string> lines, zones;
#ifndef WEFT_WITHOUT_THREADS
    std::mutex mutex;
#endif
};

World serial_world() {
    WorldSettings settings;
    settings.threads = 1;
    return World::create(settings).value();
}

Mesh small_sheet() {
    return make_sheet({.rows = 20, .columns = 20, .origin = {0, 1, 0}}).value();
}

TEST(Hooks, BuffersAreTheHostsAndAreCounted) {
    Host host;
    {
        World world = serial_world();
        const ClothId cloth = world.add_cloth(small_sheet()).value();
        EXPECT_EQ(memory_in_use().bytes, static_cast<std::uint64_t>(host.bytes));
        EXPECT_EQ(memory_in_use().blocks, static_cast<std::uint64_t>(host.blocks));
        const auto said = static_cast<double>(world.cloth_info(cloth)->bytes);
        EXPECT_GT(static_cast<double>(host.bytes), 0.9 * said) << "of all that a cloth says it has";
        ASSERT_TRUE(
            world.add_cloth(small_sheet(), {.self_collision = {.method = SelfCollisionMethod::contact}}));
        const std::int64_t calls = host.calls;
        for (int k = 0; k < 5; ++k) world.step(h);
        EXPECT_EQ(host.calls, calls) << "a step takes none";
        EXPECT_FALSE(set_hooks({})) << "its memory would go back to somebody else";
        ASSERT_TRUE(world.remove_cloth(cloth));
    }
    EXPECT_EQ(host.bytes, 0);
}

#ifdef __cpp_exceptions
TEST(Hooks, AnyAllocationMayFailAndNothingHasChanged) {
    Host host;
    World world = serial_world();
    ASSERT_TRUE(world.add_cloth(small_sheet()));
    const std::int64_t bytes = host.bytes;
    const std::uint64_t hash = world.state_hash();
    const Mesh mesh = small_sheet();
    std::int64_t failures = 0;
    for (std::int64_t allowed = 0;; allowed += 1 + allowed / 8) {
        host.left = allowed;
        const auto added =
            world.add_cloth(mesh, {.self_collision = {.method = SelfCollisionMethod::contact}});
        const bool ran_out = host.left < 0;
        host.left = -1;
        if (!ran_out) break;
        ++failures;
        ASSERT_FALSE(added) << allowed;
        EXPECT_EQ(added.error().code, ErrorCode::out_of_memory);
        ASSERT_EQ(host.bytes, bytes) << allowed;
        ASSERT_EQ(world.state_hash(), hash) << allowed;
    }
    EXPECT_GT(failures, 10);
}
#endif

TEST(Hooks, ThePairsAreWholeOrRefused) {
    const Host host;  // stays what it was, each time
    Hooks hooks;
    hooks.allocate = [](void*, std::size_t, std::size_t) -> void* { return nullptr; };
    EXPECT_FALSE(set_hooks(hooks));
    hooks = {};
    hooks.end_zone = [](void*, const char*) {};
    const auto answer = set_hooks(hooks);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("begin_zone"), std::string::npos);
    ASSERT_TRUE(World::create().value().add_cloth(small_sheet()));
    EXPECT_GT(host.calls, 0);
}

TEST(Hooks, ZonesLieWithinEachOtherAndAreTheStages) {
    Host host(false);
    World world = serial_world();
    ASSERT_TRUE(world.add_cloth(small_sheet()));
    world.step(h);
    std::vector<std::string> open;
    for (const std::string& name : host.zones) {
        if (name[0] != '/') {
            open.push_back(name);
            continue;
        }
        ASSERT_FALSE(open.empty());
        EXPECT_EQ("/" + open.back(), name);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
    ASSERT_GT(host.zones.size(), 8u);
    EXPECT_EQ(host.zones.front(), "step");
    EXPECT_EQ(host.zones.back(), "/step");
    for (const StageTime& stage : world.profile()) {
        if (stage.last == 0) continue;
        EXPECT_NE(std::ranges::find(host.zones, stage.name), host.zones.end()) << stage.name;
    }
}

TEST(Hooks, TheLogSaysWhatRaisedAFlagOnce) {
    Host host;
    WorldSettings settings;
    settings.max_speed = 0.5f;
    World world = World::create(settings).value();
    ASSERT_TRUE(world.pin(world.add_cloth(small_sheet()).value(), 0));
    ASSERT_TRUE(world.add_cloth(small_sheet()));
    for (int k = 0; k < 20; ++k) world.step(h);
    ASSERT_TRUE(has(world.report().flags, StepFlags::speed_limited));
    std::size_t count = 0;
    for (const std::string& line : host.lines) {
        if (line.find("speed_limited") == std::string::npos) continue;
        ++count;
        EXPECT_EQ(line.find("! step "), 0u) << line;
        EXPECT_NE(line.find("cloth "), std::string::npos) << line;
    }
    EXPECT_EQ(count, 1u) << "not in each step";
}

TEST(Hooks, TheLogSaysWhatWasDoneToAMesh) {
    Host host;
    Mesh mesh = small_sheet();
    mesh.rows = mesh.columns = 0;
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.positions.push_back(mesh.positions[0]);
    mesh.texcoords.clear();
    World world = serial_world();
    ASSERT_TRUE(world.add_cloth(mesh));
    EXPECT_EQ(host.lines, (std::vector<std::string>{"mesh: 1 vertices were welded",
                                                    "! mesh: 1 triangles were left out"}));
    host.lines.clear();
    ASSERT_TRUE(CookedCloth::create(mesh));
    EXPECT_EQ(host.lines.size(), 2u);
    host.lines.clear();
    ASSERT_TRUE(world.add_cloth(small_sheet()));
    EXPECT_TRUE(host.lines.empty()) << "nothing to say of a whole mesh";
}

TEST(Hooks, TheLogAsksForMetresWhereAMeshMayBeInMillimetres) {
    Host host(false);
    World world = serial_world();
    for (const float scale : {1.0f, 1000.0f}) {
        host.lines.clear();
        Mesh mesh = small_sheet();
        for (Vec3& x : mesh.positions) x = {scale * x.x, scale * x.y, scale * x.z};
        ASSERT_TRUE(world.add_cloth(mesh));
        const auto asks = std::ranges::count_if(host.lines, [](const std::string& line) {
            return line.find("millimetres") != std::string::npos;
        });
        EXPECT_EQ(asks, scale > 1 ? 1 : 0);
    }
    Mesh far = small_sheet();
    far.positions[0].x = 2e5f;
    EXPECT_NE(world.add_cloth(far).error().message.find("not in millimetres"), std::string::npos);
}

TEST(Hooks, TheLogSaysThatAClothLiesOnAnother) {
    Host host(false);
    World world = serial_world();
    ClothSettings settings;
    settings.self_collision.method = SelfCollisionMethod::contact;
    const ClothId first = world.add_cloth(small_sheet(), settings).value();
    ASSERT_TRUE(world.add_cloth(small_sheet()));
    EXPECT_TRUE(host.lines.empty()) << "cloth without contact may lie anywhere";
    const ClothId second = world.add_cloth(small_sheet(), settings).value();
    ASSERT_EQ(host.lines.size(), 1u);
    EXPECT_NE(host.lines[0].find("lie exactly on those of cloth"), std::string::npos) << host.lines[0];
    for (int k = 0; k < 60; ++k) world.step(h);
    const ClothView a = *world.cloth(first), b = *world.cloth(second);
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        EXPECT_GT((xyz(a.positions[i]) - xyz(b.positions[i])).norm(), 1e-3f) << "they part";
}

}  // namespace
}  // namespace weft::test::hooked
