// What was recorded, stepped again: every call, differences, and recordings that are not what they should be.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/platform.h"
#include "tests/cloth/record/recordings.h"

namespace weft::test {
namespace {

const Bytes& recorded() {
    static const Bytes bytes = every_call_recorded();
    return bytes;
}

void expect_refused(const Result<Replay>& replayed, const std::string& says) {
    ASSERT_FALSE(replayed);
    EXPECT_EQ(replayed.error().code, ErrorCode::malformed_file);
    EXPECT_NE(replayed.error().message.find(says), std::string::npos) << replayed.error().message;
}

TEST(Replay, HasTheBytesOfEveryStepByAnyThreads) {
    for (const int threads : {1, 3}) {
        const auto replayed = replay(recorded(), {.threads = threads});
        ASSERT_TRUE(replayed) << replayed.error().message;
        EXPECT_FALSE(replayed->difference) << "step " << replayed->difference->step;
        EXPECT_TRUE(replayed->is_whole);
        EXPECT_EQ(replayed->steps, 21u);
    }
}

TEST(Replay, OfEveryCallThereIs) {
    std::set<Call> calls;
    for (const Record& record : records_of(recorded())) calls.insert(record.call());
    EXPECT_EQ(calls.size(), static_cast<std::size_t>(Call::last) + 1) << "a call that no test replays";
}

// The number of what was given is the last bit of a float: what follows is hardly to be seen.
TEST(Replay, FindsAPlantedDifference) {
    Bytes bytes = recorded();
    const auto records = records_of(bytes);
    const auto moved = std::ranges::find(records, Call::move_pins, &Record::call);
    ASSERT_NE(moved, records.end());
    const std::uint64_t steps_before = static_cast<std::uint64_t>(
        std::count_if(records.begin(), moved, [](const Record& r) { return r.call() == Call::step; }));
    bytes[moved->given() + sizeof(ClothId) + 8 + 2 * sizeof(std::uint32_t) + 8] ^= std::byte{1};
    seal(bytes, *moved);
    const auto replayed = replay(bytes, {.threads = 1});
    ASSERT_TRUE(replayed) << replayed.error().message;
    ASSERT_TRUE(replayed->difference);
    EXPECT_EQ(replayed->difference->step, steps_before + 1);
    EXPECT_EQ(replayed->difference->cloth, 0u);
    EXPECT_EQ(replayed->steps, steps_before + 1) << "nothing is stepped behind it";
    EXPECT_FALSE(replayed->is_whole);
}

TEST(Replay, NamesTheClothThatDiffersByItsPlace) {
    Bytes bytes = recorded();
    const auto records = records_of(bytes);
    // The last pin is of the eighth cloth, which took the first one's place.
    const auto last =
        std::find_if(records.rbegin(), records.rend(), [](const Record& r) { return r.call() == Call::pin; });
    bytes[last->given() + sizeof(ClothId) + 8] ^= std::byte{4};  // of vertex 3 vertex 7
    seal(bytes, *last);
    const auto replayed = replay(bytes, {.threads = 1});
    ASSERT_TRUE(replayed) << replayed.error().message;
    ASSERT_TRUE(replayed->difference);
    EXPECT_EQ(replayed->difference->cloth, 7u);
    EXPECT_EQ(replayed->difference->step, 18u);
}

TEST(Replay, TellsWhatDiffersBesidesCloth) {
    Bytes bytes;
    {
        World world = World::create().value();
        ASSERT_TRUE(world.start_recording(sink_to(bytes)));
        const ColliderId id = world.add_collider({.shape = Sphere{{5, 0, 0}, 0.1f}}).value();
        ASSERT_TRUE(world.add_cloth(small_sheet(1)));
        ASSERT_TRUE(world.step(1.0f / 60).step == 1);
        ASSERT_TRUE(world.move_collider(id, {.shape = Sphere{{6, 0, 0}, 0.1f}}));
        world.step(1.0f / 60);
    }
    const auto records = records_of(bytes);
    EXPECT_EQ(records.back().call(), Call::end) << "the World's end ends it";
    const auto moved = std::ranges::find(records, Call::move_collider, &Record::call);
    bytes[moved->given() + sizeof(ColliderId) + 4] ^= std::byte{1};
    seal(bytes, *moved);
    const auto replayed = replay(bytes);
    ASSERT_TRUE(replayed) << replayed.error().message;
    ASSERT_TRUE(replayed->difference);
    EXPECT_FALSE(replayed->difference->cloth);
    EXPECT_EQ(replayed->difference->step, 2u);
}

// Truncated at any byte it is replayed up to there. Every byte of the heads, and some of the rest: a replay
// takes as long as its steps.
TEST(Replay, GoesAsFarAsABrokenRecordingDoes) {
    Bytes bytes;
    {
        World world = World::create().value();
        ASSERT_TRUE(world.start_recording(sink_to(bytes)));
        const ClothId cloth = world.add_cloth(small_sheet(1, 3)).value();
        for (int k = 0; k < 3; ++k) {
            world.step(1.0f / 60);
            ASSERT_TRUE(world.pin(cloth, static_cast<std::uint32_t>(k)));
        }
    }
    const auto records = records_of(bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const auto replayed = replay(std::span(bytes).first(size), {.threads = 1});
        if (size < records.front().end()) {
            expect_refused(replayed, size < sizeof(RecordingHead) ? "head alone" : "breaks off");
            continue;
        }
        ASSERT_TRUE(replayed) << size << ": " << replayed.error().message;
        EXPECT_FALSE(replayed->is_whole);
        EXPECT_FALSE(replayed->difference);
        const auto steps = std::ranges::count_if(
            records, [&](const Record& r) { return r.call() == Call::step && r.end() <= size; });
        EXPECT_EQ(replayed->steps, static_cast<std::uint64_t>(steps)) << size;
    }
    EXPECT_TRUE(replay(bytes)->is_whole);
}

TEST(Replay, RefusesAFlipOfAnyByte) {
    Bytes bytes;
    {
        World world = World::create().value();
        ASSERT_TRUE(world.start_recording(sink_to(bytes)));
        ASSERT_TRUE(world.add_cloth(small_sheet(1, 2)));
        world.step(1.0f / 60);
    }
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        bytes[at] ^= std::byte{0x10};
        const auto replayed = replay(bytes, {.threads = 1});
        EXPECT_FALSE(replayed) << "byte " << at;
        if (!replayed) {
            EXPECT_EQ(replayed.error().code, ErrorCode::malformed_file);
        }
        bytes[at] ^= std::byte{0x10};
    }
    bytes.push_back(std::byte{});
    expect_refused(replay(bytes), "behind its end");
    bytes.pop_back();
    EXPECT_TRUE(replay(bytes));
    bytes[8] = std::byte{recording_version + 1};
    expect_refused(replay(bytes), "reads version " + std::to_string(recording_version));
    bytes[0] = std::byte{'w'};
    expect_refused(replay(bytes), "WEFTRECD");
}

TEST(Replay, RefusesARecordThatIsMissing) {
    Bytes bytes = recorded();
    const Record gone = records_of(bytes)[7];
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(gone.at),
                bytes.begin() + static_cast<std::ptrdiff_t>(gone.end()));
    expect_refused(replay(bytes), "record 7");
}

