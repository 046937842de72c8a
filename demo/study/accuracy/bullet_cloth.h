#pragma once
// Bullet's soft body as a method of the study, where Bullet is installed.

#include <memory>

#include "demo/study/run.h"

namespace weft::study {

/// A btSoftBody of the cloth's particles, masses and positions, its structural and shear springs as links.
/// `iterations`: of positions, a step.
[[nodiscard]] std::unique_ptr<Peer> make_bullet_cloth(const StudyScene& scene, const Cloth& cloth,
                                                      int iterations);

}  // namespace weft::study
