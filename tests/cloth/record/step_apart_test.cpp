// A step in three, as a host uses it: begun, worked on by another thread while the last one is drawn, and
// ended.

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <thread>

#include "engine/platform.h"
#include "tests/cloth/record/recordings.h"

namespace weft::test {
namespace {

World make_world(int threads) {
    WorldSettings settings;
    settings.threads = threads;
    settings.wind = {.velocity = {1, 0, 3}, .gust = 0.5f};
    settings.contact_reports = 16;
    return World::create(settings).value();
}

/// Two sheets in contact that fall on a ball, by two corners; a third in a frame.
struct Game {
    explicit Game(int threads) : world(make_world(threads)) {
        ClothSettings meets;
        meets.self_collision = {.method = SelfCollisionMethod::contact};
        meets.substeps = 2;
        ClothSettings carried;
        carried.frame_inertia = {.linear = 0.5f, .angular = 0.5f};
        cloths = {world.add_cloth(small_sheet(0.5f), meets).value(),
                  world.add_cloth(small_sheet(0.55f), meets).value(),
                  world.add_cloth(small_sheet(2), carried).value()};
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 8}));
        EXPECT_TRUE(world.pin(cloths[2], std::vector<std::uint32_t>{0, 8}));
        EXPECT_TRUE(world.set_frame(cloths[2], {}));
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0.3f, 0}, 0.15f}}));
        EXPECT_TRUE(world.add_body({}, {.position = {5, 0, 0}}));
    }
    void before_step(int k) {
        EXPECT_TRUE(world.set_frame(cloths[2], {.translation = {0.02f * static_cast<float>(k), 0, 0}}));
        EXPECT_TRUE(world.move_pin(cloths[0], 0, {-0.3f, 0.5f - 0.004f * static_cast<float>(k), -0.3f}));
    }
    World world;
    std::vector<ClothId> cloths;
};

std::vector<Vec4> all_of(const ClothView& view) {
    std::vector<Vec4> all;
    for (const auto& buffer : {view.positions, view.previous_positions, view.velocities, view.normals})
        all.insert(all.end(), buffer.begin(), buffer.end());
    all.push_back({view.bounds.lower.x, view.bounds.lower.y, view.bounds.lower.z, 0});
    all.push_back({view.bounds.upper.x, view.bounds.upper.y, view.bounds.upper.z, 0});
    return all;
}
bool are_same(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4)) == 0;
}

TEST(StepApart, HasTheBytesOfAWholeStep) {
    for (const int threads : {1, 2}) {
        Game whole(1), apart(threads);
        for (int k = 0; k < 40; ++k) {
            whole.before_step(k);
            apart.before_step(k);
            const StepReport& report = whole.world.step(h);
            ASSERT_TRUE(apart.world.begin_step(h));
            if (k % 3 != 0) {
                const auto work = [&] { return apart.world.work().ok(); };
#ifdef WEFT_WITHOUT_THREADS
                EXPECT_TRUE(work());
#else
                EXPECT_TRUE(std::async(std::launch::async, work).get());
#endif
            }
            ASSERT_TRUE(apart.world.end_step());
            ASSERT_EQ(whole.world.state_hash(), apart.world.state_hash()) << "step " << k;
            EXPECT_EQ(report.step, apart.world.report().step);
            EXPECT_EQ(report.flags, apart.world.report().flags);
            EXPECT_EQ(report.self_contacts, apart.world.report().self_contacts);
            EXPECT_EQ(whole.world.contacts().size(), apart.world.contacts().size());
        }
        EXPECT_GT(whole.world.report().self_contacts + whole.world.report().collider_contacts, 0u);
    }
}

