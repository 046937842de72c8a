#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/memory/aligned_buffer.h"
#include "engine/slot_map.h"
#include "weft/types.h"

namespace weft {

namespace {

struct Id {
    std::uint32_t index = 0, generation = 0;
    friend auto operator<=>(Id, Id) = default;
};
using Map = SlotMap<Id, std::string>;

TEST(SlotMap, NeverFollowsAStaleId) {
    Map map;
    const Id stale = map.insert("old");
    EXPECT_TRUE(map.erase(stale));
    EXPECT_FALSE(map.erase(stale));
    EXPECT_EQ(map.find(stale), nullptr);

    const Id fresh = map.insert("new");  // the same slot, one generation on
    EXPECT_EQ(fresh.index, stale.index);
    EXPECT_EQ(fresh.generation, stale.generation + 1);
    EXPECT_EQ(map.find(stale), nullptr);
    EXPECT_FALSE(map.erase(stale));
    EXPECT_EQ(*map.find(fresh), "new");
}

TEST(SlotMap, RefusesIdsThatItNeverGaveOut) {
    Map map;
    const Id id = map.insert("a");
    EXPECT_EQ(map.find(Id{id.index + 1, 1}), nullptr);
    EXPECT_EQ(map.find(Id{id.index, id.generation + 1}), nullptr);
    EXPECT_FALSE(map.erase(Id{0xFFFFFFFFu, 1}));
}

TEST(SlotMap, VisitsLiveObjectsInIndexOrder) {
    Map map;
    map.insert("a");
    const Id b = map.insert("b");
    map.insert("c");
    map.erase(b);
    std::string visited;
    map.for_each([&](Id, std::string& value) { visited += value; });
    EXPECT_EQ(visited, "ac");
    map.insert("B");
    visited.clear();
    std::as_const(map).for_each([&](Id id, const std::string& value) {
        EXPECT_EQ(map.find(id), &value);
        visited += value;
    });
    EXPECT_EQ(visited, "aBc");
}

TEST(SlotMap, AgreesWithADictionaryOverRandomUse) {
    std::mt19937 random(3);
    Map map;
    std::map<Id, std::string> live;
    std::vector<Id> given;
    for (int i = 0; i < 20000; ++i) {
        if (given.empty() || random() % 2 == 0) {
            const Id id = map.insert(std::to_string(i));
            ASSERT_TRUE(live.emplace(id, std::to_string(i)).second) << "an id was given out twice";
            given.push_back(id);
        } else {
            const Id id = given[random() % given.size()];
            ASSERT_EQ(map.erase(id), live.erase(id) == 1);
        }
        const Id probe = given[random() % given.size()];
        const auto expected = live.find(probe);
        const std::string* const found = map.find(probe);
        ASSERT_EQ(found != nullptr, expected != live.end());
        ASSERT_TRUE(!found || *found == expected->second);
        ASSERT_EQ(map.size(), live.size());
    }
}

TEST(SlotMap, FirstGenerationsLieFarApart) {
    std::set<std::uint32_t> firsts;
    constexpr std::uint32_t maps = 1000;
    while (firsts.size() < maps) {
        const std::uint32_t first = new_first_generation();
        ASSERT_NE(first, 0u);
        ASSERT_TRUE(firsts.insert(first).second);
    }
    std::uint32_t last = *firsts.rbegin();
    for (const std::uint32_t first : firsts) {
        EXPECT_GE(first - last, 0xFFFFFFFFu / (3 * maps));  // the last of all stands before the first
        last = first;
    }
}

TEST(SlotMap, RefusesTheIdsOfAnotherMap) {
    std::mt19937 random(5);
    std::vector<Map> maps;
    for (int i = 0; i < 8; ++i) maps.emplace_back(new_first_generation());
    std::vector<std::vector<Id>> given(maps.size());
    for (int i = 0; i < 8000; ++i) {
        const std::size_t m = random() % maps.size();
        if (given[m].empty() || random() % 3 > 0)
            given[m].push_back(maps[m].insert("x"));
        else
            maps[m].erase(given[m][random() % given[m].size()]);
    }
    for (std::size_t m = 0; m < maps.size(); ++m) {
        for (std::size_t other = 0; other < maps.size(); ++other) {
            if (other == m) continue;
            const std::size_t size = maps[m].size();
            for (const Id id : given[other]) {
                ASSERT_EQ(maps[m].find(id), nullptr);
                ASSERT_FALSE(maps[m].erase(id));
            }
            ASSERT_EQ(maps[m].size(), size);
        }
    }
}

// Ids of a byte, so that all generations can be used: each once, and then the slot never again.
TEST(SlotMap, RetiresASlotWhoseGenerationsAreUsedUp) {
    struct SmallId {
        std::uint32_t index = 0;
        std::uint8_t generation = 0;
    };
    for (const int first : {1, 2, 100, 255}) {
        SlotMap<SmallId, int> map(static_cast<std::uint8_t>(first));
        std::set<int> used;
        for (int life = 0; life < 255; ++life) {
            const SmallId id = map.insert(life);
            ASSERT_EQ(id.index, 0u);
            ASSERT_NE(id.generation, 0);
            ASSERT_TRUE(used.insert(id.generation).second);
            ASSERT_TRUE(map.erase(id));
        }
        EXPECT_EQ(map.size(), 0u);
        EXPECT_EQ(map.insert(0).index, 1u);
        EXPECT_EQ(map.size(), 1u);
        for (const int generation : used)
            EXPECT_EQ(map.find({0, static_cast<std::uint8_t>(generation)}), nullptr);
    }
}

// A map that starts three before the largest number: its second life goes on from 1, and null stays null.
TEST(SlotMap, GoesOnFromOneAfterTheLargestGeneration) {
    Map map(0xFFFFFFFDu);
    const std::uint32_t expected[] = {0xFFFFFFFDu, 0xFFFFFFFEu, 0xFFFFFFFFu, 1, 2};
    std::vector<Id> stale;
    for (const std::uint32_t generation : expected) {
        const Id id = map.insert("x");
        EXPECT_EQ(id, (Id{0, generation}));
        for (const Id old : stale) EXPECT_EQ(map.find(old), nullptr);
        EXPECT_EQ(map.find(Id{}), nullptr);
        EXPECT_TRUE(map.erase(id));
        stale.push_back(id);
    }
}

TEST(AlignedBuffer, MovesItsMemoryInsteadOfCopyingIt) {
    AlignedBuffer<int> from(5);
    from[4] = 7;
    const int* const memory = from.data();
    const AlignedBuffer<int> to = std::move(from);
    EXPECT_EQ(to.data(), memory);
    EXPECT_EQ(to[4], 7);
}

TEST(AlignedBuffer, CopiesShareNothing) {
    for (const std::size_t size : {0u, 1u, 16u, 37u}) {
        AlignedBuffer<int> from(size);
        std::iota(from.span().begin(), from.span().end(), 1);
        AlignedBuffer<int> copy = from;
        ASSERT_EQ(copy.size(), size);
        EXPECT_TRUE(std::ranges::equal(copy.span(), from.span()));
        EXPECT_EQ(copy.bytes(), from.bytes());
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % 64, 0u);
        for (int& x : copy.span()) x = -1;
        EXPECT_EQ(std::ranges::count(from.span(), -1), 0);
        EXPECT_EQ(std::count(copy.data() + size, copy.data() + copy.bytes() / sizeof(int), 0),
                  static_cast<std::ptrdiff_t>(copy.bytes() / sizeof(int) - size))
            << "what fills the last group";
    }
}

TEST(AlignedBuffer, ThatIsUnmadeHasCopiesOfZeros) {
    const AlignedBuffer<int> later(21, unmade);
    EXPECT_EQ(later.size(), 21u);
    EXPECT_EQ(later.data(), nullptr);
    EXPECT_EQ(later.bytes(), 32 * sizeof(int));
    AlignedBuffer<int> full(21);
    full[20] = 5;
    const AlignedBuffer<int> copy = later;
    AlignedBuffer<int> assigned = full;
    assigned = later;
    for (const auto* made : {&copy, &std::as_const(assigned)}) {
        ASSERT_EQ(made->size(), 21u);
        for (std::size_t i = 0; i < 32; ++i) EXPECT_EQ(made->data()[i], 0);
    }
    AlignedBuffer<int> becomes(21, unmade);
    becomes = full;
    EXPECT_EQ(becomes[20], 5);
    EXPECT_EQ(AlignedBuffer<int>(AlignedBuffer<int>(0, unmade)).size(), 0u);
}

#ifdef __cpp_exceptions
// Sizes whose bytes, or whose whole groups, are more than a size_t holds must not become small ones.
TEST(AlignedBuffer, OfMoreThanThereCanBeIsRefused) {
    constexpr std::size_t largest = std::numeric_limits<std::size_t>::max();
    for (const std::size_t size : {largest, largest - 14, largest / 16 + 1, largest / 16 + 2, largest / 32})
        EXPECT_THROW(AlignedBuffer<Vec4>{size}, std::bad_alloc) << size;
    EXPECT_THROW(AlignedBuffer<char>{largest}, std::bad_alloc);
    EXPECT_THROW(AlignedBuffer<char>{largest - 14}, std::bad_alloc);
}
#endif

}  // namespace

}  // namespace weft
