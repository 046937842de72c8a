// World::start_recording, as a host uses it: when it may begin, where it goes, and what it leaves as it is.

#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "engine/platform.h"
#include "tests/cloth/record/recordings.h"

namespace weft::test {
namespace {

TEST(Recording, ChangesNothing) {
    Bytes bytes;
    World plain = World::create().value(), other = World::create().value();
    ASSERT_TRUE(other.start_recording(sink_to(bytes)));
    EveryCall(plain).play();
    EveryCall(other).play();
    EXPECT_EQ(plain.state_hash(), other.state_hash());
}

#ifndef WEFT_WITHOUT_FILES
TEST(Recording, InAFileIsThatInMemory) {
    const auto file = std::filesystem::temp_directory_path() / "weft_recording_test.weftrec";
    {
        World world = World::create().value();
        ASSERT_TRUE(world.start_recording(file));
        ASSERT_TRUE(world.add_cloth(small_sheet(1)));
        world.step(h);
        // What a program that crashes here leaves.
        EXPECT_EQ(replay(file)->steps, 1u);
        EXPECT_FALSE(replay(file)->is_whole);
        world.step(h);
        ASSERT_TRUE(world.stop_recording());
        EXPECT_TRUE(replay(file)->is_whole);
        world.step(h);
        EXPECT_EQ(replay(file)->steps, 2u);
    }
    Bytes bytes;
    World world = World::create().value();
    ASSERT_TRUE(world.start_recording(sink_to(bytes)));
    const ClothId cloth = world.add_cloth(small_sheet(1)).value();
    world.step(h);
    world.step(h);
    ASSERT_TRUE(world.stop_recording());
    std::ifstream in(file, std::ios::binary);
    const std::string in_file((std::istreambuf_iterator<char>(in)), {});
    EXPECT_EQ(in_file.size(), bytes.size());
    const auto of_file = replay(file);
    std::filesystem::remove(file);
    ASSERT_TRUE(of_file);
    EXPECT_FALSE(of_file->difference);
    EXPECT_EQ(of_file->steps, replay(bytes)->steps);
    EXPECT_TRUE(world.pin(cloth, 0)) << "after it has ended the World goes on";
}
#endif

TEST(Recording, LeavesOutWhatWasRefusedAndWhatChangesNothing) {
    Bytes bytes;
    World world = World::create().value();
    ASSERT_TRUE(world.start_recording(sink_to(bytes)));
    const ClothId cloth = world.add_cloth(small_sheet(1)).value();
    const std::size_t before = bytes.size();
    EXPECT_FALSE(world.pin(cloth, 100000));
    EXPECT_FALSE(world.remove_cloth({7, 7}));
    EXPECT_FALSE(world.set_cloth_settings(cloth, {.substeps = -1}));
    EXPECT_TRUE(has(world.step(-1).flags, StepFlags::invalid_dt));
    EXPECT_TRUE(world.measure_cloth(small_sheet(1)));
    EXPECT_TRUE(world.cloth(cloth));
    EXPECT_EQ(bytes.size(), before);
}

TEST(Recording, BeginsWithANewWorldOnly) {
    Bytes bytes;
    World world = World::create().value();
    ASSERT_FALSE(world.stop_recording()) << "nothing is recorded";
    EXPECT_FALSE(world.pin({}, 0));
    ASSERT_TRUE(world.start_recording(sink_to(bytes))) << "a call that was refused changed nothing";
    EXPECT_NE(world.start_recording(sink_to(bytes)).error().message.find("already"), std::string::npos);
    ASSERT_TRUE(world.add_cloth(small_sheet(1)));
    ASSERT_TRUE(world.stop_recording());
    const auto late = world.start_recording(sink_to(bytes));
    ASSERT_FALSE(late);
    EXPECT_NE(late.error().message.find("World::create"), std::string::npos) << late.error().message;
    World stepped = World::create().value();
    stepped.step(h);
    EXPECT_FALSE(stepped.start_recording(sink_to(bytes)));
    EXPECT_FALSE(World::create()->start_recording(RecordingSink{}));
    const auto nowhere = World::create()->start_recording("/no/such/folder/recording");
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().message.find("/no/such/folder/recording"), std::string::npos);
}

struct Narrow {
    std::size_t left;
    Bytes bytes;
    [[nodiscard]] RecordingSink sink() {
        return {[](void* to, std::span<const std::byte> more) {
                    auto& narrow = *static_cast<Narrow*>(to);
                    if (more.size() > narrow.left) return false;
                    narrow.left -= more.size();
                    narrow.bytes.insert(narrow.bytes.end(), more.begin(), more.end());
                    return true;
                },
                this};
    }
};

TEST(Recording, ThatCannotBeWrittenIsSaidWhenItEnds) {
    Narrow narrow{4096, {}};
    World world = World::create().value();
    ASSERT_TRUE(world.start_recording(narrow.sink()));
    const ClothId cloth = world.add_cloth(small_sheet(1, 5)).value();
    for (int k = 0; k < 60; ++k) EXPECT_EQ(world.step(h).flags, StepFlags::none);
    EXPECT_TRUE(world.pin(cloth, 0)) << "the World goes on";
    const auto stopped = world.stop_recording();
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::file_not_found);
    EXPECT_NE(stopped.error().message.find("breaks off"), std::string::npos) << stopped.error().message;
    const auto replayed = replay(narrow.bytes);
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_FALSE(replayed->is_whole);
    EXPECT_GT(replayed->steps, 3u);
    EXPECT_LT(replayed->steps, 60u);
    Narrow none{8, {}};
    EXPECT_FALSE(World::create()->start_recording(none.sink()));
}