#ifndef WEFT_WITHOUT_THREADS
// The thread sanitizer sees what is read of what is written.
TEST(StepApart, ShowsTheLastStepWhileTheNextIsWorkedOn) {
    Game game(2);
    for (int k = 0; k < 30; ++k) {
        game.before_step(k);
        std::vector<std::vector<Vec4>> before;
        for (const ClothId id : game.cloths) before.push_back(all_of(*game.world.cloth(id)));
        const std::uint64_t step = game.world.report().step;
        ASSERT_TRUE(game.world.begin_step(h));
        std::atomic<bool> done = false;
        std::thread task([&] {
            EXPECT_TRUE(game.world.work());
            done = true;
        });
        do {
            for (std::size_t i = 0; i < game.cloths.size(); ++i)
                EXPECT_TRUE(are_same(all_of(*game.world.cloth(game.cloths[i])), before[i])) << i;
            EXPECT_EQ(game.world.report().step, step);
            EXPECT_TRUE(game.world.cloth_settings(game.cloths[0]));
            EXPECT_EQ(game.world.settings().contact_reports, 16);
        } while (!done);
        task.join();
        EXPECT_TRUE(are_same(all_of(*game.world.cloth(game.cloths[0])), before[0])) << "not before it ends";
        ASSERT_TRUE(game.world.end_step());
        EXPECT_FALSE(are_same(all_of(*game.world.cloth(game.cloths[0])), before[0]));
        EXPECT_EQ(game.world.report().step, step + 1);
    }
}
#endif

void expect_refused(const Result<void>& answer, const std::string& name) {
    ASSERT_FALSE(answer) << name;
    EXPECT_EQ(answer.error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(answer.error().message.substr(0, name.size() + 1), name + ":") << answer.error().message;
    EXPECT_NE(answer.error().message.find("end_step"), std::string::npos) << answer.error().message;
}
template <class T>
Result<void> answer_of(const Result<T>& result) {
    return result ? Result<void>() : Result<void>(result.error());
}

TEST(StepApart, RefusesByNameWhatWouldChangeIt) {
    Game game(1);
    World& world = game.world;
    const ClothId cloth = game.cloths[0];
    const ColliderId collider = world.add_collider({.shape = Sphere{}}).value();
    const BodyId body = world.add_body({}).value();
    const ShapeId shape =
        world.add_shape(ConvexHull{std::array<Vec3, 4>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}})
            .value();
    const CookedCloth cooked = CookedCloth::create(small_sheet(3)).value();
    Bytes saved(world.save_size()), recorded;
    ASSERT_TRUE(world.save(saved));
    world.step(h);
    const std::uint64_t before = world.state_hash();
    ASSERT_TRUE(world.begin_step(h));

    const std::vector<std::uint32_t> none;
    const std::pair<const char*, std::function<Result<void>()>> calls[] = {
        {"set_settings", [&] { return world.set_settings({}); }},
        {"add_cloth", [&] { return answer_of(world.add_cloth(small_sheet(1))); }},
        {"add_cloth", [&] { return answer_of(world.add_cloth(cooked)); }},
        {"measure_cloth", [&] { return answer_of(world.measure_cloth(small_sheet(1))); }},
        {"remove_cloth", [&] { return world.remove_cloth(cloth); }},
        {"set_cloth_settings", [&] { return world.set_cloth_settings(cloth, {}); }},
        {"set_enabled", [&] { return world.set_enabled(cloth, false); }},
        {"is_asleep", [&] { return answer_of(world.is_asleep(cloth)); }},
        {"wake", [&] { return world.wake(cloth); }},
        {"cloth_info", [&] { return answer_of(world.cloth_info(cloth)); }},
        {"cloth_report", [&] { return answer_of(world.cloth_report(cloth)); }},
        {"describe", [&] { return answer_of(world.describe()); }},
        {"pin", [&] { return world.pin(cloth, 1); }},
        {"unpin", [&] { return world.unpin(cloth, 0); }},
        {"move_pins", [&] { return world.move_pin(cloth, 0, {}); }},
        {"move_cloth", [&] { return world.move_cloth(cloth, {}); }},
        {"reset_cloth", [&] { return world.reset_cloth(cloth, {}); }},
        {"resume_cloth", [&] { return world.resume_cloth(cloth, {}, {}, {}); }},
        {"add_level", [&] { return world.add_level(cloth, game.cloths[1]); }},
        {"set_level", [&] { return world.set_level(cloth, 0); }},
        {"cast_ray",
         [&] {
             return answer_of(world.cast_ray({}, {0, 1, 0}));
         }},
        {"closest_point", [&] { return answer_of(world.closest_point({})); }},
        {"triangles_in_ball", [&] { return answer_of(world.triangles_in_ball({}, 1, {})); }},
        {"set_frame", [&] { return world.set_frame(cloth, {}); }},
        {"leave_frame", [&] { return world.leave_frame(cloth); }},
        {"restore_cloth", [&] { return world.restore_cloth(cloth, {}); }},
        {"save_cloth", [&] { return world.save_cloth(cloth, {}); }},
        {"set_map", [&] { return world.set_map(cloth, Map::mass, {}); }},
        {"set_skin", [&] { return world.set_skin(cloth, {}, {}); }},
        {"shift_origin", [&] { return world.shift_origin({}); }},
        {"add_shape", [&] { return answer_of(world.add_shape(HeightField{})); }},
        {"deform_shape", [&] { return world.deform_shape(shape, {}); }},
        {"remove_shape", [&] { return world.remove_shape(shape); }},
        {"add_collider", [&] { return answer_of(world.add_collider({})); }},
        {"move_collider", [&] { return world.move_collider(collider, {}); }},
        {"place_collider", [&] { return world.place_collider(collider, {}); }},
        {"remove_collider", [&] { return world.remove_collider(collider); }},
        {"collider", [&] { return answer_of(world.collider(collider)); }},
        {"add_body", [&] { return answer_of(world.add_body({})); }},
        {"remove_body", [&] { return world.remove_body(body); }},
        {"set_body_settings", [&] { return world.set_body_settings(body, {}); }},
        {"body_state", [&] { return answer_of(world.body_state(body)); }},
        {"set_body_state", [&] { return world.set_body_state(body, {}); }},
        {"attach_collider", [&] { return world.attach_collider(body, collider); }},
        {"detach_collider", [&] { return world.detach_collider(collider); }},
        {"attach", [&] { return world.attach(body, cloth, none); }},
        {"detach", [&] { return world.detach(cloth, none); }},
        {"begin_step", [&] { return world.begin_step(h); }},
        {"start_trace", [&] { return world.start_trace(); }},
        {"write_trace", [&] { return world.write_trace("/tmp/none"); }},
        {"save", [&] { return world.save(saved); }},
        {"restore", [&] { return world.restore(saved); }},
        {"start_recording", [&] { return world.start_recording(sink_to(recorded)); }},
        {"stop_recording", [&] { return world.stop_recording(); }},
    };
    for (const auto& [name, call] : calls) expect_refused(call(), name);
    EXPECT_EQ(world.step(h).flags, StepFlags::step_under_way);
    EXPECT_EQ(world.save_size(), 0u);
    EXPECT_EQ(world.state_hash(), 0u);
    EXPECT_TRUE(world.contacts().empty());
    EXPECT_TRUE(world.body_impulses().empty());
    EXPECT_TRUE(world.profile().empty());
    DebugCanvas canvas{.line = [](void*, const Vec3&, const Vec3&, const Vec3&) { ADD_FAILURE(); }};
    world.debug_draw(canvas, DebugParts::all);
    EXPECT_TRUE(world.body_settings(body));
    EXPECT_TRUE(world.shape_info(shape));

    ASSERT_TRUE(world.end_step());
    EXPECT_EQ(world.report().step, 2u);
    EXPECT_NE(world.state_hash(), before);
    EXPECT_TRUE(world.pin(cloth, 1));
    EXPECT_FALSE(world.contacts().empty() && world.body_impulses().empty());
}

