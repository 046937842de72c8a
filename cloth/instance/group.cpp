#include "cloth/instance/group.h"

#include <memory>

#include "cloth/instance/cloth.h"

namespace weft {

void Group::lay_out(Scratch& scratch, std::size_t count) {
    scratch.take_few(cloths, count);
    scratch.take_few(featured, count);
    scratch.take_few(bodies, count);
    scratch.take_few(equations, count);
    scratch.take_few(steps, count);
    scratch.take_few(members, count);
    scratch.take_few(residuals, count);
}

void Group::add_featured(std::span<Cloth* const> group) {
    for (Cloth* cloth : group) {
        if (!cloth->has_features()) continue;
        std::construct_at(&bodies[featured_count], cloth->as_body());
        featured[featured_count++] = cloth;
    }
}

std::size_t scratch_bytes(const ContactMesh* mesh, bool by_zones) noexcept {
    Scratch scratch;
    Group alone;
    alone.lay_out(scratch, 1);
    const ContactCloth body{.mesh = mesh, .by_zones = by_zones};
    if (mesh != nullptr) alone.contact.lay_out(scratch, std::span(&body, 1), nullptr);
    return scratch.bytes();
}

}  // namespace weft
