#include "demo/export/point_cache.h"

#include <bit>
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

}  // namespace weft::demo
