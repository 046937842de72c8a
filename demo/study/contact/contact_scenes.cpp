#include <iterator>

#include "demo/study/contact/contact_scene.h"

namespace weft::study {

std::vector<SceneMaker> all_contact_scenes() {
    std::vector<SceneMaker> all;
    for (const auto family : {fold_scenes, stack_scenes, drape_scenes, forced_scenes, meeting_scenes,
                              tangle_scenes, garment_scenes})
        std::ranges::move(family(), std::back_inserter(all));
    return all;
}

}  // namespace weft::study
