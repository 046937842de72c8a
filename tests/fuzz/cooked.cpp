#include "tests/fuzz/cooked.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "engine/state_hash.h"
#include "tests/fuzz/play.h"
#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

namespace {

using CookedBytes = std::vector<std::byte>;

void must(bool holds, const std::string& what) {
    if (!holds) throw Failure{0, "its cooked cloth: " + what};
}

constexpr std::size_t cooked_head = 64, cooked_sum = cooked_head - 8, piece = 65536;

std::uint64_t sum_of(CookedBytes bytes) {
    std::fill_n(bytes.begin() + cooked_sum, 8, std::byte{});
    std::array<std::byte, cooked_head> head;
    std::copy_n(bytes.begin(), cooked_head, head.begin());
    StateHash hash;
    hash.add(std::span<const std::array<std::byte, cooked_head>>(&head, 1));
    for (std::size_t at = cooked_head; at < bytes.size(); at += piece)
        hash.add(std::span<const std::byte>(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    return hash.value();
}
std::uint64_t sum_in(const CookedBytes& bytes) {
    std::uint64_t sum = 0;
    std::memcpy(&sum, bytes.data() + cooked_sum, sizeof sum);
    return sum;
}

CookedBytes flipped(const CookedBytes& bytes, std::size_t from, Random& random) {
    CookedBytes other = bytes;
    other[from + random.below(bytes.size() - from)] ^= std::byte(1u << random.below(8));
    return other;
}

/// It may move as it likes.
void step(const CookedCloth& cooked) {
    World world = World::create({.threads = 1}).value();
    const auto cloth = world.add_cloth(cooked);
    if (!cloth) return;
    if (!world.pin(*cloth, 0)) return;
    for (int k = 0; k < 2; ++k) world.step(1.0f / 60);
}

}  // namespace

Result<CookedCloth> saved_and_read(const CookedCloth& cooked, const ClothSettings& settings,
                                   std::uint64_t seed) {
    Random random(seed);
    CookedBytes bytes(cooked.save_size());
    must(cooked.save(bytes).ok(), "it was not saved");
    must(sum_of(bytes) == sum_in(bytes), "its checksum is made otherwise than here");
    for (int k = 0; k < 2; ++k) {
        must(!CookedCloth::load(flipped(bytes, 0, random), settings), "a flipped bit was read");
        must(!CookedCloth::load(std::span(bytes).first(random.below(bytes.size())), settings),
             "what was cut off was read");
    }
    for (int k = 0; k < 4; ++k) {
        CookedBytes other = flipped(bytes, k % 2 == 0 ? cooked_head : 12, random);
        const std::uint64_t sum = sum_of(other);
        std::memcpy(other.data() + cooked_sum, &sum, sizeof sum);
        if (const auto read = CookedCloth::load(other, settings)) step(*read);
    }
    return CookedCloth::load(bytes, settings);
}

}  // namespace weft::fuzz
