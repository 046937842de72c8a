#include "demo/rung.h"

namespace weft::demo {

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

Rung rung_of(const SelfCollision& settings) {
    if (!settings.enabled) return Rung::off;
    return settings.method == SelfCollisionMethod::contact ? Rung::contact : Rung::avoidance;
}

void set_rung(SelfCollision& settings, Rung rung) {
    settings.enabled = rung != Rung::off;
    if (!settings.enabled) return;
    settings.method = rung == Rung::contact ? SelfCollisionMethod::contact : SelfCollisionMethod::avoidance;
}

}  // namespace weft::demo
