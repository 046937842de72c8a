#include "demo/export/sequence.h"

#include <cstdio>

namespace weft::demo {

Result<Sequence> Sequence::begin(const Simulation& simulation, SequenceFormat format,
                                 const std::filesystem::path& folder) {
    Sequence sequence(format, folder);
    const Mesh mesh = current_mesh(simulation.world(), simulation.content());
    if (format == SequenceFormat::pc2) {
        if (auto saved = save_obj(folder / "sequence.obj", mesh); !saved) return saved.error();
        auto cache = PointCache::create(folder / "sequence.pc2", mesh.positions.size());
        if (!cache) return cache.error();
        sequence.cache_.emplace(std::move(*cache));
    }
    if (format == SequenceFormat::usd) {
        const auto& cloths = simulation.content().cloths;
        const render::FabricLook look = cloths.empty() ? render::FabricLook() : cloths.front().look;
        auto usd = UsdText::create(folder / "sequence.usda", mesh, look.front, look.roughness, 60);
        if (!usd) return usd.error();
        sequence.usd_.emplace(std::move(*usd));
    }
    if (auto written = sequence.write(mesh); !written) return written.error();
    return sequence;
}

Result<void> Sequence::add(const Simulation& simulation) {
    return write(current_mesh(simulation.world(), simulation.content()));
}

Result<void> Sequence::write(const Mesh& mesh) {
    if (usd_) return usd_->add(mesh.positions);
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06d.obj", frame_++);
    return cache_ ? cache_->add(mesh.positions) : save_obj(folder_ / name, mesh);
}

Result<void> Sequence::end() {
    if (usd_) return usd_->close();
    return cache_ ? cache_->close() : Result<void>();
}

}  // namespace weft::demo
