#include "demo/study/contact/rung.h"

namespace weft::study {

const char* name_of(Rung rung) {
    switch (rung) {
        case Rung::off:
            return "off";
        case Rung::avoidance:
            return "avoidance";
        case Rung::contact:
            return "contact";
    }
    return "";
}

void set_rung(ClothSettings& settings, Rung rung) {
    settings.self_collision.enabled = rung != Rung::off;
    settings.self_collision.method =
        rung == Rung::contact ? SelfCollisionMethod::contact : SelfCollisionMethod::avoidance;
}

}  // namespace weft::study
