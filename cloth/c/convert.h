#pragma once
// Values for C into those of C++, and back.

#include <bit>
#include <optional>
#include <string>
#include <variant>

#include "cloth/c/errors.h"
#include "cloth/c/fields.h"
#include "cloth/c/sized.h"

namespace weft::c {

/// Of the same bytes: one of them for C.
template <class C, class Of>
inline constexpr bool are_alike = false;
template <>
inline constexpr bool are_alike<WeftVec3, Vec3> = true;
template <>
inline constexpr bool are_alike<WeftRotation, Rotation> = true;
template <>
inline constexpr bool are_alike<WeftTransform, Transform> = true;
template <>
inline constexpr bool are_alike<WeftBounds, Bounds> = true;
template <>
inline constexpr bool are_alike<WeftClothId, ClothId> = true;
template <>
inline constexpr bool are_alike<WeftColliderId, ColliderId> = true;
template <>
inline constexpr bool are_alike<WeftShapeId, ShapeId> = true;
template <>
inline constexpr bool are_alike<WeftBodyId, BodyId> = true;

/// What an enumeration that a host sets is called, and how many it has.
template <class Enum>
struct Enumerators;
template <>
struct Enumerators<SelfCollisionSearch> {
    static constexpr const char* name = "SelfCollision::search";
    static constexpr int count = WEFT_SEARCH_SORTED_SWEEP + 1;
};
template <>
struct Enumerators<SelfCollisionMethod> {
    static constexpr const char* name = "SelfCollision::method";
    static constexpr int count = WEFT_SELF_IMPACT_ZONES + 1;
};
template <>
struct Enumerators<ColliderResponse> {
    static constexpr const char* name = "ClothSettings::collider_response";
    static constexpr int count = WEFT_RESPONSE_VELOCITY_FILTER + 1;
};
template <>
struct Enumerators<TimeScheme> {
    static constexpr const char* name = "ClothSettings::time_scheme";
    static constexpr int count = WEFT_TIME_BDF2 + 1;
};
template <>
struct Enumerators<Fibres::SetSolver> {
    static constexpr const char* name = "a set solver of Fibres";
    static constexpr int count = WEFT_SET_LDLT + 1;
};
template <>
struct Enumerators<AirSourceKind> {
    static constexpr const char* name = "AirSource::kind";
    static constexpr int count = WEFT_AIR_WAKE + 1;
};
template <>
struct Enumerators<Map> {
    static constexpr const char* name = "map";
    static constexpr int count = WEFT_MAP_STIFFNESS + 1;
};
template <>
struct Enumerators<DescriptionFormat> {
    static constexpr const char* name = "format";
    static constexpr int count = WEFT_DESCRIBE_JSON + 1;
};

template <class Enum>
[[nodiscard]] Result<Enum> enumerator(std::int32_t value) {
    if (value < 0 || value >= Enumerators<Enum>::count)
        return out_of_choices(Enumerators<Enum>::name, value, Enumerators<Enum>::count);
    return static_cast<Enum>(value);
}

/// A way of fields(): for C to C++. Numbers that are no enumerators it keeps for error().
class ToWeft {
  public:
    template <class C, class Of>
    void operator()(const C& c, Of& of) const {
        if constexpr (std::is_same_v<Of, bool>) {
            of = c != 0;
        } else if constexpr (std::is_enum_v<Of>) {
            if (const Result<Of> known = enumerator<Of>(c))
                of = *known;
            else
                note(known.error());
        } else if constexpr (std::is_arithmetic_v<Of>) {
            static_assert(std::is_same_v<C, Of>);
            of = c;
        } else if constexpr (are_alike<C, Of>) {
            of = std::bit_cast<Of>(c);
        } else {
            fields(*this, c, of);
        }
    }
    template <class C, class... Kinds>
    void variant(const C& c, std::int32_t kind, std::variant<Kinds...>& of) const {
        std::int32_t number = 0;
        const bool is_one =
            ((number++ == kind && (fields(*this, c, of.template emplace<Kinds>()), true)) || ...);
        if (!is_one) note(out_of_choices("kind", kind, sizeof...(Kinds)));
    }
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    void note(const Error& error) const {
        if (!error_) error_ = error;
    }
    mutable std::optional<Error> error_;
};

/// A way of fields(): for C++ to C.
struct ToC {
    template <class C, class Of>
    void operator()(C& c, const Of& of) const {
        if constexpr (std::is_enum_v<Of> || std::is_same_v<Of, bool>) {
            c = static_cast<C>(of);
        } else if constexpr (std::is_arithmetic_v<Of>) {
            static_assert(std::is_same_v<C, Of>);
            c = of;
        } else if constexpr (are_alike<C, Of>) {
            c = std::bit_cast<C>(of);
        } else {
            fields(*this, c, of);
        }
    }
    template <class C, class... Kinds>
    void variant(C& c, std::int32_t& kind, const std::variant<Kinds...>& of) const {
        kind = static_cast<std::int32_t>(of.index());
        std::visit([&](const auto& one) { fields(*this, c, one); }, of);
    }
};

template <class C, class Of>
[[nodiscard]] C to_c(const Of& of) noexcept {
    C c{};
    ToC{}(c, of);
    return c;
}
template <class Of, class C>
[[nodiscard]] Result<Of> to_weft(const C& c) {
    Of of{};
    const ToWeft way;
    way(c, of);
    if (way.error()) return *way.error();
    return of;
}

/// What a host gave as a struct that may grow. Null: the defaults.
template <class Of, class C>
[[nodiscard]] Result<Of> take(const char* name, const C* from) {
    const Result<C> all = taken(name, from, to_c<C>(Of{}));
    if (!all) return all.error();
    return to_weft<Of>(*all);
}

/// What the library knows into such a struct.
template <class C, class Of>
[[nodiscard]] Result<void> hand(const char* name, const Result<Of>& value, C* to) {
    if (!value) return value.error();
    return fill(name, to_c<C>(*value), to);
}

[[nodiscard]] inline Transform transform_of(const WeftTransform* given) {
    return given == nullptr ? Transform{} : std::bit_cast<Transform>(*given);
}

}  // namespace weft::c
