#include "render/view/light_frame.h"

#include <cmath>

namespace weft::render {

LightFrame fit_light(const Vector3& direction, const Box& casters, int texels) {
    constexpr float growth = 1.25f;
    const float enclosing = std::max(0.5f * casters.diagonal().norm(), 0.05f);
    const float radius = std::pow(growth, std::ceil(std::log(enclosing) / std::log(growth)));
    const float half_side = 1.05f * radius;  // the filter's taps stay inside

    const Vector3 up = std::abs(direction.y()) > 0.99f ? Vector3::UnitZ() : Vector3::UnitY();
    Matrix4f light_from_world = look_at(direction, Vector3::Zero(), up);
    const float texel = 2.0f * half_side / static_cast<float>(texels);
    const Vector3 center = (light_from_world * casters.center().homogeneous()).head<3>();
    light_from_world(0, 3) -= std::round(center.x() / texel) * texel;
    light_from_world(1, 3) -= std::round(center.y() / texel) * texel;
    light_from_world(2, 3) -= center.z();

    return {orthographic(half_side, -radius, radius) * light_from_world, 2.0f * half_side, 2.0f * radius};
}

}  // namespace weft::render
