#pragma once
/* What leaves Weft's library, shared or part of another. C and C++. WEFT_SHARED is defined by the build of
   Weft as a shared library, and by what links that (weft::weft and weft.pc say so); WEFT_BUILDING by the
   former alone. */

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

/* Of a class within one that leaves. */
#if defined(__GNUC__) && !defined(_WIN32)
#define WEFT_LOCAL __attribute__((visibility("hidden")))
#else
#define WEFT_LOCAL
#endif
