#pragma once
/* Which Weft this is, by semantic versioning (semver.org). C and C++.

   While the first number is 0, the second counts what a host has to look at: code that was written for 0.1.0
   compiles and runs with every 0.1.x. A shared library of 0.1.x takes the place of another of them without a
   new build, for C; in C++ both sides need the same compiler's library besides, and take the headers they
   were built with. Saves, recordings and cooked cloths have versions of their own, apart from this: what a
   library cannot read it refuses by its version, and does not misread. Those of one 0.x.* are read by all of
   it. */

#include "weft/export.h"

/* The build reads them from here. */
#define WEFT_VERSION_MAJOR 0
#define WEFT_VERSION_MINOR 1
#define WEFT_VERSION_PATCH 0
#define WEFT_VERSION_STRING "0.1.0"

/* One number that grows: 10000 major + 100 minor + patch. */
#define WEFT_VERSION (WEFT_VERSION_MAJOR * 10000 + WEFT_VERSION_MINOR * 100 + WEFT_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif
/* WEFT_VERSION of the library that runs: a host that was compiled with other headers compares it with its
 * own. */
WEFT_API int weft_version(void);
/* Likewise WEFT_VERSION_STRING. */
WEFT_API const char* weft_version_string(void);
#ifdef __cplusplus
}

namespace weft {
/// As weft_version().
inline int version() {
    return weft_version();
}
}  // namespace weft
#endif
