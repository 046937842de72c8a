#include "engine/state_hash.h"

#include <gtest/gtest.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>
#include <numeric>
#include <set>
#include <vector>

#include "weft/types.h"

namespace weft {
namespace {

std::uint64_t hash_of(std::span<const std::uint8_t> bytes) {
    StateHash hash;
    hash.add(bytes);
    return hash.value();
}

std::vector<std::uint8_t> counting_bytes(std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return bytes;
}

// XXH3 of nothing with seed 0, as given by the test vectors of its specification.
TEST(StateHash, OfNothingIsThePublishedValue) {
    EXPECT_EQ(StateHash().value(), 0x2D06800538D394C2u);
}

// What is hashed of a call: the number of values, the size of one, their bytes.
TEST(StateHash, OfValuesIsTheHashOfTheirNumberSizeAndBytes) {
    for (const std::size_t size : {0u, 1u, 3u, 16u, 255u, 1000u, 4999u}) {
        const auto bytes = counting_bytes(size);
        std::vector<std::uint8_t> all(16);
        const std::uint64_t shape[] = {size, 1};
        std::memcpy(all.data(), shape, sizeof shape);
        all.insert(all.end(), bytes.begin(), bytes.end());
        EXPECT_EQ(hash_of(bytes), XXH3_64bits(all.data(), all.size())) << size << " bytes";
    }
}

TEST(StateHash, ChangesWhenAValueMovesToTheNextArray) {
    const std::vector<float> values{1, 2, 3, 4, 5};
    std::set<std::uint64_t> hashes;
    for (std::size_t cut = 0; cut <= values.size(); ++cut) {
        StateHash hash;
        hash.add(std::span(values).first(cut));
        hash.add(std::span(values).subspan(cut));
        hashes.insert(hash.value());
    }
    StateHash whole;
    whole.add(std::span(values));
    hashes.insert(whole.value());
    EXPECT_EQ(hashes.size(), values.size() + 2);
}

TEST(StateHash, TellsSizesOfNumbersApart) {
    StateHash two, one;
    two.add(std::uint32_t{7});
    two.add(std::uint32_t{0});
    one.add(std::uint64_t{7});
    EXPECT_NE(two.value(), one.value());
}

TEST(StateHash, TakesOneValueAsASpanOfIt) {
    enum class Kind : std::uint8_t { a = 3 };
    const Vec3 point{1, 2, 3};
    const Kind kind = Kind::a;
    const double time = 0.5;
    StateHash values, spans;
    values.add(point);
    values.add(kind);
    values.add(time);
    spans.add(std::span(&point, 1));
    spans.add(std::span(&kind, 1));
    spans.add(std::span(&time, 1));
    EXPECT_EQ(values.value(), spans.value());
}

TEST(StateHash, ChangesWithEveryByte) {
    auto bytes = counting_bytes(300);
    const auto whole = hash_of(bytes);
    for (std::uint8_t& byte : bytes) {
        byte ^= 1;
        EXPECT_NE(hash_of(bytes), whole);
        byte ^= 1;
    }
}

TEST(StateHash, DependsOnTheOrder) {
    const std::vector<float> a{1, 2}, b{3};
    StateHash ab, ba;
    ab.add(std::span<const float>(a));
    ab.add(std::span<const float>(b));
    ba.add(std::span<const float>(b));
    ba.add(std::span<const float>(a));
    EXPECT_NE(ab.value(), ba.value());
}

TEST(StateHash, MayBeReadWhileItGrows) {
    StateHash hash, first;
    first.add(1);
    hash.add(1);
    EXPECT_EQ(hash.value(), first.value());
    first.add(2);
    hash.add(2);
    EXPECT_EQ(hash.value(), first.value());
}

}  // namespace
}  // namespace weft
