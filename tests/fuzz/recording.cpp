#include "tests/fuzz/recording.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "cloth/record/record_format.h"
#include "tests/cooked_seal.h"
#include "tests/fuzz/play.h"
#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

namespace {

using Bytes = std::vector<std::byte>;

void check_that(bool holds, const std::string& what) {
    if (!holds) throw Failure{0, "its recording, or a cooked cloth: " + what};
}

void replay_flipped(Random& random, const Bytes& recorded, bool sealed) {
    Bytes bytes = recorded;
    std::size_t at = random.below(bytes.size());
    if (sealed) {
        const std::vector<std::size_t> records = harmless_records(bytes);
        if (records.empty()) return;
        const std::size_t record = records[random.below(records.size())];
        RecordHead head;
        std::memcpy(&head, bytes.data() + record, sizeof head);
        at = record + sizeof head + random.below(head.bytes);
        bytes[at] ^= std::byte(1u << random.below(8));
        seal(bytes, record);
    } else {
        bytes[at] ^= std::byte(1u << random.below(8));
    }
    const auto replayed = replay(bytes, {.threads = 1});
    if (!replayed) {
        check_that(replayed.error().code == ErrorCode::malformed_file && !replayed.error().message.empty(),
                   "refused otherwise: " + replayed.error().message);
        return;
    }
    check_that(sealed, "byte " + std::to_string(at) + " is flipped, and nobody notices");
}

}  // namespace

RecordingSink sink_to(Bytes& bytes) {
    return {[](void* to, std::span<const std::byte> more) {
                auto& all = *static_cast<Bytes*>(to);
                all.insert(all.end(), more.begin(), more.end());
                return true;
            },
            &bytes};
}

void check_recording(std::uint64_t seed, std::span<const std::byte> recorded) {
    Random random(seed);
    const auto whole = replay(recorded, {.threads = 2});
    check_that(whole.ok(), whole ? "" : whole.error().message);
    check_that(!whole->difference,
               whole->difference ? "step " + std::to_string(whole->difference->step) + " differs" : "");
    check_that(whole->is_whole, "it breaks off");

    const auto cut = recorded.first(random.below(recorded.size()));
    const auto broken = replay(cut, {.threads = 1});
    check_that(
        broken ? !broken->is_whole && !broken->difference : broken.error().code == ErrorCode::malformed_file,
        "cut off after " + std::to_string(cut.size()) + " bytes");
    const Bytes bytes(recorded.begin(), recorded.end());
    replay_flipped(random, bytes, false);
    replay_flipped(random, bytes, true);
}

namespace {

Bytes flipped(const Bytes& bytes, std::size_t from, Random& random) {
    Bytes other = bytes;
    other[from + random.below(bytes.size() - from)] ^= std::byte(1u << random.below(8));
    return other;
}

/// Steps a damaged but accepted cloth: any motion is right, a crash is not.
void step_cooked(const CookedCloth& cooked) {
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
    Bytes bytes(cooked.save_size());
    check_that(cooked.save(bytes).ok(), "it was not saved");
    Bytes sealed = bytes;
    test::seal_cooked(sealed);
    check_that(sealed == bytes, "its checksum is made otherwise than here");
    for (int k = 0; k < 2; ++k) {
        check_that(!CookedCloth::load(flipped(bytes, 0, random), settings), "a flipped bit was read");
        check_that(!CookedCloth::load(std::span(bytes).first(random.below(bytes.size())), settings),
                   "what was cut off was read");
    }
    for (int k = 0; k < 4; ++k) {
        Bytes other = flipped(bytes, k % 2 == 0 ? test::cooked_head : 12, random);
        test::seal_cooked(other);
        if (const auto read = CookedCloth::load(other, settings)) step_cooked(*read);
    }
    return CookedCloth::load(bytes, settings);
}

}  // namespace weft::fuzz
