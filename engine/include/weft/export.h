#pragma once
/* Symbols that Weft's library exports, as a shared library or as part of another one. C and C++.
   WEFT_SHARED is defined by the build of Weft as a shared library, and by builds that link it (by weft::weft
   and weft.pc); WEFT_BUILDING by the former alone. */

#if defined(WEFT_SHARED) && defined(_WIN32)
#if defined(WEFT_BUILDING)
#define WEFT_API __declspec(dllexport)
#else
#define WEFT_API __declspec(dllimport)
#endif
#elif defined(WEFT_SHARED) && defined(__GNUC__)
#define WEFT_API __attribute__((visibility("default")))
#else
#define WEFT_API
#endif

/* A class within an exported one, whose own symbols stay in the library. */
#if defined(__GNUC__) && !defined(_WIN32)
#define WEFT_LOCAL __attribute__((visibility("hidden")))
#else
#define WEFT_LOCAL
#endif
