#pragma once
// Converts values for C to those of C++, and back.

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "cloth/c/errors.h"
#include "cloth/c/fields.h"
#include "cloth/c/sized.h"

namespace weft::c {

// Types that have the same bytes in C and C++.
Vec3 like(WeftVec3);
Rotation like(WeftRotation);
Transform like(WeftTransform);
Bounds like(WeftBounds);
ClothId like(WeftClothId);
ColliderId like(WeftColliderId);
ShapeId like(WeftShapeId);
BodyId like(WeftBodyId);
SeamId like(WeftSeamId);
template <class C, class Of>
concept Alike = requires(const C& c) {
    { like(c) } -> std::same_as<Of>;
};

/// Name of an enumeration that a host sets, and its number of values.
struct Choices {
    const char* name;
    int count;
};
// clang-format off
constexpr Choices choices(SelfCollisionMethod) { return {"SelfCollision::method", WEFT_SELF_AVOIDANCE_BY_SORTED_SWEEP + 1}; }
constexpr Choices choices(ColliderResponse) { return {"ClothSettings::collider_response", WEFT_RESPONSE_VELOCITY_FILTER + 1}; }
constexpr Choices choices(TimeScheme) { return {"ClothSettings::time_scheme", WEFT_TIME_BDF2 + 1}; }
constexpr Choices choices(Fibres::SetSolver) { return {"a set solver of Fibres", WEFT_SET_LDLT + 1}; }
constexpr Choices choices(AirSourceKind) { return {"AirSource::kind", WEFT_AIR_WAKE + 1}; }
constexpr Choices choices(AirShelterKind) { return {"AirShelter::kind", WEFT_SHELTER_BOX + 1}; }
constexpr Choices choices(FillingKind) { return {"Filling::kind", WEFT_FILLING_VOLUME + 1}; }
constexpr Choices choices(Map) { return {"map", WEFT_MAP_COLLIDER_MASK + 1}; }
constexpr Choices choices(DescriptionFormat) { return {"format", WEFT_DESCRIBE_JSON + 1}; }
// clang-format on

template <class Enum>
[[nodiscard]] Result<Enum> enumerator(std::int32_t value) {
    const Choices known = choices(Enum{});
    if (value < 0 || value >= known.count) return out_of_choices(known.name, value, known.count);
    return static_cast<Enum>(value);
}

/// A way for fields() from C to C++. It keeps numbers that are no enumerators for error().
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
        } else if constexpr (Alike<C, Of>) {
            of = std::bit_cast<Of>(c);
        } else {
            fields(*this, c, of);
        }
    }
    template <class... Kinds>
    void operator()(const WeftMethod& c, std::variant<Kinds...>& of) const {
        variant(c, c.kind, of);
    }
    template <class C, class Of, std::size_t size>
    void operator()(const C (&c)[size], std::array<Of, size>& of) const {
        for (std::size_t k = 0; k < size; ++k) (*this)(c[k], of[k]);
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

/// A way for fields() from C++ to C.
struct ToC {
    template <class C, class Of>
    void operator()(C& c, const Of& of) const {
        if constexpr (std::is_enum_v<Of> || std::is_same_v<Of, bool>) {
            c = static_cast<C>(of);
        } else if constexpr (std::is_arithmetic_v<Of>) {
            static_assert(std::is_same_v<C, Of>);
            c = of;
        } else if constexpr (Alike<C, Of>) {
            c = std::bit_cast<C>(of);
        } else {
            fields(*this, c, of);
        }
    }
    template <class... Kinds>
    void operator()(WeftMethod& c, const std::variant<Kinds...>& of) const {
        variant(c, c.kind, of);
    }
    template <class C, class Of, std::size_t size>
    void operator()(C (&c)[size], const std::array<Of, size>& of) const {
        for (std::size_t k = 0; k < size; ++k) (*this)(c[k], of[k]);
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

/// Converts a host's struct that may grow. Null: the defaults.
template <class Of, class C>
[[nodiscard]] Result<Of> take(const char* name, const C* from) {
    const Result<C> all = taken(name, from, to_c<C>(Of{}));
    if (!all) return all.error();
    return to_weft<Of>(*all);
}

/// Converts a value into such a struct.
template <class C, class Of>
[[nodiscard]] Result<void> hand(const char* name, const Result<Of>& value, C* to) {
    if (!value) return value.error();
    return fill(name, to_c<C>(*value), to);
}

[[nodiscard]] inline Transform transform_of(const WeftTransform* given) {
    return given == nullptr ? Transform{} : std::bit_cast<Transform>(*given);
}

}  // namespace weft::c
