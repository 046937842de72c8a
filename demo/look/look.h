#pragma once
// How things look and are looked into, as the panels set it and the program draws it.

#include <optional>
#include <string>

#include "demo/learn/comparison.h"
#include "demo/look/inside.h"
#include "demo/look/picture_times.h"
#include "demo/look/quality_choice.h"
#include "demo/look/recorder.h"

namespace weft::demo {

struct Look {
    QualityChoice quality;
    Inside inside;
    Recorder recorder;
    PictureTimes times;
    bool wants_picture = false;                   ///< to be saved
    bool wants_film = false;                      ///< recording is to begin or to end
    bool wants_save = false, wants_load = false;  ///< of settings, as settings_file says
    std::string settings_file = "weft-settings.json";
    std::optional<Comparison> comparison;
    bool wants_comparison = false;  ///< the scene begins anew with one
    Method compared = Xpbd{};
    Fairness fairness = Fairness::same_time;
    bool by_processor = false;  ///< pictures are drawn
    float text_size = 1;        ///< over the display's own
};

}  // namespace weft::demo
