#pragma once
// The edge of the interface, which no exception crosses.

#include <utility>

#include "weft/error.h"

namespace weft {

/// Thrown by what cannot return an Error, for the edge to hand to the host.
struct Refusal {
    Error error;
};

/// Runs `act`; memory or threads that could not be had become an error. So do those that the texts of its own
/// errors need.
template <class Act>
auto without_exceptions(const Act& act) noexcept -> decltype(act()) {
    try {
        return act();
    } catch (Refusal& refusal) {
        return std::move(refusal.error);
    } catch (...) {
        return Error{ErrorCode::out_of_memory, "out of memory"};  // so short that it needs none
    }
}

}  // namespace weft
