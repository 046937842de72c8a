#pragma once
// What the guide's examples take from their host: demo/guide/README.md says what these do.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "weft/weft.h"

template <class T>
T need(weft::Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message.c_str());
        std::exit(1);
    }
    if constexpr (std::is_reference_v<T>)
        return *result;
    else if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

inline void draw(std::span<const weft::Vec4> positions, std::span<const weft::Triangle> triangles) {
    for (const weft::Vec4& p : positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    for (const weft::Triangle& corners : triangles)
        for (const std::uint32_t corner : corners) ASSERT_LT(corner, positions.size());
}
