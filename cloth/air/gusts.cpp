#include "cloth/air/gusts.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/air/gusts.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/memory/aligned_buffer.h"
#include "engine/simd/packed_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

using Bits = hn::Vec<hn::RebindToUnsigned<Tag>>;

HWY_INLINE Bits set_bits(std::uint32_t value) {
    return hn::Set(hn::RebindToUnsigned<Tag>(), value);
}
HWY_INLINE Lanes set(float value) {
    return hn::Set(Tag(), value);
}
HWY_INLINE Lanes3 set(const Vector3& v) {
    return {set(v.x()), set(v.y()), set(v.z())};
}

/// A vector with components uniform in 0, 1, .. 1023, for a lattice point.
HWY_INLINE Lanes3 lattice_value(Bits point, Bits seed) {
    Bits bits = hn::Mul(hn::Xor(point, seed), set_bits(0x2C1B3C6Du));
    bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<12>(bits)), set_bits(0x297A2D39u));
    bits = hn::Xor(bits, hn::ShiftRight<15>(bits));
    const auto number = [](Bits ten) {
        const hn::RebindToSigned<Tag> integers;
        return hn::ConvertTo(Tag(), hn::BitCast(integers, hn::And(ten, set_bits(0x3FFu))));
    };
    return {number(bits), number(hn::ShiftRight<10>(bits)), number(hn::ShiftRight<20>(bits))};
}

/// Blends neighbouring lattice values with two continuous derivatives (Perlin 2002, "Improving noise").
HWY_INLINE Lanes fade(Lanes t) {
    const Lanes polynomial = hn::MulAdd(t, hn::MulAdd(t, set(6), set(-15)), set(10));
    return hn::Mul(hn::Mul(hn::Mul(t, t), t), polynomial);
}

/// The lattice planes on either side along one axis, as bits of a point, and the weight of the second.
struct Cell {
    Bits near, far;
    Lanes weight;
};
template <int kShift>
HWY_INLINE Cell cell_of(Lanes coordinate) {
    const Lanes floor = hn::Floor(coordinate);
    const Bits number =
        hn::BitCast(hn::RebindToUnsigned<Tag>(), hn::ConvertTo(hn::RebindToSigned<Tag>(), floor));
    const Bits wrap = set_bits(WindField::period - 1);
    return {hn::ShiftLeft<kShift>(hn::And(number, wrap)),
            hn::ShiftLeft<kShift>(hn::And(hn::Add(number, set_bits(1)), wrap)),
            fade(hn::Sub(coordinate, floor))};
}

/// Value noise, between 0 and 1023 in each component.
HWY_INLINE Lanes3 value_noise(const Lanes3& p, std::uint32_t seed) {
    const Bits seed_bits = set_bits(seed * 0x9E3779B1u);
    const Cell x = cell_of<0>(p.x), y = cell_of<8>(p.y), z = cell_of<16>(p.z);
    const auto blended = [](Lanes t, const Lanes3& near, const Lanes3& far) {
        return mul_add(t, far - near, near);
    };
    const auto along_x = [&](Bits yz) {
        return blended(x.weight, lattice_value(hn::Or(x.near, yz), seed_bits),
                       lattice_value(hn::Or(x.far, yz), seed_bits));
    };
    const auto along_y = [&](Bits z_bits) {
        return blended(y.weight, along_x(hn::Or(y.near, z_bits)), along_x(hn::Or(y.far, z_bits)));
    };
    return blended(z.weight, along_y(z.near), along_y(z.far));
}

/// The factor to unit variance for value_noise in [-1, 1] plus half of a second octave:
/// 1 / sqrt(1.25 * 1/3 * s^3), s = 181/231 being the mean of fade(t)^2 + fade(1 - t)^2 over a cell.
constexpr float to_unit_variance = 2.2333f;

void sample_block(const WindField& field, const BlockRange& range, const Vec4* points, Vec4* velocities) {
    const Lanes3 mean = set(field.mean), middle = set(Vector3::Constant(-1023.0f / 2));
    std::span<const WindField::Octave> octaves = field.octaves;
    if (field.amplitude == 0) octaves = {};
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 point = unpacked(load_packed(points + i));
        Lanes3 velocity = mean;
        float amplitude = field.amplitude * to_unit_variance * (2.0f / 1024);
        for (const WindField::Octave& octave : octaves) {
            const Lanes3 place = mul_add(set(octave.scale), point, set(octave.offset));
            velocity = mul_add(set(amplitude), value_noise(place, octave.seed) + middle, velocity);
            amplitude *= 0.5f;
        }
        store_packed(packed(velocity, set(0)), velocities + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(sample_block);

namespace {

/// Converts metres to lattice coordinates in [0, period), in double before the cast.
float lattice_offset(double metres, float scale) {
    const double cells =
        std::fmod(metres * static_cast<double>(scale), static_cast<double>(WindField::period));
    return static_cast<float>(cells < 0 ? cells + WindField::period : cells);
}

}  // namespace

WindField::WindField(const Wind& wind, const std::array<double, 3>& carried, double time)
    : mean(to_vector(wind.velocity)), amplitude(wind.gust * mean.norm()), octaves{} {
    // The octaves drift apart at a tenth of the wind's speed, across it, so that the pattern never repeats as
    // it passes.
    const double drift = 0.1 * static_cast<double>(mean.norm()) * time;
    for (std::uint32_t o = 0; o < octaves.size(); ++o) {
        const float scale = static_cast<float>(o + 1) / wind.gust_length;
        const double rise = o == 0 ? drift : -drift;
        octaves[o] = {
            .scale = scale,
            .offset = {lattice_offset(-carried[0], scale), lattice_offset(-carried[1] + rise, scale),
                       lattice_offset(-carried[2], scale)},
            .seed = wind.seed * 2 + o};
    }
}

void WindField::sample(Parallel& parallel, std::span<const Vec4> points, std::span<Vec4> velocities) const {
    parallel.ranges(static_cast<std::uint32_t>(points.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(sample_block)(*this, range, points.data(), velocities.data());
        // The padding behind the last point stays 0.
        for (std::uint32_t i = range.end; i % AlignedBuffer<Vec4>::group != 0; ++i) velocities.data()[i] = {};
    });
}

}  // namespace weft
#endif
