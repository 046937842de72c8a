#include "demo/export/sequence.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace weft::demo {

namespace {

static_assert(std::endian::native == std::endian::little, "PC2 files are little-endian");
static_assert(sizeof(Vec3) == 3 * sizeof(float));

constexpr std::streamoff samples_at = 28;  // offset in the header [bytes]

template <class T>
void put(std::ofstream& stream, const T& value) {
    stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

PointCache::PointCache(std::filesystem::path file, std::ofstream stream, std::size_t points)
    : file_(std::move(file)), stream_(std::move(stream)), points_(points) {}

Result<PointCache> PointCache::create(const std::filesystem::path& file, std::size_t points) {
    if (points > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        return Error{ErrorCode::invalid_argument, file.string() + ": " + std::to_string(points) +
                                                      " points are more than a PC2 file can hold"};
    std::ofstream stream(file, std::ios::binary);
    stream.write("POINTCACHE2", 12);
    put(stream, std::int32_t{1});
    put(stream, static_cast<std::int32_t>(points));
    put(stream, 0.0f);
    put(stream, 1.0f);
    put(stream, std::int32_t{0});
    PointCache cache(file, std::move(stream), points);
    if (auto written = cache.written(); !written) return written.error();
    return cache;
}

Result<void> PointCache::add(std::span<const Vec3> points) {
    if (points.size() != points_)
        return Error{ErrorCode::invalid_argument, file_.string() + ": a sample has " +
                                                      std::to_string(points.size()) +
                                                      " points; it must have " + std::to_string(points_)};
    stream_.write(reinterpret_cast<const char*>(points.data()),
                  static_cast<std::streamsize>(points.size_bytes()));
    ++samples_;
    return written();
}

Result<void> PointCache::close() {
    stream_.seekp(samples_at);
    put(stream_, samples_);
    stream_.flush();
    return written();
}

Result<void> PointCache::written() const {
    if (stream_) return {};
    return Error{ErrorCode::file_not_found, file_.string() + " cannot be written"};
}

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
