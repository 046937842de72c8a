#pragma once
// The scenes of the study of contact: those that the demo shows, and garments.

#include <vector>

#include "demo/scenes/contact/contact_scene.h"
#include "demo/self_collision.h"

namespace weft::study {

using demo::ContactScene;
using demo::name_of;
using demo::PlacedCloth;
using demo::quick_contact_particles;
using demo::SceneHandles;
using demo::SceneMaker;
using demo::self_collision_methods;

/// Garments hung up and swung.
[[nodiscard]] std::vector<SceneMaker> garment_scenes();
/// All scenes, in the order of the table.
[[nodiscard]] std::vector<SceneMaker> all_contact_scenes();

}  // namespace weft::study
