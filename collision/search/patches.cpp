#include "collision/search/patches.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace weft {

namespace {

constexpr std::size_t region_size = std::size_t{16} * block_size;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Bounds nowhere{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

Bounds join(const Bounds& a, const Bounds& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::min(a.lower.z, b.lower.z)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y), std::max(a.upper.z, b.upper.z)}};
}

Boxes no_boxes() {
    Boxes boxes;
    for (std::uint32_t k = 0; k < 16; ++k) set_box(boxes, k, nowhere);
    return boxes;
}

/// The coordinate along which the particles are spread widest.
float Vec4::*widest(std::span<const std::uint32_t> particles, std::span<const Vec4> positions) {
    Bounds box = nowhere;
    for (const std::uint32_t i : particles) {
        const Vec3 p{positions[i].x, positions[i].y, positions[i].z};
        box = join(box, {p, p});
    }
    const std::array<float, 3> sides = {box.upper.x - box.lower.x, box.upper.y - box.lower.y,
                                        box.upper.z - box.lower.z};
    constexpr std::array<float Vec4::*, 3> coordinates = {&Vec4::x, &Vec4::y, &Vec4::z};
    return coordinates[static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin())];
}

/// Puts particles in order of patches: halves them across their widest side until sixteen are left (Bentley
/// 1975). The lower half is whole regions of sixteen blocks while there are as many, then whole blocks, then
/// whole patches, so that all of them are compact.
void cut(std::span<std::uint32_t> particles, std::span<const Vec4> positions) {
    if (particles.size() <= patch_size) {
        std::ranges::sort(particles);
        return;
    }
    const std::size_t whole = particles.size() > region_size  ? region_size
                              : particles.size() > block_size ? block_size
                                                              : patch_size;
    const std::size_t half = (particles.size() / 2 + whole - 1) / whole * whole;
    float Vec4::*const coordinate = widest(particles, positions);
    std::ranges::nth_element(particles, particles.begin() + static_cast<std::ptrdiff_t>(half),
                             [&](std::uint32_t i, std::uint32_t j) {
                                 const float a = positions[i].*coordinate, b = positions[j].*coordinate;
                                 return a < b || (a == b && i < j);
                             });
    cut(particles.first(half), positions);
    cut(particles.subspan(half), positions);
}

/// Sorts pieces of `size` particles by their lowest particles. An incomplete piece stays last.
void sort_pieces(std::span<std::uint32_t> particles, std::size_t size) {
    std::vector<std::pair<std::uint32_t, std::size_t>> pieces;  // first particle, where the piece begins
    for (std::size_t at = 0; at + size <= particles.size(); at += size)
        pieces.emplace_back(std::ranges::min(particles.subspan(at, size)), at);
    std::ranges::sort(pieces);
    const std::vector<std::uint32_t> before(particles.begin(), particles.end());
    for (std::size_t k = 0; k < pieces.size(); ++k)
        std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(pieces[k].second), size,
                    particles.begin() + static_cast<std::ptrdiff_t>(k * size));
}

/// Sorts regions, and the blocks within each, in the order of memory: a thread then reads particles that it
/// moved.
void follow_memory(std::span<std::uint32_t> particles) {
    sort_pieces(particles, region_size);
    for (std::size_t at = 0; at < particles.size(); at += region_size)
        sort_pieces(particles.subspan(at, std::min(region_size, particles.size() - at)), block_size);
}

}  // namespace

void order_in_patches(std::span<std::uint32_t> particles, std::span<const Vec4> rest_positions) {
    cut(particles, rest_positions);
    follow_memory(particles);
}

Patches::Patches(std::span<const Vec4> rest_positions)
    : particle_count_(static_cast<std::uint32_t>(rest_positions.size())),
      particles_(block_count(particle_count_) * block_size),
      patches_(block_count(particle_count_) * patches_per_block),
      patch_boxes_(block_count(particle_count_), no_boxes()),
      block_boxes_((patch_boxes_.size() + 15) / 16, no_boxes()),
      region_boxes_((block_boxes_.size() + 15) / 16, no_boxes()) {
    const std::span<std::uint32_t> particles = particles_.span().first(particle_count_);
    std::iota(particles.begin(), particles.end(), 0u);
    order_in_patches(particles, rest_positions);
}

void Patches::place(Parallel& parallel, std::span<const Vec4> positions) {
    parallel.ranges(particle_count_, [&](const BlockRange& range) {
        const Bounds box = place_block(positions, &particles_[range.begin], range.end - range.begin,
                                       &patches_[range.block * patches_per_block], patch_boxes_[range.block]);
        set_box(block_boxes_[range.block / 16], range.block % 16, box);
    });
    for (std::uint32_t k = 0; k < block_boxes_.size(); ++k)
        set_box(region_boxes_[k / 16], k % 16, hull(block_boxes_[k]));
}

PatchesView Patches::view() const noexcept {
    return {patches_, patch_boxes_, block_boxes_, region_boxes_, particles_.data()};
}

Bounds Patches::bounds() const noexcept {
    Bounds all = nowhere;
    for (const Boxes& boxes : region_boxes_) all = join(all, hull(boxes));
    return all;
}

std::size_t Patches::bytes() const noexcept {
    return particles_.bytes() + patches_.size() * sizeof(Patch) +
           (patch_boxes_.size() + block_boxes_.size() + region_boxes_.size()) * sizeof(Boxes);
}

}  // namespace weft
