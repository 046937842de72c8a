#pragma once
// Stands in for Tracy's header of this name (0.11): what Weft uses of it, kept for the test.

#include <cstddef>
#include <cstdint>

struct TracyZoneContext {
    std::uint32_t id;
};
using TracyCZoneCtx = const TracyZoneContext;

std::uint64_t ___tracy_alloc_srcloc_name(std::uint32_t line, const char* source, std::size_t source_size,
                                         const char* function, std::size_t function_size, const char* name,
                                         std::size_t name_size, std::uint32_t color);
TracyCZoneCtx ___tracy_emit_zone_begin_alloc(std::uint64_t source_location, int active);
void ___tracy_emit_zone_end(TracyCZoneCtx zone);
void ___tracy_emit_frame_mark_start(const char* name);
void ___tracy_emit_frame_mark_end(const char* name);

#define TracyCFrameMarkStart(name) ___tracy_emit_frame_mark_start(name)
#define TracyCFrameMarkEnd(name) ___tracy_emit_frame_mark_end(name)
