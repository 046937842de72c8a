#include "demo/self_collision.h"

namespace weft::demo {

const char* name_of(SelfCollisionMethod method) {
    switch (method) {
        case SelfCollisionMethod::off:
            return "off";
        case SelfCollisionMethod::impact_zones:
            return "impact-zones";
        case SelfCollisionMethod::contact:
            return "contact";
        default:
            return "avoidance";
    }
}

void set_method(SelfCollision& settings, SelfCollisionMethod method) {
    settings.method = method;
    if (method != SelfCollisionMethod::impact_zones) settings.restitution = 0;
}

}  // namespace weft::demo
