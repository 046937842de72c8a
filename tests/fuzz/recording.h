#pragma once
// Recordings and cooked cloth as files: read back, and damaged.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "cloth/record/record_format.h"
#include "tests/fuzz/random/random.h"
#include "weft/weft.h"

namespace weft::fuzz {

/// A sink that appends the recording to `bytes`.
[[nodiscard]] RecordingSink sink_to(std::vector<std::byte>& bytes);

/// Checks a recording: it has the same bytes on two threads; cut off anywhere it is replayed up to there; a
/// flipped bit is refused, and one whose checksums were made right does no harm. Throws Failure.
void check_recording(std::uint64_t seed, std::span<const std::byte> recorded);

/// Saves the cloth and reads it back. Cut off or with a flipped bit it is refused; with a flipped bit and a
/// checksum that was made right it is refused, or a World steps it without harm. Throws Failure.
[[nodiscard]] Result<CookedCloth> saved_and_read(const CookedCloth& cooked, const ClothSettings& settings,
                                                 std::uint64_t seed);

/// Makes the checksums of the record at this byte right again.
inline void seal(std::vector<std::byte>& bytes, std::size_t at) {
    RecordHead head;
    std::memcpy(&head, bytes.data() + at, sizeof head);
    StateHash hasher;
    hasher.add(std::span<const std::byte>(bytes).subspan(at + sizeof head, head.bytes));
    head.hash = hasher.value();
    head.own_hash = head.hash_of_head(hasher);
    std::memcpy(bytes.data() + at, &head, sizeof head);
}

/// The places of records that take no longer when one of their bits is flipped. In settings a flipped bit may
/// ask for any number of passes.
[[nodiscard]] inline std::vector<std::size_t> harmless_records(const std::vector<std::byte>& bytes) {
    std::vector<std::size_t> found;
    for (std::size_t at = sizeof(RecordingHead); at < bytes.size();) {
        RecordHead head;
        std::memcpy(&head, bytes.data() + at, sizeof head);
        const auto call = static_cast<Call>(head.call);
        const bool sets = call == Call::create || call == Call::set_settings || call == Call::add_cloth ||
                          call == Call::set_cloth_settings;
        if (!sets && head.bytes > 0) found.push_back(at);
        at += sizeof head + head.bytes;
    }
    return found;
}

}  // namespace weft::fuzz
