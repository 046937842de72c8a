#include <algorithm>
#include <iterator>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

std::vector<SceneMaker> contact_scenes() {
    std::vector<SceneMaker> all;
    for (const auto family :
         {fold_scenes, stack_scenes, drape_scenes, forced_scenes, meeting_scenes, tangle_scenes})
        std::ranges::move(family(), std::back_inserter(all));
    return all;
}

}  // namespace weft::demo
