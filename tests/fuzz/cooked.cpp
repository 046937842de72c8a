#include "tests/fuzz/cooked.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tests/cooked_seal.h"
#include "tests/fuzz/play.h"
#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

namespace {

using CookedBytes = std::vector<std::byte>;

void must(bool holds, const std::string& what) {
    if (!holds) throw Failure{0, "its cooked cloth: " + what};
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
    CookedBytes sealed = bytes;
    test::seal_cooked(sealed);
    must(sealed == bytes, "its checksum is made otherwise than here");
    for (int k = 0; k < 2; ++k) {
        must(!CookedCloth::load(flipped(bytes, 0, random), settings), "a flipped bit was read");
        must(!CookedCloth::load(std::span(bytes).first(random.below(bytes.size())), settings),
             "what was cut off was read");
    }
    for (int k = 0; k < 4; ++k) {
        CookedBytes other = flipped(bytes, k % 2 == 0 ? test::cooked_head : 12, random);
        test::seal_cooked(other);
        if (const auto read = CookedCloth::load(other, settings)) step(*read);
    }
    return CookedCloth::load(bytes, settings);
}

}  // namespace weft::fuzz
