// Each field of the C++ structs has its counterpart for C, which goes over and comes back; each enumerator
// its number.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "cloth/c/convert.h"
#include "cloth/settings/fields.h"

namespace weft::c {
namespace {

template <class T>
constexpr std::size_t lines_of() {
    T of{};
    std::size_t lines = 0;
    for_both(of, of, [&](const char* /*name*/, auto&, auto&, const auto&... /*range*/) { ++lines; });
    return lines;
}

/// Initialises any field.
struct Anything {
    template <class T>
    operator T() const;
};
/// Number of fields of an aggregate: so many initialisers it takes.
template <class T, class... Fields>
constexpr std::size_t fields_of() {
    if constexpr (requires { T{Fields{}..., Anything{}}; })
        return fields_of<T, Fields..., Anything>();
    else
        return sizeof...(Fields);
}

/// Is true if each field has its line in fields.h.
template <class... Structs>
constexpr bool are_listed = ((lines_of<Structs>() == fields_of<Structs>()) && ...);
static_assert(
    are_listed<Fabric, FiniteElements, Tethers, FrameInertia, SelfCollision, Filling, ClothSettings>);
static_assert(are_listed<Multilevel, Jacobi, Chebyshev, ConjugateGradient, Xpbd, Fibres, SymplecticEuler>);
static_assert(are_listed<AirSource, AirShelter, Wind, BodySettings, BodyState, SeamSettings, Transform>);
static_assert(are_listed<Sphere, Capsule, Plane, TaperedCapsule, Box, PlacedShape, Collider>);
static_assert(are_listed<SheetSettings, DrawnMeshSettings, FixedStepSettings>);
static_assert(are_listed<ClothReport, StepReport, ClothInfo, ShapeInfo, SeamInfo, FillingInfo, Bounds>);
static_assert(lines_of<WorldSettings>() + 1 == fields_of<WorldSettings>(), "the executor has no line");

/// Calls act(number) for each number that a value holds, in order.
template <class T, class Act>
void each_leaf(T& of, const Act& act);

template <class... Kinds, class Act>
void each_leaf_of(std::variant<Kinds...>& of, const Act& act) {
    std::visit([&](auto& one) { each_leaf(one, act); }, of);
}
template <class T, std::size_t size, class Act>
void each_leaf_of(std::array<T, size>& of, const Act& act) {
    for (T& one : of) each_leaf(one, act);
}
template <class T, class Act>
void each_leaf_of(T& of, const Act& act) {
    if constexpr (requires { of.index; })
        act(of.index), act(of.generation);
    else
        act(of.x), act(of.y), act(of.z);
    if constexpr (requires { of.w; }) act(of.w);
}
template <class T, class Act>
void each_leaf(T& of, const Act& act) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
        act(of);
    else if constexpr (HasFields<T>)
        for_each_field(of, [&](const char*, auto& field) { each_leaf(field, act); });
    else
        each_leaf_of(of, act);
}

template <class T>
std::vector<double> leaves(T of) {
    std::vector<double> all;
    each_leaf(of, [&](auto leaf) { all.push_back(static_cast<double>(leaf)); });
    return all;
}

/// The number of that place another one.
template <class T>
T changed(T of, std::size_t place) {
    std::size_t at = 0;
    each_leaf(of, [&](auto& leaf) {
        using Leaf = std::remove_reference_t<decltype(leaf)>;
        if (at++ != place) return;
        if constexpr (std::is_same_v<Leaf, bool>)
            leaf = !leaf;
        else if constexpr (std::is_enum_v<Leaf>)
            leaf = static_cast<Leaf>(1 - static_cast<int>(leaf));
        else
            leaf += 3;
    });
    return of;
}

/// Expects every field of a struct that a host sets to be converted there and back, without any other.
template <class C, class T>
void expect_both_ways(const T& of) {
    const std::vector<double> before = leaves(of);
    ASSERT_FALSE(before.empty());
    for (std::size_t place = 0; place < before.size(); ++place) {
        const T other = changed(of, place);
        const Result<T> back = to_weft<T>(to_c<C>(other));
        ASSERT_TRUE(back.ok()) << place;
        EXPECT_NE(leaves(*back), before) << "the field of number " << place << " has no counterpart";
        EXPECT_EQ(leaves(*back), leaves(other)) << place;
    }
}

/// Expects every field of a struct that a host reads to be converted, to a place of its own.
template <class C, class T>
void expect_one_way(const T& of) {
    const auto bytes_of = [](const C& c) { return std::string(reinterpret_cast<const char*>(&c), sizeof c); };
    std::set<std::string> all{bytes_of(to_c<C>(of))};
    const std::size_t count = leaves(of).size();
    for (std::size_t place = 0; place < count; ++place)
        EXPECT_TRUE(all.insert(bytes_of(to_c<C>(changed(of, place)))).second)
            << "the field of number " << place << " has no counterpart";
}

TEST(FieldsForC, GoOverAndComeBackOfAllThatAHostSets) {
    for (const Method& method :
         {Method(Multilevel{}), Method(Jacobi{}), Method(Chebyshev{}), Method(ConjugateGradient{}),
          Method(Xpbd{}), Method(Fibres{}), Method(SymplecticEuler{})}) {
        SCOPED_TRACE(method.index());
        expect_both_ways<WeftClothSettings>(ClothSettings{.method = method});
    }
    expect_both_ways<WeftWorldSettings>(WorldSettings{});
    for (const auto& shape :
         {Collider{.shape = Sphere{}}, Collider{.shape = Capsule{}}, Collider{.shape = Plane{}},
          Collider{.shape = TaperedCapsule{}}, Collider{.shape = Box{}}, Collider{.shape = PlacedShape{}}}) {
        SCOPED_TRACE(shape.shape.index());
        expect_both_ways<WeftCollider>(shape);
    }
    expect_both_ways<WeftBodySettings>(BodySettings{});
    expect_both_ways<WeftBodyState>(BodyState{});
    expect_both_ways<WeftSeamSettings>(SeamSettings{.break_force = 1});
    EXPECT_EQ(leaves(std::bit_cast<Transform>(std::bit_cast<WeftTransform>(changed(Transform{}, 6)))),
              leaves(changed(Transform{}, 6)));
}

TEST(FieldsForC, OfWhatNoTableHasGoOverToo) {
    const SheetSettings sheet =
        *to_weft<SheetSettings>(WeftSheetSettings{0, 2, 3, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}});
    EXPECT_EQ(sheet.rows, 2u);
    EXPECT_EQ(sheet.columns, 3u);
    EXPECT_EQ(leaves(sheet.origin), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(leaves(sheet.u), (std::vector<double>{7, 8, 9}));
    EXPECT_EQ(leaves(sheet.v), (std::vector<double>{10, 11, 12}));
    const DrawnMeshSettings drawn = *to_weft<DrawnMeshSettings>(WeftDrawnMeshSettings{0, 0.25f, 2});
    EXPECT_EQ(drawn.rounding, 0.25f);
    EXPECT_EQ(drawn.reach, 2);
    const ProxySettings proxy = *to_weft<ProxySettings>(WeftProxySettings{0, 77, 0.5f});
    EXPECT_EQ(proxy.particles, 77u);
    EXPECT_EQ(proxy.thickness, 0.5f);
    const FixedStepSettings clock = *to_weft<FixedStepSettings>(WeftFixedStepSettings{0, 7, 0.5});
    EXPECT_EQ(clock.max_steps_per_frame, 7);
    EXPECT_EQ(clock.step, 0.5);
}

TEST(FieldsForC, AreSeenOfAllThatAHostReads) {
    expect_one_way<WeftClothReport>(ClothReport{});
    expect_one_way<WeftStepReport>(StepReport{});
    expect_one_way<WeftClothInfo>(ClothInfo{});
    expect_one_way<WeftShapeInfo>(ShapeInfo{});
    expect_one_way<WeftSeamInfo>(SeamInfo{});
    expect_one_way<WeftFillingInfo>(FillingInfo{});
}

TEST(FieldsForC, RefuseWhatIsNoEnumerator) {
    WeftClothSettings settings = to_c<WeftClothSettings>(ClothSettings{});
    settings.self_collision.method = WEFT_SELF_AVOIDANCE_BY_SORTED_SWEEP + 1;
    const auto back = to_weft<ClothSettings>(settings);
    ASSERT_FALSE(back.ok());
    EXPECT_EQ(back.error().message, "SelfCollision::method is 6; it must be 0 to 5");
    settings = to_c<WeftClothSettings>(ClothSettings{});
    settings.method.kind = -1;
    EXPECT_FALSE(to_weft<ClothSettings>(settings).ok());
}

struct Grown {
    std::uint32_t struct_size;
    float old, young;
};

}  // namespace
// The first version of Grown had no `young`.
template <>
inline constexpr std::size_t first_size<Grown> = 8;
namespace {

TEST(StructSize, OfAnOlderHostLeavesWhatItDoesNotKnowAsByDefault) {
    const Grown defaults{0, 1, 2};
    Grown of_host{8, 5, 77};
    EXPECT_EQ(taken("grown", &of_host, defaults)->old, 5);
    EXPECT_EQ(taken("grown", &of_host, defaults)->young, 2);
    ASSERT_TRUE(fill("grown", Grown{0, 6, 7}, &of_host).ok());
    EXPECT_EQ(of_host.old, 6);
    EXPECT_EQ(of_host.young, 77) << "is not the host's memory";
    EXPECT_EQ(of_host.struct_size, 8u);
}

TEST(StructSize, ThatNoVersionHadIsRefused) {
    for (const std::uint32_t size : {0u, 7u, 13u}) {
        const Grown of_host{size, 5, 6};
        EXPECT_FALSE(taken("grown", &of_host, Grown{}).ok()) << size;
    }
    const Grown newer{16, 5, 6};
    EXPECT_NE(taken("grown", &newer, Grown{}).error().message.find("newer"), std::string::npos);
}

template <class Enum>
constexpr bool is(int number, Enum of) {
    return number == static_cast<int>(of);
}
static_assert(is(WEFT_INVALID_ARGUMENT - 1, ErrorCode::invalid_argument) &&
              is(WEFT_STALE_ID - 1, ErrorCode::stale_id) &&
              is(WEFT_INVALID_MESH - 1, ErrorCode::invalid_mesh) &&
              is(WEFT_FILE_NOT_FOUND - 1, ErrorCode::file_not_found) &&
              is(WEFT_MALFORMED_FILE - 1, ErrorCode::malformed_file) &&
              is(WEFT_OUT_OF_MEMORY - 1, ErrorCode::out_of_memory) &&
              is(WEFT_UNSUPPORTED - 1, ErrorCode::unsupported) &&
              is(WEFT_CANCELLED - 1, ErrorCode::cancelled));
static_assert(is(WEFT_SELF_OFF, SelfCollisionMethod::off) &&
              is(WEFT_SELF_CONTACT, SelfCollisionMethod::contact) &&
              is(WEFT_SELF_IMPACT_ZONES, SelfCollisionMethod::impact_zones) &&
              is(WEFT_SELF_AVOIDANCE, SelfCollisionMethod::avoidance) &&
              is(WEFT_SELF_AVOIDANCE_BY_SHIFTED_GRIDS, SelfCollisionMethod::avoidance_by_shifted_grids) &&
              is(WEFT_SELF_AVOIDANCE_BY_SORTED_SWEEP, SelfCollisionMethod::avoidance_by_sorted_sweep));
static_assert(is(WEFT_SET_GAUSS_SEIDEL, Fibres::SetSolver::gauss_seidel) &&
              is(WEFT_SET_LDLT, Fibres::SetSolver::ldlt));
static_assert(is(WEFT_TIME_OF_METHOD, TimeScheme::of_method) &&
              is(WEFT_TIME_BACKWARD_EULER, TimeScheme::backward_euler) &&
              is(WEFT_TIME_BDF2, TimeScheme::bdf2));
static_assert(is(WEFT_RESPONSE_CONTACT, ColliderResponse::contact) &&
              is(WEFT_RESPONSE_VELOCITY_FILTER, ColliderResponse::velocity_filter));
static_assert(is(WEFT_MAP_MASS, Map::mass) && is(WEFT_MAP_PIN, Map::pin) && is(WEFT_MAP_LEASH, Map::leash) &&
              is(WEFT_MAP_BACKSTOP, Map::backstop) && is(WEFT_MAP_BACKSTOP_RADIUS, Map::backstop_radius) &&
              is(WEFT_MAP_FRICTION, Map::friction) && is(WEFT_MAP_THICKNESS, Map::thickness) &&
              is(WEFT_MAP_STIFFNESS, Map::stiffness) && is(WEFT_MAP_COLLIDER_MASK, Map::collider_mask));
static_assert(is(WEFT_AIR_NONE, AirSourceKind::none) && is(WEFT_AIR_JET, AirSourceKind::jet) &&
              is(WEFT_AIR_BLAST, AirSourceKind::blast) && is(WEFT_AIR_WAKE, AirSourceKind::wake));
static_assert(is(WEFT_FILLING_NONE, FillingKind::none) && is(WEFT_FILLING_PRESSURE, FillingKind::pressure) &&
              is(WEFT_FILLING_GAS, FillingKind::gas) && is(WEFT_FILLING_VOLUME, FillingKind::volume));
static_assert(is(WEFT_SHELTER_NONE, AirShelterKind::none) && is(WEFT_SHELTER_BALL, AirShelterKind::ball) &&
              is(WEFT_SHELTER_BOX, AirShelterKind::box));
static_assert(is(WEFT_LOG_NOTE, LogLevel::note) && is(WEFT_LOG_WARNING, LogLevel::warning));
static_assert(is(WEFT_DESCRIBE_TEXT, DescriptionFormat::text) &&
              is(WEFT_DESCRIBE_JSON, DescriptionFormat::json));
static_assert(is(WEFT_DROP_NO_AREA, DropReason::no_area) && is(WEFT_DROP_DOUBLED, DropReason::doubled) &&
              is(WEFT_DROP_CROWDED_EDGE, DropReason::crowded_edge) &&
              is(WEFT_DROP_CROWDED_VERTEX, DropReason::crowded_vertex));
static_assert(is(WEFT_STEP_INVALID_DT, StepFlags::invalid_dt) &&
              is(WEFT_STEP_STATE_RESTORED, StepFlags::state_restored) &&
              is(WEFT_STEP_CONTACTS_DROPPED, StepFlags::contacts_dropped) &&
              is(WEFT_STEP_SPEED_LIMITED, StepFlags::speed_limited) &&
              is(WEFT_STEP_UNSOLVED, StepFlags::unsolved) &&
              is(WEFT_STEP_PINS_STOPPED, StepFlags::pins_stopped) &&
              is(WEFT_STEP_CROSSED, StepFlags::crossed) &&
              is(WEFT_STEP_UNDER_WAY, StepFlags::step_under_way));
static_assert(is(WEFT_DRAW_STRAIN, DebugParts::strain) && is(WEFT_DRAW_VELOCITIES, DebugParts::velocities) &&
              is(WEFT_DRAW_PINS, DebugParts::pins) && is(WEFT_DRAW_CONTACTS, DebugParts::contacts) &&
              is(WEFT_DRAW_COLLIDERS, DebugParts::colliders) && is(WEFT_DRAW_TANGLES, DebugParts::tangles) &&
              is(WEFT_DRAW_CLOTHS, DebugParts::cloths) && is(WEFT_DRAW_NORMALS, DebugParts::normals) &&
              is(WEFT_DRAW_LEASHES, DebugParts::leashes) && is(WEFT_DRAW_LEVELS, DebugParts::levels) &&
              is(WEFT_DRAW_COSTS, DebugParts::costs));
template <class Kind, class Variant>
constexpr bool is_kind(std::size_t number) {
    return Variant(Kind{}).index() == number;
}
static_assert(is_kind<Multilevel, Method>(WEFT_METHOD_MULTILEVEL) &&
              is_kind<Jacobi, Method>(WEFT_METHOD_JACOBI) &&
              is_kind<Chebyshev, Method>(WEFT_METHOD_CHEBYSHEV) &&
              is_kind<ConjugateGradient, Method>(WEFT_METHOD_CONJUGATE_GRADIENT) &&
              is_kind<Xpbd, Method>(WEFT_METHOD_XPBD) && is_kind<Fibres, Method>(WEFT_METHOD_FIBRES) &&
              is_kind<SymplecticEuler, Method>(WEFT_METHOD_SYMPLECTIC_EULER));
using Solid = decltype(Collider::shape);
static_assert(is_kind<Sphere, Solid>(WEFT_SPHERE) && is_kind<Capsule, Solid>(WEFT_CAPSULE) &&
              is_kind<Plane, Solid>(WEFT_PLANE) && is_kind<TaperedCapsule, Solid>(WEFT_TAPERED_CAPSULE) &&
              is_kind<Box, Solid>(WEFT_BOX) && is_kind<PlacedShape, Solid>(WEFT_PLACED_SHAPE));

// These structs are passed to C without a conversion.
#define SAME_PLACE(C, Of, field) static_assert(offsetof(C, field) == offsetof(Of, field))
SAME_PLACE(WeftContact, Contact, other_cloth);
SAME_PLACE(WeftContact, Contact, collider);
SAME_PLACE(WeftContact, Contact, particle);
SAME_PLACE(WeftContact, Contact, other_particle);
SAME_PLACE(WeftContact, Contact, point);
SAME_PLACE(WeftContact, Contact, normal);
SAME_PLACE(WeftContact, Contact, impulse);
SAME_PLACE(WeftBodyImpulse, BodyImpulse, linear);
SAME_PLACE(WeftBodyImpulse, BodyImpulse, angular);
SAME_PLACE(WeftStageTime, StageTime, depth);
SAME_PLACE(WeftStageTime, StageTime, last);
SAME_PLACE(WeftStageTime, StageTime, p50);
SAME_PLACE(WeftStageTime, StageTime, p95);
SAME_PLACE(WeftStageTime, StageTime, p99);
SAME_PLACE(WeftStageTime, StageTime, max);
SAME_PLACE(WeftStageTime, StageTime, samples);
SAME_PLACE(WeftTransform, Transform, rotation);
SAME_PLACE(WeftBounds, Bounds, upper);
SAME_PLACE(WeftWelded, CookReport::Welded, into);
SAME_PLACE(WeftDropped, CookReport::Dropped, why);
SAME_PLACE(WeftSoftened, CookReport::Softened, left);

}  // namespace
}  // namespace weft::c
