#pragma once
// Settings of the picture, as the panels set them and the program draws them.

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
    bool wants_picture = false;                   ///< a picture is to be saved
    bool wants_film = false;                      ///< recording is to begin or to end
    bool wants_save = false, wants_load = false;  ///< settings, to or from settings_file
    std::string settings_file = "weft-settings.json";
    std::optional<Comparison> comparison;
    bool wants_comparison = false;  ///< the scene is to restart with a comparison
    Method compared = Xpbd{};
    Fairness fairness = Fairness::same_time;
    bool by_processor = false;  ///< a processor draws the pictures
    float text_size = 1;        ///< factor on the display's own size
};

}  // namespace weft::demo
