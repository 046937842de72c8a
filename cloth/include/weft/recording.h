#pragma once
// Recordings: all calls by which a host changes a World, and a hash of the state after each step. The same
// steps can be taken again elsewhere and compared; weft_replay does so for a file.
//
// A file is little-endian: a mark, a version, and records, each with its own checksum. A library with another
// layout refuses recordings by their version. The same calls give the same bytes with the same binary only
// (World::state_hash).

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "weft/error.h"
#include "weft/export.h"

namespace weft {

/// Destination of a recording in place of a file: the host's own memory, or a socket. It must last until
/// World::stop_recording(), or longer than the World, whose end writes the end of the recording.
struct RecordingSink {
    /// Writes the next bytes, a record at most, on the thread of the recorded call. Returning false ends the
    /// recording: there are no more calls, and World::stop_recording() returns the error. Must not throw.
    bool (*write)(void* user, std::span<const std::byte> bytes) = nullptr;
    void* user = nullptr;  ///< passed to `write`
};

/// The first step after which the state differs from the recorded one.
struct ReplayDifference {
    std::uint64_t step = 0;  ///< as StepReport::step counts
    /// The first cloth that differs: its place among all that were added, from 0. None: what a World has
    /// besides differs, colliders, bodies, shapes or the wind's path.
    std::optional<std::uint32_t> cloth{};
};

/// Result of a replay.
struct Replay {
    std::uint64_t steps = 0;  ///< steps taken; the last is the one that differs, if any does
    std::uint64_t calls = 0;  ///< other calls made
    /// Whether the recording ends with stop_recording() or the World's end. False: it breaks off, as after a
    /// crash; all complete records were replayed.
    bool is_whole = false;
    std::optional<ReplayDifference> difference{};
};

struct ReplayOptions {
    int threads = 0;  ///< replaces the recorded WorldSettings::threads
};

/// Makes the recorded World and takes its steps, until one differs. Errors, by the number of the record: a
/// file that cannot be read, is none of Weft's, of another version, or damaged; a call that the World
/// refuses, but accepted when it was recorded.
[[nodiscard]] WEFT_API Result<Replay> replay(const std::filesystem::path& file,
                                             const ReplayOptions& options = {});
[[nodiscard]] WEFT_API Result<Replay> replay(std::span<const std::byte> recording,
                                             const ReplayOptions& options = {});

}  // namespace weft