#ifndef WEFT_WITHOUT_FILES
TEST(Recording, OfAFullDiskIsSaidWhenItEnds) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
    World world = World::create().value();
    const auto started = world.start_recording("/dev/full");
    if (!started) return;
    ASSERT_TRUE(world.add_cloth(small_sheet(1)));
    world.step(h);
    EXPECT_FALSE(world.stop_recording());
}
#endif

TEST(Recording, HasEachCookingOnceAndAllItsCloths) {
    ClothSettings stiff;
    stiff.fabric.bending = 1e-3f;
    const CookedCloth one = CookedCloth::create(small_sheet(1)).value();
    const CookedCloth other = CookedCloth::create(small_sheet(2), stiff).value();
    const auto recorded = [&](int copies) {
        Bytes bytes;
        World world = World::create().value();
        EXPECT_TRUE(world.start_recording(sink_to(bytes)));
        for (int k = 0; k < copies; ++k)
            for (const CookedCloth& cooked : {one, other}) {
                const Transform place{.translation = {static_cast<float>(k), 0, 0}};
                const ClothId id = world.add_cloth(cooked, place).value();
                EXPECT_TRUE(world.pin(id, 0));
            }
        for (int k = 0; k < 10; ++k) world.step(h);
        EXPECT_TRUE(world.stop_recording());
        return bytes;
    };
    const Bytes bytes = recorded(3);
    const auto again = replay(bytes);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(again->is_whole);
    EXPECT_EQ(again->steps, 10u);
    EXPECT_FALSE(again->difference);
    EXPECT_LT(bytes.size() - recorded(2).size(), one.save_size() / 2);
}

/// Hash of the arguments' lengths of each call, and of the fields' names of the structs among them. Left out:
/// calls with a save or a cooked cloth, which have versions of their own, and what the budget chose.
std::uint64_t layout() {
    StateHash hash;
    const Bytes bytes = every_call_recorded();
    std::map<Call, std::uint64_t> lengths;
    for (const Record& record : records_of(bytes)) lengths.try_emplace(record.call(), record.head.bytes);
    for (const Call call : {Call::cook, Call::restore, Call::choose}) lengths.erase(call);
    for (const auto& [call, length] : lengths) {
        hash.add(static_cast<std::uint32_t>(call));
        hash.add(length);
    }
    const auto add_names = [&](const auto& of) {
        for_each_field(of, [&](const char* name, const auto&) {
            hash.add(std::as_bytes(std::span(name, std::char_traits<char>::length(name))));
        });
    };
    add_names(ClothSettings());
    add_names(Fabric());
    add_names(SelfCollision());
    add_names(WorldSettings());
    add_names(Wind());
    add_names(Collider());
    add_names(BodySettings());
    return hash.value();
}

// If this fails, raise recording_version, and write both numbers here.
TEST(Recording, AnotherLayoutHasAnotherVersion) {
    EXPECT_EQ(std::pair(recording_version, layout()), std::pair(10u, std::uint64_t{18338148875979126101u}));
}

}  // namespace
}  // namespace weft::test