TEST(StepApart, RefusesWhatIsOutOfItsOrder) {
    Game game(1);
    const auto says = [](const Result<void>& answer, const char* what) {
        return !answer && answer.error().message.find(what) != std::string::npos;
    };
    EXPECT_TRUE(says(game.world.work(), "begin_step"));
    EXPECT_TRUE(says(game.world.end_step(), "begin_step"));
    for (const float dt : {0.0f, -1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()}) {
        EXPECT_TRUE(says(game.world.begin_step(dt), "dt"));
        EXPECT_TRUE(game.world.pin(game.cloths[1], 0)) << "nothing was begun";
    }
    ASSERT_TRUE(game.world.begin_step(h));
    ASSERT_TRUE(game.world.work());
    EXPECT_TRUE(says(game.world.work(), "end_step"));
    ASSERT_TRUE(game.world.end_step());
    EXPECT_EQ(game.world.report().step, 1u);
    EXPECT_TRUE(says(game.world.end_step(), "begin_step"));
    EXPECT_EQ(game.world.step(h).step, 2u);
}

#ifndef WEFT_WITHOUT_THREADS
/// A host's threads, on which a step begins and then waits until it may go on.
struct HeldUp {
    World make_world() {
        WorldSettings settings;
        settings.executor = {.run =
                                 [](void* user, std::uint32_t count, Executor::Body body, void* context) {
                                     HeldUp& held = *static_cast<HeldUp*>(user);
                                     held.has_begun = true;
                                     while (!held.may_go_on) std::this_thread::yield();
                                     for (std::uint32_t i = 0; i < count; ++i) body(context, i);
                                 },
                             .user = this,
                             .width = 2};
        return World::create(settings).value();
    }

