#pragma once
// Hashes of a World's state, whole and by parts.

#include <utility>

#include "cloth/store/parts.h"
#include "engine/state_hash.h"

namespace weft {

struct HashVisitor {
    static constexpr bool skips_defaults = true;
    StateHash& hash;

    template <class T, std::size_t extent>
    void operator()(std::span<T, extent> part) const {
        hash.add(part);
    }
    template <class Head>
    void head(const Head& /*head*/) const {}
};

[[nodiscard]] inline std::uint64_t hash_of(const Cloth& cloth, StateHash& hasher) {
    hasher.reset();
    for_each_part(std::as_const(cloth.state), HashVisitor{hasher});
    return hasher.value();
}

/// Hash of all state except that of cloths.
[[nodiscard]] inline std::uint64_t hash_of_rest(const Simulation& simulation, StateHash& hasher) {
    hasher.reset();
    const HashVisitor visit{hasher};
    for_each_part(simulation.state, visit);
    simulation.shapes.for_each([&](ShapeId, const std::unique_ptr<HeldShape>& shape) {
        for_each_part(std::as_const(*shape), visit);
    });
    return hasher.value();
}

}  // namespace weft
