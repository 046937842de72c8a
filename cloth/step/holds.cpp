// Teleports of cloth to what holds it, after that has moved without the cloth: while the cloth was disabled,
// or before the host first set the skin.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "cloth/mesh/coordinates.h"
#include "cloth/settings/validate.h"
#include "cloth/simulation/simulation.h"
#include "engine/small_matrices.h"

namespace weft {

namespace {

using Vector3d = Eigen::Vector3d;

/// Distance from which a step brings cloth to what holds it, without a teleport [m].
constexpr float near_enough = 1e-3f;

/// A particle that is held, and its place.
struct Hold {
    std::uint32_t particle;
    Vector3d at;
};

bool is_limited(const WornLimits& worn, std::uint32_t particle) {
    const auto is_set = [&](const AlignedBuffer<float>& map) {
        return map.size() > 0 && map[particle] < std::numeric_limits<float>::infinity();
    };
    return is_set(worn.leash) || is_set(worn.backstop);
}

bool is_still(const Cloth& cloth, const Pin& pin) {
    return pin.target == xyz(cloth.state.positions[pin.particle]);
}

/// visit(particle, place) for particles with a fixed place: by pins, and by bodies where there is no pin.
template <class Visit>
void for_each_fixed(const Cloth& cloth, const WorldState& world, const Visit& visit) {
    for (const Pin& pin : cloth.state.pins) visit(pin.particle, pin.target);
    for (const Attachment& attached : cloth.attached) {
        const BodySlot* const body = world.bodies.find(attached.id);
        if (body != nullptr && cloth.state.positions[attached.particle].w > 0)
            visit(attached.particle, Vector3(pose_of(body->state) * attached.own));
    }
}

/// The least-squares rigid motion (Kabsch 1976). Where holds leave a rotation undetermined, as holds on one
/// line do, it is the smallest one, and preferably about the vertical.
RigidMotion fit(const ClothState& state, std::span<const Hold> holds) {
    const double share = 1 / static_cast<double>(holds.size());
    const auto from = [&](const Hold& hold) -> Vector3d {
        return xyz(state.positions[hold.particle]).cast<double>();
    };
    Vector3d before = Vector3d::Zero(), after = Vector3d::Zero();
    for (const Hold& hold : holds) {
        before += share * from(hold);
        after += share * hold.at;
    }
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    for (const Hold& hold : holds) products += share * (hold.at - after) * (from(hold) - before).transpose();
    const double open = 1e-6 * products.norm() + std::numeric_limits<double>::min();
    products += open * Vector3d(1, 2, 1).asDiagonal().toDenseMatrix();
    const SingularValues svd = singular_values(products);
    const double mirror = (svd.u * svd.v.transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d turn = svd.u * Vector3d(1, 1, mirror).asDiagonal() * svd.v.transpose();
    return {turn, after - turn * before};
}

}  // namespace

Result<std::optional<RigidMotion>> Simulation::motion_to_holds(Cloth& cloth, const SkinState& skin,
                                                               StillPins pins) {
    const ClothState& now = cloth.state;
    std::vector<Hold> holds;
    float farthest = 0;
    for_each_fixed(cloth, state, [&](std::uint32_t i, const Vector3& place) {
        const Pin* const pin = cloth.find_pin(i);
        if (pins == StillPins::go_along && pin != nullptr && is_still(cloth, *pin)) return;
        holds.push_back({i, place.cast<double>()});
        farthest = std::max(farthest, (place - xyz(now.positions[i])).norm());
    });
    const bool is_worn = skin.known != 0 && cloth.worn.has_limits();
    if (is_worn) {
        cloth.worn.begin(skin, 1, 1);
        farthest = std::max(farthest, cloth.worn.lag(serial, now.positions.span()).most);
        cloth.worn.begin(now.skin, 1, 1);
    }
    if (!(farthest > near_enough)) return std::optional<RigidMotion>();
    for (std::uint32_t i = 0; is_worn && i < now.size(); ++i)
        if (now.positions[i].w > 0 && is_limited(cloth.worn, i))
            holds.push_back({i, xyz(skin.target_places[i]).cast<double>()});
    const RigidMotion motion = fit(now, holds);
    const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle;
    for (std::size_t v = 0; v < particles.size(); ++v) {
        const Vec3 there = to_vec3(motion.point(xyz(now.positions[particles[v]])));
        if (is_within_reach(there)) continue;
        return validate_point(("vertex " + std::to_string(v) + " once at what holds it").c_str(), there)
            .error();
    }
    return std::optional(motion);
}

void Simulation::go_to_holds(Cloth& cloth, const RigidMotion& by, StillPins pins) {
    ClothState& now = cloth.state;
    for (Pin& pin : now.pins)
        if (pins == StillPins::go_along && is_still(cloth, pin)) pin.target = by.point(pin.target);
    move_alone(parallel, by, now);
    for_each_fixed(cloth, state, [&](std::uint32_t i, const Vector3& place) {
        set_xyz(now.positions[i], place);
        now.velocities[i] = {};
    });
    if (now.skin.known != 0 && cloth.worn.has_limits()) {
        cloth.worn.begin(now.skin, 1, 1);
        cloth.worn.hold(parallel, now.positions.span(), now.velocities.span());
    }
    std::ranges::copy(std::as_const(now.positions).span(), now.previous_positions.data());
    now.record.h = 0;  // the path breaks
    now.may_cross = cloth.has_features() ? 1 : 0;
    cloth.wake();
    cloth.land();
    update_normals(parallel, cloth);
    cloth.extent = survey(parallel, now, cloth.partial_surveys.span());
}

}  // namespace weft
