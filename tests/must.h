#pragma once
// What a test cannot go on without.

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "weft/error.h"

namespace weft::test {

/// Fails the test that runs; the whole program where there are no exceptions.
[[noreturn]] inline void give_up(const std::string& why) {
#ifdef __cpp_exceptions
    throw std::runtime_error(why);
#else
    std::fprintf(stderr, "%s\n", why.c_str());
    std::abort();
#endif
}

/// The value; where there is none, the test fails with the error's message.
template <class T>
[[nodiscard]] T must(Result<T> result) {
    if (!result) give_up(result.error().message);
    return std::move(result).value();
}

}  // namespace weft::test
