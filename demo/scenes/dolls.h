#pragma once
// Figures as solids of scenes, and limbs of figures within bodies of a few capsules without a skeleton.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "demo/character/figure/figure.h"
#include "demo/scene.h"

namespace weft::demo {

/// Colours of a figure.
struct Complexion {
    Vec3 skin, hair, shoe;
};
inline constexpr std::array<Complexion, 5> complexions{
    {{{0.52f, 0.30f, 0.20f}, {0.05f, 0.025f, 0.015f}, {0.05f, 0.05f, 0.06f}},
     {{0.58f, 0.36f, 0.25f}, {0.22f, 0.11f, 0.04f}, {0.20f, 0.05f, 0.04f}},
     {{0.24f, 0.12f, 0.07f}, {0.015f, 0.012f, 0.012f}, {0.30f, 0.26f, 0.20f}},
     {{0.40f, 0.22f, 0.13f}, {0.03f, 0.018f, 0.012f}, {0.04f, 0.05f, 0.12f}},
     {{0.60f, 0.39f, 0.29f}, {0.42f, 0.26f, 0.10f}, {0.05f, 0.05f, 0.06f}}}};

/// Clothes that are painted on a figure, under those that are cloth.
struct Suit {
    bool has_sleeves = true;  ///< covers the upper arms, besides trunk and legs
    Vec3 colour{0.07f, 0.08f, 0.10f};
};

/// A solid that shows a figure where `place` puts it, as one of the people: they differ in colour.
[[nodiscard]] SceneSolid figure_solid(const Figure& figure, std::size_t person,
                                      std::function<void(std::span<Vec3>, SolidMoment)> place,
                                      std::optional<Suit> suit = {});

/// A limb whose axes are the same at both ends.
[[nodiscard]] FigureLimb doll_limb(LimbKind kind, const TaperedCapsule& capsule,
                                   const Matrix3& axes = Matrix3::Identity());

/// Adds thigh and shin within a leg, from hip to ankle, and a shoe of that sole, from heel to toes. The axes
/// turn from an upright leg's.
void add_doll_leg(const TaperedCapsule& leg, const TaperedCapsule& sole, const Matrix3& axes,
                  std::vector<FigureLimb>& to);
/// Adds arm, forearm and hand within an arm, from shoulder to hand. `side`: 1 left, -1 right.
void add_doll_arm(const TaperedCapsule& arm, float side, std::vector<FigureLimb>& to);

}  // namespace weft::demo
