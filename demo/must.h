#pragma once
// Errors of the library as exceptions, where a program builds something large and reports one failure.

#include <stdexcept>
#include <utility>

#include "weft/error.h"

namespace weft::demo {

/// An Error, thrown.
struct Refusal : std::runtime_error {
    explicit Refusal(Error why) : std::runtime_error(why.message), error(std::move(why)) {}
    Error error;
};

/// The result's value. Throws Refusal if there is none.
template <class T>
T must(Result<T> result) {
    if (!result) throw Refusal(result.error());
    return std::move(result).value();
}
inline void must(const Result<void>& result) {
    if (!result) throw Refusal(result.error());
}

}  // namespace weft::demo

namespace weft::study {

using demo::must;

}  // namespace weft::study
