#pragma once
// The checksums of a recording, made right again after bytes were changed.

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "cloth/record/record_format.h"

namespace weft::fuzz {

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

/// Where records begin that a flipped bit makes take no longer: settings may ask for any number of passes.
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
