#pragma once
// Timed stages as zones of the Tracy profiler, if the build asks for it (WEFT_TRACY); otherwise no code at
// all.

#ifdef WEFT_TRACY

#include <tracy/TracyC.h>
#include <cstring>

namespace weft {

inline constexpr bool with_tracy = true;

/// A zone that lasts as long as the object, on its thread's line.
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

/// Steps form a set of frames of their own, beside the host's.
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
