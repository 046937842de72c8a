#pragma once
// The stages of a step, as the profiler names them.

#include <array>
#include <cstdint>

#include "engine/profiling/profiler.h"

namespace weft {

enum class Stage : std::uint32_t {
    cloths,
    wind,
    assemble,
    coarse_operators,
    solve,
    cycles,
    advance,
    limits,
    self_search,
    self_response,
    colliders,
    guard,
    normals
};
/// The stages' names and depths in the tree, each after the stage that it is part of.
inline constexpr std::array stage_names{
    StageName{"cloths", 1},    //
    StageName{"wind", 2},      //
    StageName{"assemble", 2},  //
    StageName{"coarse operators", 3},
    StageName{"solve", 2},          //
    StageName{"cycles", 3},         //
    StageName{"advance", 2},        //
    StageName{"limits", 2},         //
    StageName{"self search", 2},    //
    StageName{"self response", 2},  //
    StageName{"colliders", 2},      //
    StageName{"guard", 2},          //
    StageName{"normals", 2},
};

}  // namespace weft
