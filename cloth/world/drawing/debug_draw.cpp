#include "cloth/world/drawing/debug_draw.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cloth/simulation/simulation.h"
#include "cloth/world/drawing/pen.h"

namespace weft {

namespace {

constexpr Vec3 grey{0.6f, 0.6f, 0.6f}, red{1, 0.15f, 0.1f}, green{0.2f, 0.9f, 0.3f}, blue{0.2f, 0.4f, 1},
    yellow{1, 0.85f, 0.1f}, violet{0.8f, 0.2f, 1};

Vec3 mixed(const Vec3& a, const Vec3& b, float part) {
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

Vec3 colour_of(float strain) {
    constexpr float full = 0.05f;
    return mixed(grey, strain > 0 ? red : blue, std::min(std::abs(strain) / full, 1.0f));
}

void draw_strain(const Pen& pen, const Cloth& cloth) {
    const ClothModel& model = cloth.model;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const Vector3 from = xyz(cloth.state.positions[i]);
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j < i || model.kinds[e] != SpringKind::structural) continue;
            const Vector3 to = xyz(cloth.state.positions[j]);
            pen.line(from, to, colour_of((to - from).norm() / model.rest_lengths[e] - 1));
        }
    }
}

void draw_velocities(const Pen& pen, const Cloth& cloth) {
    constexpr float frame = 1.0f / 60;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 from = xyz(cloth.state.positions[i]);
        pen.line(from, from + frame * xyz(cloth.state.velocities[i]), green);
    }
}

void draw_pins(const Pen& pen, const Cloth& cloth) {
    const float length = 0.5f * cloth.model.info.mean_edge;
    for (const Pin& pin : cloth.state.pins) {
        const Vector3 at = xyz(cloth.state.positions[pin.particle]);
        pen.cross(at, length, yellow);
        if (at != pin.target) pen.line(at, pin.target, yellow);
    }
}

void draw_tangles(const Pen& pen, const Cloth& cloth) {
    if (cloth.state.may_cross == 0) return;
    const float length = 0.5f * cloth.model.info.mean_edge;
    for (std::uint32_t i = 0; i < cloth.state.tangles.size(); ++i)
        if (cloth.state.tangles[i].name != 0) pen.cross(xyz(cloth.state.positions[i]), length, violet);
}

void draw_normals(const Pen& pen, const Cloth& cloth) {
    const float length = 0.5f * cloth.model.info.mean_edge;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 from = xyz(cloth.state.positions[i]);
        pen.line(from, from + length * xyz(cloth.state.normals[i]), blue);
    }
}

void draw_leashes(const Pen& pen, const Cloth& cloth) {
    const SkinState& skin = cloth.state.skin;
    if (skin.known == 0) return;
    const AlignedBuffer<float>&leash = cloth.worn.leash, &backstop = cloth.worn.backstop;
    const float mark = 0.25f * cloth.model.info.mean_edge;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 place = xyz(skin.places[i]), at = xyz(cloth.state.positions[i]);
        if (leash.size() > 0 && std::isfinite(leash[i])) {
            const float used = leash[i] > 0 ? (at - place).norm() / leash[i] : 1.0f;
            pen.line(place, at, mixed(green, red, std::min(used, 1.0f)));
        }
        if (backstop.size() > 0 && std::isfinite(backstop[i]))
            pen.cross(place - backstop[i] * xyz(skin.normals[i]), mark, violet);
    }
}

/// The particle at which a node of a coarse level lies.
std::uint32_t particle_of_node(const Multigrid& levels, std::size_t level, std::uint32_t node) {
    for (std::size_t k = level + 1; k-- > 0;) node = levels.level(k).interpolation().kept[node];
    return node;
}

void draw_levels(const Pen& pen, const Cloth& cloth) {
    const Multigrid* const levels = cloth.solver->multigrid();
    if (levels == nullptr) return;
    const std::size_t count = levels->levels();
    for (std::size_t k = 0; k < count; ++k) {
        const float part = static_cast<float>(k + 1) / static_cast<float>(count);
        const float length = 0.5f * static_cast<float>(k + 1) * cloth.model.info.mean_edge;
        const auto nodes = static_cast<std::uint32_t>(levels->level(k).interpolation().kept.size());
        for (std::uint32_t node = 0; node < nodes; ++node)
            pen.cross(xyz(cloth.state.positions[particle_of_node(*levels, k, node)]), length,
                      mixed(blue, red, part));
    }
}

void draw_cost(const Pen& pen, const Simulation& simulation, ClothId id, const Cloth& cloth) {
    const ClothReport report = simulation.report_of(cloth);
    std::array<char, 96> words{};
    std::snprintf(words.data(), words.size(), "cloth %u: %.3f of %.3f ms", id.index,
                  static_cast<double>(report.milliseconds),
                  static_cast<double>(simulation.report.milliseconds));
    pen.text(to_vector(cloth.extent.lower), words.data(), yellow);
}

void draw_box(const Pen& pen, ClothId id, const Cloth& cloth) {
    const bool on = cloth.settings.enabled, asleep = cloth.is_asleep();
    const Vec3 colour = !on ? grey : asleep ? blue : green;
    pen.box({cloth.extent.lower, cloth.extent.upper}, colour);
    std::array<char, 96> words{};
    std::snprintf(words.data(), words.size(), "cloth %u: %u particles, %s", id.index,
                  cloth.model.particle_count,
                  !on      ? "off"
                  : asleep ? "asleep"
                           : "awake");
    pen.text(to_vector(cloth.extent.upper), words.data(), colour);
}

// The line's length [m] is the root of the impulse [N s], so that weak contacts are visible, too.
void draw_contact(const Pen& pen, const Contact& contact) {
    const float strength = std::sqrt(to_vector(contact.impulse).norm());
    const Vector3 at = to_vector(contact.point);
    pen.line(at, at + strength * to_vector(contact.normal), contact.collider == ColliderId{} ? red : yellow);
}

}  // namespace

void debug_draw(const Simulation& simulation, const DebugCanvas& canvas, DebugParts parts) {
    const Pen pen(canvas);
    Eigen::AlignedBox3f all;  // of all cloths
    simulation.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& cloth) {
        all.extend(to_vector(cloth->extent.lower)).extend(to_vector(cloth->extent.upper));
        if (has(parts, DebugParts::strain)) draw_strain(pen, *cloth);
        if (has(parts, DebugParts::velocities)) draw_velocities(pen, *cloth);
        if (has(parts, DebugParts::pins)) draw_pins(pen, *cloth);
        if (has(parts, DebugParts::tangles)) draw_tangles(pen, *cloth);
        if (has(parts, DebugParts::normals)) draw_normals(pen, *cloth);
        if (has(parts, DebugParts::leashes)) draw_leashes(pen, *cloth);
        if (has(parts, DebugParts::levels)) draw_levels(pen, *cloth);
        if (has(parts, DebugParts::costs)) draw_cost(pen, simulation, id, *cloth);
        if (has(parts, DebugParts::cloths)) draw_box(pen, id, *cloth);
    });
    if (has(parts, DebugParts::contacts))
        for (const Contact& contact : simulation.contacts()) draw_contact(pen, contact);
    if (!has(parts, DebugParts::colliders)) return;
    if (all.isEmpty()) all.extend(Vector3::Zero().eval());
    simulation.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        draw_collider(pen, slot.current, simulation.held_by(slot.current), all, grey);
    });
}

}  // namespace weft
