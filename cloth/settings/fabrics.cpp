#include "weft/fabrics.h"

#include <algorithm>
#include <array>
#include <string>

namespace weft {

namespace {

Fabric fabric(float areal_density, float warp, float weft, float shear, float bending) {
    Fabric result;
    result.areal_density = areal_density;
    result.warp = warp;
    result.weft = weft;
    result.shear = shear;
    result.bending = bending;
    return result;
}

const std::array<NamedFabric, 9> all{{
    {"cotton", fabric(0.092f, 1675, 338, 40, 2.2e-6f),
     "a measured cotton voile, whose publication is not known; shear is a guess"},
    {"light-jacket", fabric(0.113f, 295.6f, 114.8f, 30.6f, 4.7e-6f),
     "Wang et al. 2011, tango-red-jet-set: 100 % polyester"},
    {"t-shirt", fabric(0.187f, 281.2f, 83.9f, 34.0f, 5.44e-6f),
     "Wang et al. 2011, gray-interlock: 60 % cotton, 40 % polyester; their fit of shear fails in two of six "
     "samples"},
    {"tablecloth", fabric(0.128f, 2126, 2090, 39.6f, 7.77e-6f),
     "Wang et al. 2011, white-dots-on-blk: 100 % polyester"},
    {"silk", fabric(0.106f, 588, 1035, 30, 1.3e-5f),
     "a measured cupro lining in silk's place, whose publication is not known; shear is a guess"},
    {"flag", fabric(0.079f, 6571, 3560, 150, 1.7e-5f),
     "a measured polyester dobby, whose publication is not known; shear is a guess"},
    {"denim", fabric(0.324f, 1048.4f, 223.3f, 69.4f, 1.81e-5f),
     "Wang et al. 2011, 11oz-black-denim: 99 % cotton, 1 % elastane"},
    {"trousers", fabric(0.220f, 2129, 2094, 59.0f, 4.27e-5f),
     "Wang et al. 2011, royal-target: 65 % cotton, 35 % polyester"},
    {"leather", fabric(0.560f, 7000, 7000, 2800, 2.9e-4f),
     "no source: a sheet of 0.7 mm, 800 kg/m^3 and 10 MPa, all three guessed"},
}};

}  // namespace

std::span<const NamedFabric> fabrics() noexcept {
    return all;
}

Result<Fabric> Fabric::named(std::string_view name) {
    const auto found = std::ranges::find_if(all, [&](const NamedFabric& each) { return name == each.name; });
    if (found != all.end()) return found->fabric;
    std::string message("there is no fabric ");
    message.append(name).append("; there are");
    for (const NamedFabric& each : all) message.append(&each == &all.front() ? " " : ", ").append(each.name);
    return Error{ErrorCode::invalid_argument, message};
}

}  // namespace weft
