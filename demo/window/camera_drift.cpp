#include "demo/window/camera_drift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "demo/hands/project.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float margin = 0.04f;   // left beside the box, in picture heights
constexpr float farthest = 1.5f;  // way that the camera follows, in picture heights
constexpr float lag = 1.2f;       // [s]

bool same_view(const render::OrbitCamera& a, const render::OrbitCamera& b) {
    return to_vector(a.target) == to_vector(b.target) && a.distance == b.distance && a.yaw == b.yaw &&
           a.pitch == b.pitch && a.shift == b.shift && a.shrink == b.shrink;
}

/// How far [least, most] is outside of the allowed range. What is too long for it is put in the middle.
float outside(float least, float most, float allowed_least, float allowed_most) {
    const float before = std::min(least - allowed_least, 0.0f), after = std::max(most - allowed_most, 0.0f);
    if (before < 0 && after > 0) return 0.5f * (before + after);
    return before + after;
}

}  // namespace

Bounds bounds_of_cloth(const Simulation& simulation) {
    constexpr float far = std::numeric_limits<float>::max();
    Bounds all{{far, far, far}, {-far, -far, -far}};
    for (const SceneCloth& cloth : simulation.content().cloths) {
        const Bounds box = simulation.world().cloth(cloth.id).value().bounds;
        all.lower = {std::min(all.lower.x, box.lower.x), std::min(all.lower.y, box.lower.y),
                     std::min(all.lower.z, box.lower.z)};
        all.upper = {std::max(all.upper.x, box.upper.x), std::max(all.upper.y, box.upper.y),
                     std::max(all.upper.z, box.upper.z)};
    }
    return all;
}

std::optional<CameraDrift::Extent> CameraDrift::extent_of(const Bounds& cloth, float aspect,
                                                          const render::OrbitCamera& camera) {
    Extent extent{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (int corner = 0; corner < 8; ++corner) {
        const auto place =
            project(camera,
                    {corner & 1 ? cloth.upper.x : cloth.lower.x, corner & 2 ? cloth.upper.y : cloth.lower.y,
                     corner & 4 ? cloth.upper.z : cloth.lower.z},
                    aspect);
        if (!place) return std::nullopt;
        extent.least = {std::min(extent.least.x, place->x), std::min(extent.least.y, place->y)};
        extent.most = {std::max(extent.most.x, place->x), std::max(extent.most.y, place->y)};
    }
    return extent;
}

void CameraDrift::update(const Bounds& cloth, float aspect, float seconds, render::OrbitCamera& camera) {
    const bool given = !same_view(camera, seen_) || aspect != seen_aspect_;
    idle_ += seconds;
    if (idle_ > idle_after) {
        camera.orbit(turn_rate * seconds, 0);
        home_.yaw = camera.yaw;
    }
    if (given) {
        home_ = camera;
        offset_ = {};
        allowed_ = {{margin, margin}, {aspect * (1 - camera.shift) - margin, 1 - margin}};
    }
    if (const auto extent = extent_of(cloth, aspect, home_)) {
        if (given) {
            allowed_.least = {std::min(allowed_.least.x, extent->least.x),
                              std::min(allowed_.least.y, extent->least.y)};
            allowed_.most = {std::max(allowed_.most.x, extent->most.x),
                             std::max(allowed_.most.y, extent->most.y)};
        }
        const float right = outside(extent->least.x, extent->most.x, allowed_.least.x, allowed_.most.x);
        const float down = outside(extent->least.y, extent->most.y, allowed_.least.y, allowed_.most.y);
        const float part = 1 - std::exp(-seconds / lag);
        offset_.x += part * (std::clamp(right, -farthest, farthest) - offset_.x);
        offset_.y += part * (std::clamp(-down, -farthest, farthest) - offset_.y);
    }
    camera.target = home_.target;
    camera.pan(offset_.x, offset_.y);
    seen_ = camera;
    seen_aspect_ = aspect;
}

}  // namespace weft::demo
