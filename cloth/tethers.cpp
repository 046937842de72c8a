#include "cloth/tethers.h"

#include "engine/vector.h"

namespace weft {

void LongRangeAttachments::attach(const CookedCloth& model, std::span<const std::uint32_t> pins) {
    geodesics_.march(model, pins);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        pins_[i] = geodesics_.sources()[i];
        lengths_[i] = static_cast<float>(geodesics_.distances()[i]);
    }
}

void LongRangeAttachments::hold(Parallel& parallel, float slack, std::span<Vec4> positions,
                                std::span<Vec4> velocities) const {
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            if (pins_[i] == Geodesics::none || positions[i].w == 0) continue;
            const Vector3 pin = xyz(positions[pins_[i]]), apart = xyz(positions[i]) - pin;
            const float limit = slack * lengths_[i], squared = apart.squaredNorm();
            if (!(squared > limit * limit)) continue;
            const Vector3 away = apart / std::sqrt(squared);
            set_xyz(positions[i], pin + limit * away);
            const Vector3 velocity = xyz(velocities[i]);
            const float leaving = away.dot(velocity - xyz(velocities[pins_[i]]));
            if (leaving > 0) set_xyz(velocities[i], velocity - leaving * away);
        }
    });
}

}  // namespace weft
