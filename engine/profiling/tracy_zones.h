#pragma once
// The Tracy profiler's view of what is timed, where the build asks for it (WEFT_TRACY); nothing at all
// otherwise.

#ifdef WEFT_TRACY

#include <tracy/TracyC.h>
#include <cstring>

namespace weft {

inline constexpr bool with_tracy = true;

/// Shows its lifetime on its thread's line.
class TracyZone {
  public:
    explicit TracyZone(const char* name) noexcept
        : zone_(___tracy_emit_zone_begin_alloc(
              ___tracy_alloc_srcloc_name(__LINE__, __FILE__, sizeof __FILE__ - 1, name, std::strlen(name),
                                         name, std::strlen(name), 0),
              1)) {}
    ~TracyZone() { ___tracy_emit_zone_end(zone_); }
    TracyZone(const TracyZone&) = delete;
    TracyZone& operator=(const TracyZone&) = delete;

  private:
    TracyCZoneCtx zone_;
};

/// Steps are a set of frames of their own, beside the host's.
inline void tracy_begin_step() noexcept {
    TracyCFrameMarkStart("cloth step");
}
inline void tracy_end_step() noexcept {
    TracyCFrameMarkEnd("cloth step");
}

}  // namespace weft

#else

namespace weft {

inline constexpr bool with_tracy = false;

struct TracyZone {
    explicit TracyZone(const char*) noexcept {}
};
inline void tracy_begin_step() noexcept {}
inline void tracy_end_step() noexcept {}

}  // namespace weft

#endif
