#pragma once
// The scenes of the study of contact: those that the demo shows, and garments.

#include <vector>

#include "demo/rung.h"
#include "demo/scenes/contact/contact_scene.h"

namespace weft::study {

using demo::ContactScene;
using demo::name_of;
using demo::PlacedCloth;
using demo::quick_contact_particles;
using demo::Rung;
using demo::rungs;
using demo::SceneHandles;
using demo::SceneMaker;

/// Garments hung up and swung.
[[nodiscard]] std::vector<SceneMaker> garment_scenes();
/// All scenes, in the order of the table.
[[nodiscard]] std::vector<SceneMaker> all_contact_scenes();

}  // namespace weft::study
