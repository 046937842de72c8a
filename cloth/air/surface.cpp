#include "cloth/air/surface.h"

#include <utility>

#include "cloth/surface/normals.h"

namespace weft {

Surface::Surface(const ClothModel& model) : cells_(model) {
    if (!cells_.empty()) return;
    groups_ = TriangleGroups(model);
    rows_ = AlignedBuffer<Vec4>(groups_.rows);
}

Surface::Surface(const ClothModel& model, TriangleGroups&& saved) : cells_(model) {
    if (!cells_.empty()) return;
    groups_ = std::move(saved);
    rows_ = AlignedBuffer<Vec4>(groups_.rows, unmade);
}

void Surface::compute_normals(Parallel& parallel, std::span<const Vec4> positions, std::span<Vec4> normals) {
    if (!cells_.empty()) {
        weft::compute_normals(parallel, cells_, positions, normals);
        return;
    }
    compute_area_normals(parallel, groups_, positions, rows_.span());
    is_behind_ = false;
    weft::compute_normals(parallel, groups_, rows_.span(), normals);
}

void Surface::compute_air_forces(Parallel& parallel, const ClothInAir& cloth, bool keeps_normals,
                                 std::span<Vec4> forces) {
    if (!cells_.empty()) return weft::compute_air_forces(parallel, cells_, cloth, forces);
    if (!keeps_normals || is_behind_) compute_area_normals(parallel, groups_, cloth.positions, rows_.span());
    is_behind_ = false;
    weft::compute_air_forces(parallel, groups_, cloth, rows_.span(), forces);
}

void AirForce::linearise(Parallel& parallel, std::span<const Vec4> velocities, bool keeps_normals) const {
    if (surface == nullptr) return;
    ClothInAir at = cloth;
    at.velocities = velocities;
    surface->compute_air_forces(parallel, at, keeps_normals, forces);
}

}  // namespace weft
