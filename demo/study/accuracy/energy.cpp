#include "demo/study/accuracy/energy.h"

#include <vector>

#include "cloth/fabric/membrane.h"

namespace weft::study {

Energy energy_of(const Cloth& cloth, const Vec3& gravity) {
    const ClothModel& model = cloth.model;
    const Fabric& fabric = cloth.settings.fabric;
    std::vector<float> stiffness(model.neighbours.size());
    spring_stiffness(model, fabric, stiffness);
    const Eigen::Vector3d g = to_vector(gravity).cast<double>();
    Energy energy;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const Eigen::Vector3d x = xyz(cloth.state.positions[i]).cast<double>();
        const Eigen::Vector3d v = xyz(cloth.state.velocities[i]).cast<double>();
        const auto mass = static_cast<double>(cloth.mass(i));
        if (cloth.state.positions[i].w > 0) energy.kinetic += mass * v.squaredNorm() / 2;
        energy.gravity -= mass * g.dot(x);
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j < i) continue;  // each spring is stored at both ends
            const double length = (xyz(cloth.state.positions[j]).cast<double>() - x).norm();
            const double extension = length - static_cast<double>(model.rest_lengths[e]);
            const double k = static_cast<double>(stiffness[e]);
            const double bending =
                static_cast<double>(fabric.bending) * static_cast<double>(model.bending[e]);
            energy.elastic += (k * extension * extension + bending * length * length) / 2;
        }
    }
    return energy;
}

}  // namespace weft::study