    std::atomic<bool> has_begun = false, may_go_on = false;
};

// A host whose World takes its steps on the host's own threads, one of which calls work().
TEST(StepApart, EndsOnlyWhenWorkHasReturned) {
    HeldUp held;
    World world = held.make_world();
    ASSERT_TRUE(world.add_cloth(small_sheet(1)));
    ASSERT_TRUE(world.begin_step(h));
    std::thread task([&] { EXPECT_TRUE(world.work()); });
    while (!held.has_begun) std::this_thread::yield();
    const auto early = world.end_step();
    held.may_go_on = true;
    task.join();
    ASSERT_FALSE(early);
    EXPECT_NE(early.error().message.find("work has not returned"), std::string::npos);
    EXPECT_TRUE(world.end_step());
    EXPECT_EQ(world.report().step, 1u);
}
#endif

TEST(StepApart, TakesItsMemoryFromTheFirstOnAndStepNone) {
    World world = World::create().value();
    const ClothId cloth = world.add_cloth(small_sheet(1, 32)).value();
    const std::uint64_t before = world.cloth_info(cloth)->bytes;
    world.step(h);
    EXPECT_EQ(world.cloth_info(cloth)->bytes, before);
    for (int k = 0; k < 2; ++k) {
        ASSERT_TRUE(world.begin_step(h));
        ASSERT_TRUE(world.end_step());
        EXPECT_EQ(world.cloth_info(cloth)->bytes, before + 64u * 1024);
    }
    const ClothId late = world.add_cloth(small_sheet(2)).value();
    ASSERT_TRUE(world.begin_step(h));
    EXPECT_EQ(world.cloth(late)->positions.size(), 81u);
    ASSERT_TRUE(world.end_step());
}

#ifndef WEFT_WITHOUT_THREADS
// Two threads that call at once would wait for each other for ever.
TEST(StepApart, CallsBesideStepAreRefusedByName) {
    HeldUp held;
    World world = held.make_world();
    const ClothId cloth = world.add_cloth(small_sheet(1)).value();
    std::thread stepping([&] { EXPECT_EQ(world.step(h).step, 1u); });
    while (!held.has_begun) std::this_thread::yield();
    EXPECT_EQ(world.step(h).flags, StepFlags::step_under_way);
    EXPECT_EQ(world.report().flags, StepFlags::step_under_way);
    const auto says = [](const auto& answer, const char* call) {
        return !answer && answer.error().message.find(std::string(call) + ": another thread") == 0;
    };
    EXPECT_TRUE(says(world.pin(cloth, 0), "pin"));
    EXPECT_TRUE(says(world.cloth(cloth), "cloth"));
    EXPECT_TRUE(says(world.write_vertices(cloth, {}), "write_vertices"));
    EXPECT_TRUE(says(world.begin_step(h), "begin_step"));
    EXPECT_FALSE(world.work());
    EXPECT_FALSE(world.end_step());
    EXPECT_EQ(world.state_hash(), 0u);
    held.may_go_on = true;
    stepping.join();
    EXPECT_TRUE(world.pin(cloth, 0));
    EXPECT_EQ(world.step(h).step, 2u);
    EXPECT_EQ(world.report().step, 2u);
}
#endif

TEST(StepApart, IsRecordedAsAStep) {
    Bytes bytes;
    Game game(1);
    World world = World::create().value();
    ASSERT_TRUE(world.start_recording(sink_to(bytes)));
    ASSERT_TRUE(world.add_cloth(small_sheet(1)));
    ASSERT_TRUE(world.begin_step(h));
    ASSERT_TRUE(world.work());
    ASSERT_TRUE(world.end_step());
    world.step(h);
    ASSERT_TRUE(world.stop_recording());
    const auto replayed = replay(bytes);
    ASSERT_TRUE(replayed);
    EXPECT_EQ(replayed->steps, 2u);
    EXPECT_FALSE(replayed->difference);
}

}  // namespace
}  // namespace weft::test
