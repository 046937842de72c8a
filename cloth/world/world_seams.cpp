// The public World: seams.

#include <string>
#include <utility>

#include "cloth/record/world_calls.h"
#include "cloth/settings/fields.h"
#include "cloth/settings/validate.h"

namespace weft {

Result<void> validate_for_seams(const ClothSettings& settings) {
    const char* const method =
        std::visit([](const auto& kind) { return struct_name(kind); }, settings.method);
    if (!std::holds_alternative<Multilevel>(settings.method))
        return Error{ErrorCode::invalid_argument,
                     std::string("the method ") + method +
                         " has no stitches in its equation; a cloth with seams needs Multilevel"};
    if (has_zones(settings.self_collision))
        return Error{ErrorCode::invalid_argument,
                     "by SelfCollisionMethod::impact_zones cloths are not solved together; a cloth with "
                     "seams needs SelfCollisionMethod::contact"};
    return {};
}

namespace {

Error at_stitch(std::size_t k, const std::string& why) {
    return {ErrorCode::invalid_argument, "stitch " + std::to_string(k) + ": " + why};
}

/// The seam of these vertices. Error: see World::stitch().
Result<SeamState> make_seam(const Simulation& simulation, std::array<ClothId, 2> ids,
                            std::array<std::span<const std::uint32_t>, 2> vertices,
                            const SeamSettings& settings) {
    if (auto valid = validate(settings); !valid) return valid.error();
    const std::size_t count = vertices[0].size();
    if (count != vertices[1].size() || count == 0)
        return Error{ErrorCode::invalid_argument, std::to_string(count) +
                                                      " vertices of the first cloth and " +
                                                      std::to_string(vertices[1].size()) +
                                                      " of the second: give as many of each, at least one"};
    SeamState seam{.settings = settings, .cloths = ids, .stitches = {}, .holds = {}};
    seam.stitches.resize(count);
    seam.holds.assign(count, 1);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::unique_ptr<Cloth>* const found = simulation.cloths.find(ids[side]);
        if (found == nullptr) return stale_id("ClothId", ids[side]);
        if (auto valid = validate_for_seams((*found)->settings); !valid) return valid.error();
        if ((*found)->garment != no_garment)
            return Error{ErrorCode::invalid_argument,
                         "the cloth is a level of a garment, and would hold others while it waits; stitch "
                         "cloth without levels"};
        for (std::size_t k = 0; k < count; ++k) {
            const auto particle = particle_of(**found, vertices[side][k]);
            if (!particle) return at_stitch(k, particle.error().message);
            seam.stitches[k].particles[side] = *particle;
        }
    }
    if (ids[0] != ids[1]) return seam;
    for (std::size_t k = 0; k < count; ++k)
        if (const auto& [a, b] = seam.stitches[k].particles; a == b)
            return at_stitch(k, "vertices " + std::to_string(vertices[0][k]) + " and " +
                                    std::to_string(vertices[1][k]) + " are the same particle; join two");
    return seam;
}

}  // namespace

Result<SeamId> World::stitch(ClothId a, std::span<const std::uint32_t> vertices_a, ClothId b,
                             std::span<const std::uint32_t> vertices_b, const SeamSettings& settings) {
    return impl_->change(Call::stitch, a, vertices_a, b, vertices_b, settings)([&]() -> Result<SeamId> {
        auto seam = make_seam(impl_->simulation, {a, b}, {vertices_a, vertices_b}, settings);
        if (!seam) return seam.error();
        return impl_->simulation.add_seam(std::move(seam).value());
    });
}

Result<void> World::unstitch(SeamId id) {
    return impl_->change(Call::unstitch, id)([&]() -> Result<void> {
        if (impl_->simulation.state.seams.find(id) == nullptr) return stale_id("SeamId", id);
        impl_->simulation.remove_seams({&id, 1});
        return {};
    });
}

Result<SeamInfo> World::seam_info(SeamId id) const {
    return impl_->read("seam_info", [&]() -> Result<SeamInfo> {
        if (impl_->simulation.state.seams.find(id) == nullptr) return stale_id("SeamId", id);
        return impl_->simulation.info_of(id);
    });
}

}  // namespace weft
