#pragma once
// The study stops where the library refuses what it asks for.

#include <stdexcept>
#include <utility>

#include "weft/error.h"

namespace weft::study {

/// Throws std::runtime_error with the refusal.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(result).value();
}
inline void must(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace weft::study
