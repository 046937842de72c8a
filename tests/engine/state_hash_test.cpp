#include "engine/state_hash.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

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

TEST(StateHash, OfPartsIsTheHashOfTheWhole) {
    const auto bytes = counting_bytes(5000);
    const std::span<const std::uint8_t> all(bytes);
    for (const std::size_t part : {1u, 3u, 16u, 255u, 1000u, 4999u}) {
        StateHash hash;
        for (std::size_t begin = 0; begin < all.size(); begin += part)
            hash.add(all.subspan(begin, std::min(part, all.size() - begin)));
        EXPECT_EQ(hash.value(), hash_of(all)) << "in parts of " << part;
    }
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
    const auto bytes = counting_bytes(600);
    const std::span<const std::uint8_t> all(bytes);
    StateHash hash;
    hash.add(all.first(300));
    EXPECT_EQ(hash.value(), hash_of(all.first(300)));
    hash.add(all.subspan(300));
    EXPECT_EQ(hash.value(), hash_of(all));
}

}  // namespace
}  // namespace weft
