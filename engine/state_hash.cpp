#include "engine/state_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace weft {

struct StateHash::State {
    XXH3_state_t xxh3;
};

StateHash::StateHash() : state_(std::make_unique<State>()) {
    reset();
}
StateHash::~StateHash() = default;

void StateHash::reset() noexcept {
    XXH3_64bits_reset(&state_->xxh3);
}

std::uint64_t StateHash::value() const noexcept {
    return XXH3_64bits_digest(&state_->xxh3);
}

void StateHash::add_bytes(std::span<const std::byte> bytes) noexcept {
    XXH3_64bits_update(&state_->xxh3, bytes.data(), bytes.size());
}

}  // namespace weft
