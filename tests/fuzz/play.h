#pragma once
// Plays a script in a World and checks, after each call, what Weft promises.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/script.h"

namespace weft::fuzz {

/// Thrown by play() at the first promise that was not kept.
struct Failure {
    std::size_t operation;
    std::string what;
};

struct PlayOptions {
    std::optional<int> threads;          ///< in place of those that the script names, and of its executors
    std::optional<std::size_t> without;  ///< a cloth whose calls are left out
    bool checked = true;                 ///< false: fingerprints only
    /// Saves that an earlier play could restore, in ascending order; others were refused, since cloths had
    /// come and gone. Null: all are tried.
    const std::vector<std::size_t>* restored = nullptr;
    std::vector<std::byte>* recorded = nullptr;  ///< where the World is recorded; null: nowhere
};

/// Hashes of each cloth's positions and velocities after each operation; 0 for cloths that are not there.
using Fingerprints = std::vector<std::vector<std::uint64_t>>;

/// Where something was in a whole play, and how far it might have gone in each of its steps [m].
struct Reached {
    Vec3 lower{1, 1, 1}, upper{-1, -1, -1};  ///< empty: it was nowhere
};

/// The results of a play.
struct Played {
    Fingerprints fingerprints;
    std::vector<Reached> reached;       ///< by each cloth
    std::vector<std::size_t> restored;  ///< operations that took a save
};

[[nodiscard]] Played play(const Script& script, const PlayOptions& options = {});

/// Plays it as it is; with one thread, and with two; and without one of its cloths. All must agree.
void play_all_ways(const Script& script);

/// The operation that is being played, for whoever reports a crash.
[[nodiscard]] const std::size_t& present_operation() noexcept;

}  // namespace weft::fuzz
