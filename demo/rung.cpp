#include "demo/rung.h"

namespace weft::demo {

const char* name_of(Rung rung) {
    switch (rung) {
        case Rung::off:
            return "off";
        case Rung::avoidance:
            return "avoidance";
        case Rung::impact_zones:
            return "impact-zones";
        case Rung::contact:
            return "contact";
    }
    return "";
}

Rung rung_of(const SelfCollision& settings) {
    if (!settings.enabled) return Rung::off;
    switch (settings.method) {
        case SelfCollisionMethod::avoidance:
            return Rung::avoidance;
        case SelfCollisionMethod::impact_zones:
            return Rung::impact_zones;
        case SelfCollisionMethod::contact:
            return Rung::contact;
    }
    return Rung::off;
}

void set_rung(SelfCollision& settings, Rung rung) {
    settings.enabled = rung != Rung::off;
    if (rung != Rung::impact_zones) settings.restitution = 0;
    if (!settings.enabled) return;
    settings.method = rung == Rung::contact        ? SelfCollisionMethod::contact
                      : rung == Rung::impact_zones ? SelfCollisionMethod::impact_zones
                                                   : SelfCollisionMethod::avoidance;
}

}  // namespace weft::demo
