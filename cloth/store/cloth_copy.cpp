// Copies of a cooked cloth, and the memory of each.

#include "cloth/instance/cloth.h"
#include "cloth/instance/make_solver.h"

namespace weft {

namespace {

std::size_t bytes_of(const ClothModel& model) {
    return model.positions.bytes() + model.rest_area.bytes() + model.stiffness.bytes() +
           model.spring_offsets.bytes() + model.neighbours.bytes() + model.rest_lengths.bytes() +
           model.kinds.bytes() + model.bending.bytes() + model.bending_excess.bytes() +
           model.corner_offsets.bytes() + model.corner_triangles.bytes() + model.triangles.bytes() +
           model.panel_sides.bytes() + model.component_offsets.bytes() + model.component_particles.bytes() +
           model.vertex_to_particle.bytes() + model.texcoords.bytes() + model.vertex_triangles.bytes();
}

}  // namespace

Cloth::Cloth(const Cloth& cooked)
    : model(cooked.model),
      settings(cooked.settings),
      state(cooked.state),
      solver(cooked.solver->clone(model)),
      scratch_velocities(model.particle_count),
      side_buffers(cooked.model.particle_count),
      bending_per_area(cooked.bending_per_area),
      self_contacts(cooked.self_contacts),
      rest_neighbours(cooked.rest_neighbours),
      contact_mesh(cooked.contact_mesh),
      shares_contact_mesh(contact_mesh != nullptr),
      surface(cooked.surface),
      partial_counts(block_count(model.particle_count)),
      partial_sums(block_count(model.particle_count)),
      partial_surveys(block_count(model.particle_count)) {
    side_buffers.write(settings);
    filling = cooked.filling;
    if (!solver) solver = make_solver(model, settings, state.positions.span());
    if (cooked.history) history.emplace();
    for (const std::unique_ptr<Limit>& limit : cooked.limits) limits.push_back(limit->clone());
    const SelfCollision& self_collision = settings.self_collision;
    if (pairs_in_equation(self_collision) > 0) reserve_pairs(*solver);
    take_features(make_features(self_collision), self_collision);
    scratch_bytes = scratch_of_steps(*solver, history.has_value(), settings, contact_mesh.get());
    take_contacts(make_contacts(false), false);
    const std::size_t of_cooked = cooked.own_bytes(), own = own_bytes();
    shared_bytes_ = of_cooked > own ? of_cooked - own : 0;
}

ClothInfo Cloth::info() const {
    ClothInfo info = model.info;
    double mass_sum = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) mass_sum += static_cast<double>(mass(i));
    info.mass = static_cast<float>(mass_sum);
    const float finest = 2 * info.mean_edge;
    info.least_bending = settings.fabric.areal_density * 9.81f * finest * finest * finest;
    info.bytes = own_bytes();
    info.shared_bytes = shared_bytes_;
    info.scratch_bytes = scratch_bytes;
    return info;
}

std::size_t Cloth::zone_bytes() const noexcept {
    if (!has_features() || !has_zones(settings.self_collision)) return 0;
    const std::size_t particles = FeatureContact::particles_of(*contact_mesh);
    return particles * ImpactZones::bytes_per_particle +
           FeatureContact::room_for_pairs(particles) * ImpactZones::bytes_per_pair;
}

std::size_t Cloth::own_bytes() const {
    std::size_t of_limits = worn.bytes() + side_buffers.bytes() + areas_without_map.bytes();
    for (const std::unique_ptr<Limit>& limit : limits) of_limits += limit->bytes();
    return sizeof *this + bytes_of(model) + state.bytes() + solver->bytes() + scratch_velocities.bytes() +
           of_limits + (self_contacts ? self_contacts->bytes() : 0) +
           (rest_neighbours ? rest_neighbours->bytes() : 0) + (contacts ? contacts->bytes() : 0) +
           scratch_bytes + zone_bytes() +
           (has_features() && !shares_contact_mesh ? contact_mesh->bytes() : 0) + surface.bytes() +
           air.forces.bytes() + air.velocities.bytes() + collider_impulses.bytes() +
           missing_impulses.bytes() + in_triggers.bytes() + part_start.bytes() +
           (whole ? whole->bytes() : 0) + body_buffers.bytes() +
           collected.capacity() * sizeof(CollectedShare) + seams.capacity() * sizeof(SeamRows*) + sewn.bytes +
           attached.capacity() * sizeof(Attachment) + partial_counts.bytes() + partial_sums.bytes() +
           partial_surveys.bytes() + (shown ? shown->bytes() : 0) + (budgeted ? sizeof(Budgeted) : 0);
}

}  // namespace weft
