#include "demo/study/contact/contact_scenes.h"

#include <algorithm>
#include <iterator>

namespace weft::study {

std::vector<SceneMaker> all_contact_scenes() {
    std::vector<SceneMaker> all = demo::contact_scenes();
    std::ranges::move(garment_scenes(), std::back_inserter(all));
    return all;
}

}  // namespace weft::study
