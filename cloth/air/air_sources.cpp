#include "cloth/air/air_sources.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/air/air_sources.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/memory/aligned_buffer.h"
#include "engine/simd/packed_rows-inl.h"
#include "engine/vector.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

// Across a jet and a wake the speed falls as (1 + (sqrt(2) - 1) r^2 / b^2)^-2, b being the radius where it is
// half of that on the axis. A round jet of constant eddy viscosity has this profile (Schlichting 1979, XXIV).
constexpr float fall = 0.41421356f;
constexpr float spread_of_jet = 0.1f;  // growth of b per distance along the axis

/// A source as kernels read it, and points relative to it.
struct Source {
    explicit Source(const AirSource& source)
        : middle(source.position.x, source.position.y, source.position.z),
          velocity(source.velocity.x, source.velocity.y, source.velocity.z),
          speed(velocity.norm()),
          radius(source.radius),
          axis(Vector3::Zero()) {
        if (speed > 0) axis = velocity / speed;
    }
    Vector3 middle, velocity;
    float speed, radius;
    Vector3 axis;
};
struct Seen {
    Lanes3 way;                            // from the source's middle
    Lanes squared, ahead, squared_across;  // squared length; part along the axis; squared rest
};
HWY_INLINE Lanes3 set_vector(const Vector3& v) {
    return {set(v.x()), set(v.y()), set(v.z())};
}
HWY_INLINE Seen seen_from(const Source& source, const Lanes3& point) {
    const Lanes3 way = point - set_vector(source.middle);
    const Lanes squared = dot(way, way), ahead = dot(way, set_vector(source.axis));
    return {way, squared, ahead, hn::Max(hn::NegMulAdd(ahead, ahead, squared), hn::Zero(Tag()))};
}
HWY_INLINE Lanes between_0_and_1(Lanes value) {
    return hn::Min(hn::Max(value, hn::Zero(Tag())), set(1));
}
HWY_INLINE Lanes square(Lanes value) {
    return hn::Mul(value, value);
}

/// U (R / b) profile. The momentum, as b^2 times the square of the speed on the axis, is constant along it.
HWY_INLINE Lanes3 jet(const Source& source, const Seen& at) {
    const Lanes b = hn::MulAdd(set(spread_of_jet), hn::Max(at.ahead, hn::Zero(Tag())), set(source.radius));
    const Lanes share = hn::Div(square(b), hn::MulAdd(set(fall), at.squared_across, square(b)));
    const Lanes begins = between_0_and_1(hn::MulAdd(at.ahead, set(1 / source.radius), set(1)));
    const Lanes on_axis = hn::Div(set(source.speed * source.radius), b);
    return hn::Mul(hn::Mul(on_axis, square(share)), begins) * set_vector(source.axis);
}

HWY_INLINE Lanes3 blast(const Source& source, const Seen& at) {
    const Lanes beyond =
        hn::Div(set(source.radius * source.radius), hn::Mul(at.squared, hn::Sqrt(at.squared)));
    return hn::Mul(set(source.speed), hn::Min(set(1 / source.radius), beyond)) * at.way;
}

HWY_INLINE Lanes3 wake(const Source& source, const Seen& at) {
    const Lanes squared_radius = set(source.radius * source.radius);
    const auto is_outside = hn::Gt(at.squared, squared_radius);
    // Inside the ball these terms are not used, but they must be finite.
    const Lanes squared = hn::Max(at.squared, squared_radius);
    const Lanes dipole =
        hn::Div(hn::Mul(set(0.5f * source.radius), squared_radius), hn::Mul(squared, hn::Sqrt(squared)));
    const Lanes along = hn::Div(hn::Mul(set(3 * source.speed), at.ahead), squared);
    const Lanes3 around = dipole * (along * at.way - set_vector(source.velocity));
    const Lanes behind = hn::Max(hn::Neg(at.ahead), hn::Zero(Tag()));
    const Lanes squared_b = hn::Mul(set(source.radius), hn::Add(set(source.radius), behind));
    const Lanes share = hn::Div(squared_b, hn::MulAdd(set(fall), at.squared_across, squared_b));
    const Lanes begins = between_0_and_1(hn::Mul(behind, set(1 / source.radius)));
    const Lanes follows = hn::Mul(hn::Mul(hn::Div(squared_radius, squared_b), square(share)), begins);
    return either(is_outside, mul_add(follows, set_vector(source.velocity), around),
                  set_vector(source.velocity));
}

HWY_INLINE Lanes3 air_of(AirSourceKind kind, const Source& source, const Seen& at) {
    switch (kind) {
        case AirSourceKind::jet:
            return jet(source, at);
        case AirSourceKind::blast:
            return blast(source, at);
        case AirSourceKind::wake:
            return wake(source, at);
        case AirSourceKind::none:
            break;
    }
    return zero3();
}

void add_air_to_block(const Wind& wind, const BlockRange& range, const Vec4* points, Vec4* velocities) {
    for (const AirSource& source : wind.sources) {
        if (source.kind == AirSourceKind::none) continue;
        const Source read(source);
        for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
            const Seen at = seen_from(read, unpacked(load_packed(points + i)));
            const Lanes3 air = air_of(source.kind, read, at);
            store_packed(load_packed(velocities + i) + packed(air, set(0)), velocities + i);
        }
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(add_air_to_block);

void add_air_of_sources(Parallel& parallel, const Wind& wind, std::span<const Vec4> points,
                        std::span<Vec4> velocities) {
    parallel.ranges(static_cast<std::uint32_t>(points.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(add_air_to_block)(wind, range, points.data(), velocities.data());
        // The padding behind the last point stays 0.
        for (std::uint32_t i = range.end; i % AlignedBuffer<Vec4>::group != 0; ++i) velocities.data()[i] = {};
    });
}

}  // namespace weft
#endif
