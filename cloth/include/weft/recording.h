#pragma once
// Recordings: all that a host does to a World, and a fingerprint of what each step made of it, so that the
// same steps can be taken again elsewhere and be compared. weft_replay does so for a file.
//
// A file is little-endian: a mark, a version, and records, each with its own checksum. A library that lays
// recordings out otherwise refuses them by their version. What follows from the same calls has the same bytes
// with the same binary only (World::state_hash).

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "weft/error.h"
#include "weft/export.h"

namespace weft {

/// Where a recording goes, in place of a file: a host's own memory, or a socket. It must last until
/// World::stop_recording(), or longer than the World, which writes the end as it goes.
struct RecordingSink {
    /// Takes the next bytes, a record at most. False: it cannot, and is called no more; then
    /// World::stop_recording() says so. Called by the calls that are recorded, on their thread. Must not
    /// throw.
    bool (*write)(void* user, std::span<const std::byte> bytes) = nullptr;
    void* user = nullptr;  ///< handed back
};

/// The first step after which something has other bytes than it had.
struct ReplayDifference {
    std::uint64_t step = 0;  ///< as StepReport::step counts
    /// The first cloth that has: its place among all that were added, from 0. None: what a World has besides,
    /// colliders, bodies, shapes or the way of the wind.
    std::optional<std::uint32_t> cloth{};
};

/// What stepping a recording again came to.
struct Replay {
    std::uint64_t steps = 0;  ///< taken; the last is the one that differs, if any does
    std::uint64_t calls = 0;  ///< made besides
    /// It ends where stop_recording() or the World's end ended it. False: where it breaks off, as that of a
    /// program that crashed; all that is whole was replayed.
    bool is_whole = false;
    std::optional<ReplayDifference> difference{};
};

struct ReplayOptions {
    int threads = 0;  ///< as WorldSettings::threads, in place of those recorded
};

/// Makes the World that was recorded and takes its steps, until one differs. Errors, by the number of the
/// record: a file that cannot be read, is none of Weft's, of another version, or damaged; a call that the
/// World refuses, as it would not have when it was recorded.
[[nodiscard]] WEFT_API Result<Replay> replay(const std::filesystem::path& file,
                                             const ReplayOptions& options = {});
[[nodiscard]] WEFT_API Result<Replay> replay(std::span<const std::byte> recording,
                                             const ReplayOptions& options = {});

}  // namespace weft
