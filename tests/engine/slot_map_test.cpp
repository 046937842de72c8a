#include "engine/slot_map.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>

namespace weft {
namespace {

struct Id {
    std::uint32_t index = 0, generation = 0;
    friend auto operator<=>(Id, Id) = default;
};
using Map = SlotMap<Id, std::string>;

TEST(SlotMap, FindsWhatWasInserted) {
    Map map;
    const Id a = map.insert("a"), b = map.insert("b");
    EXPECT_NE(a, b);
    EXPECT_EQ(*map.find(a), "a");
    EXPECT_EQ(*std::as_const(map).find(b), "b");
    EXPECT_EQ(map.size(), 2u);
}

TEST(SlotMap, KnowsNullFromEverythingElse) {
    Map map;
    EXPECT_EQ(map.find(Id{}), nullptr);
    const Id first = map.insert("a");
    EXPECT_NE(first, Id{});
    EXPECT_EQ(map.find(Id{}), nullptr);
    EXPECT_FALSE(map.erase(Id{}));
    EXPECT_EQ(map.size(), 1u);
}

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

TEST(SlotMap, DestroysWhatIsErased) {
    SlotMap<Id, std::shared_ptr<int>> map;
    const auto object = std::make_shared<int>(1);
    const Id id = map.insert(object);
    EXPECT_EQ(object.use_count(), 2);
    map.erase(id);
    EXPECT_EQ(object.use_count(), 1);
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

}  // namespace
}  // namespace weft
