#pragma once
/* The version of Weft, by semantic versioning (semver.org). C and C++.

   While the first number is 0, the second counts changes that a host has to look at: code that was written
   for 0.1.0 compiles and runs with every 0.1.x. A shared library of one 0.1.x can replace another without a
   new build, for C; in C++ both sides also need the same compiler's library, and keep the headers that they
   were built with. Saves, recordings and cooked cloths have versions of their own: a library refuses a
   version that it cannot read, and does not misread it. Every 0.x.* reads those of all with the same x. */

#include "weft/export.h"

/* The build reads the version from these lines. */
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
/* WEFT_VERSION_STRING of the library that runs. */
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