// With checksums that fit, whatever stands there, is for the World to refuse.
TEST(Replay, IsHarmedByNothingThatARecordHolds) {
    const auto records = records_of(recorded());
    std::uint32_t drawn = 1;
    std::size_t refused = 0, different = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        for (int tries = 0; tries < 2; ++tries) {
            if (records[k].head.bytes == 0) continue;
            drawn = 1664525u * drawn + 1013904223u;
            Bytes bytes(recorded().begin(),
                        recorded().begin() + static_cast<std::ptrdiff_t>(records[k].end()));
            bytes[records[k].given() + (drawn >> 8) % std::min<std::uint64_t>(records[k].head.bytes, 64)] ^=
                std::byte(1u << (drawn >> 3) % 8);
            seal(bytes, records[k]);
            const auto replayed = replay(bytes, {.threads = 1});
            if (!replayed) {
                EXPECT_FALSE(replayed.error().message.empty());
            }
            refused += replayed ? 0 : 1;
            different += replayed && replayed->difference ? 1 : 0;
        }
    }
    EXPECT_GT(refused, 10u);
    EXPECT_GT(different, 5u);
}

TEST(Replay, RefusesChoicesOfLevelsThatThereAreNot) {
    std::size_t choices = 0;
    for (const Record& record : records_of(recorded())) {
        if (record.call() != Call::choose) continue;
        for (const std::uint32_t forged : {most_garment_levels * rung_count, ~0u}) {
            Bytes bytes(recorded().begin(), recorded().begin() + static_cast<std::ptrdiff_t>(record.end()));
            std::byte* const last = bytes.data() + record.end() - sizeof forged;
            std::uint32_t rung = 0;
            std::memcpy(&rung, last, sizeof rung);
            ASSERT_LT(rung, most_garment_levels * rung_count);
            std::memcpy(last, &forged, sizeof forged);
            seal(bytes, record);
            EXPECT_FALSE(replay(bytes, {.threads = 1}));
        }
        ++choices;
    }
    EXPECT_GT(choices, 0u);
}

#ifndef WEFT_WITHOUT_FILES
TEST(Replay, SaysWhichFileCannotBeRead) {
    const auto replayed = replay(std::filesystem::path("/no/such/recording"));
    ASSERT_FALSE(replayed);
    EXPECT_EQ(replayed.error().code, ErrorCode::file_not_found);
    EXPECT_NE(replayed.error().message.find("/no/such/recording"), std::string::npos);
    EXPECT_FALSE(replay(std::filesystem::temp_directory_path()));
}
#endif

}  // namespace
}  // namespace weft::test
