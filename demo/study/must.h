#pragma once
// Turns the library's errors into exceptions, which stop the study.

#include <stdexcept>
#include <utility>

#include "weft/error.h"

namespace weft::study {

/// The result's value. Throws std::runtime_error with the error's message if there is none.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(result).value();
}
inline void must(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace weft::study
