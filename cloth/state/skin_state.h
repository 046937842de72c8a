#pragma once
// The skin that worn limits are measured from: state that changes from step to step.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

#include "engine/memory/aligned_buffer.h"
#include "weft/types.h"

namespace weft {

/// Each particle's place on the skin, now and at the end of the next step. Empty without limits.
struct SkinState {
    AlignedBuffer<Vec4> places, target_places;    ///< [m], w 0
    AlignedBuffer<Vec4> normals, target_normals;  ///< of unit length, w 0; empty without backstops
    std::uint32_t known = 0;                      ///< 1: the host has set places and normals

    /// The skin has arrived at its targets.
    void stand_still() noexcept {
        std::ranges::copy(std::as_const(target_places).span(), places.data());
        std::ranges::copy(std::as_const(target_normals).span(), normals.data());
    }
    /// The targets are where the skin is.
    void keep_still() noexcept {
        std::ranges::copy(std::as_const(places).span(), target_places.data());
        std::ranges::copy(std::as_const(normals).span(), target_normals.data());
    }
    [[nodiscard]] bool is_still() const noexcept {
        const auto is_same = [](const AlignedBuffer<Vec4>& a, const AlignedBuffer<Vec4>& b) {
            return a.size() == 0 || std::memcmp(a.data(), b.data(), a.bytes()) == 0;
        };
        return is_same(places, target_places) && is_same(normals, target_normals);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return places.bytes() + target_places.bytes() + normals.bytes() + target_normals.bytes();
    }
};

}  // namespace weft
