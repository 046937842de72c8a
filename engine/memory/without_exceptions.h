#pragma once
// The edge of the interface, which no exception crosses, and what stands within it in place of try and catch:
// the library can be built without exceptions (WEFT_EXCEPTIONS=OFF). Then what would have thrown ends the
// process, memory that is not there above all.

#include <utility>

#include "weft/error.h"

namespace weft {

#ifdef __cpp_exceptions
inline constexpr bool has_exceptions = true;
#else
inline constexpr bool has_exceptions = false;
#endif

/// Thrown by what cannot return an Error, for the edge to hand to the host.
struct Refusal {
    Error error;
};
[[noreturn]] void refuse(Error error);
/// As operator new does.
[[noreturn]] void refuse_memory();

/// Runs `act`; memory or threads that could not be had become an error. So do those that the texts of its own
/// errors need.
template <class Act>
auto without_exceptions(const Act& act) noexcept -> decltype(act()) {
#ifdef __cpp_exceptions
    try {
        return act();
    } catch (Refusal& refusal) {
        return std::move(refusal.error);
    } catch (...) {
        return Error{ErrorCode::out_of_memory, "out of memory"};  // so short that it needs none
    }
#else
    return act();
#endif
}

/// Whether `act` came to its end; what it threw is dropped.
template <class Act>
[[nodiscard]] bool comes_through(const Act& act) noexcept {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (...) {
        return false;
    }
#else
    act();
#endif
    return true;
}

/// Runs `act`. If it throws `undo` runs, which must not, and the exception goes on.
template <class Act, class Undo>
void or_undo(const Act& act, [[maybe_unused]] const Undo& undo) {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (...) {
        undo();
        throw;
    }
#else
    act();
#endif
}

/// Runs `act`, and what it throws of this kind is dropped.
template <class Exception, class Act>
void ignoring(const Act& act) {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (const Exception&) {
    }
#else
    act();
#endif
}

}  // namespace weft
