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

// A call hashes the number of values, the size of one, and their bytes.
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

TEST(StateHash, ChangesWithEveryByte) {
    auto bytes = counting_bytes(300);
    const auto whole = hash_of(bytes);
    for (std::uint8_t& byte : bytes) {
        byte ^= 1;
        EXPECT_NE(hash_of(bytes), whole);
        byte ^= 1;
    }
}

}  // namespace
}  // namespace weft
