#if !(__cplusplus > 201703L || (defined(_MSVC_LANG) && _MSVC_LANG > 201703L))
#error \
    "Weft's C++ interface needs C++20 (-std=c++20, /std:c++20). Older C++ and C take weft/weft_c.h, which has all of it."
#endif
#pragma once
// Weft: real-time cloth for games. This header is all that an embedder includes; it needs the standard
// library only.
//
//   auto world = weft::World::create();
//   auto mesh  = weft::make_sheet();
//   auto cloth = world->add_cloth(*mesh);
//   world->pin(*cloth, 0);
//   for (;;) {
//       world->step(1.0f / 60.0f);
//       const weft::ClothView view = *world->cloth(*cloth);
//       upload(view.positions);  // x y z w, sixteen bytes a particle, no copy
//   }

#include "weft/body.h"
#include "weft/cloth_id.h"
#include "weft/collider.h"
#include "weft/contact.h"
#include "weft/cooked_cloth.h"
#include "weft/cutting.h"
#include "weft/debug_draw.h"
#include "weft/drawn_mesh.h"
#include "weft/error.h"
#include "weft/executor.h"
#include "weft/fabrics.h"
#include "weft/filling.h"
#include "weft/fixed_step.h"
#include "weft/hooks.h"
#include "weft/maps.h"
#include "weft/mesh.h"
#include "weft/numbers.h"
#include "weft/profile.h"
#include "weft/proxy.h"
#include "weft/query.h"
#include "weft/recording.h"
#include "weft/report.h"
#include "weft/seam.h"
#include "weft/self_collision.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/types.h"
#include "weft/version.h"
#include "weft/vertex_streams.h"
#include "weft/world.h"
