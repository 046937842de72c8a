#pragma once
// Lists of the fields of structs that a host sets and reads, with the ranges of numbers:
//
//     WEFT_FIELDS_OF(Tethers) {
//         WEFT_FIELD(enabled);
//         WEFT_FIELD(slack, 1, 1e3f);
//     }
//
// From this list come checks, recordings, replays, descriptions, the lists of numbers for hosts, and the
// conversion from and to C.

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>
#include <variant>

namespace weft {

/// Which values a range has besides those between its ends.
enum class Ends {
    closed,      ///< both ends
    or_zero,     ///< both ends, and 0 apart from them
    open_above,  ///< the lower end only
};

/// Range of a number, or of each component of a vector. Not-a-number is in none.
struct Range {
    float least, greatest;
    Ends ends = Ends::closed;
    const char* right = nullptr;  ///< what an error recommends; null: the ends

    [[nodiscard]] constexpr bool has(double value) const {
        if (ends == Ends::or_zero && value == 0) return true;
        return value >= static_cast<double>(least) && value <= static_cast<double>(greatest) &&
               !is_open_end(value);
    }
    [[nodiscard]] constexpr bool is_open_end(double value) const {
        return ends == Ends::open_above && value == static_cast<double>(greatest);
    }
};

template <class T, class Of>
concept IsStruct = std::same_as<std::remove_const_t<T>, Of>;

/// Defines struct_name(Struct), and for_both(a, b, way). It calls way(name, a.field, b.field), with the range
/// behind where there is one, for each field of b and of a, which is such a struct too, or one for C.
#define WEFT_FIELDS_OF(Struct)                                \
    constexpr const char* struct_name(const Struct& /*of*/) { \
        return #Struct;                                       \
    }                                                         \
    template <class A, IsStruct<Struct> B, class Way>         \
    constexpr void for_both([[maybe_unused]] A& a, [[maybe_unused]] B& b, [[maybe_unused]] const Way& way)
#define WEFT_FIELD(field, ...) way(#field, a.field, b.field __VA_OPT__(, Range{__VA_ARGS__}))

struct AnyVisit {
    template <class... Values>
    constexpr void operator()(const char* /*name*/, Values&&... /*values*/) const {}
};
/// Structs that have a list.
template <class T>
concept HasFields = requires(T& of) {
    for_both(of, of, AnyVisit{});
};

/// Calls visit(name, value) for each field.
template <HasFields T, class Visit>
constexpr void for_each_field(T& of, const Visit& visit) {
    for_both(of, of, [&](const char* name, auto& value, auto& /*same*/, const auto&... /*range*/) {
        visit(name, value);
    });
}

/// Returns true if a field has an effect, given the struct's other fields. Overloaded for structs where some
/// do not.
template <class T>
constexpr bool counts(const T& /*of*/, const void* /*field*/) {
    return true;
}

/// Calls visit(struct's name, field's name, value in `a`), with the range behind where there is one, for each
/// field that counts. A struct within another, an alternative and an array are visited field by field. `a` is
/// `of`, or its counterpart for C, which has the fields of all alternatives in one struct.
template <class A, class Of, class Visit>
void for_each_leaf(A& a, Of& of, const Visit& visit) {
    if constexpr (HasFields<Of>) {
        for_both(a, of, [&]<class Field>(const char* name, auto& in_a, Field& field, const auto&... range) {
            if (!counts(of, &field)) return;
            if constexpr (HasFields<Field> || requires { field.index(); } || std::ranges::range<Field>)
                for_each_leaf(in_a, field, visit);
            else
                visit(struct_name(of), name, in_a, range...);
        });
    } else if constexpr (std::ranges::range<Of>) {
        for (std::size_t k = 0; k < of.size(); ++k) for_each_leaf(a[k], of[k], visit);
    } else if (!of.valueless_by_exception()) {
        std::visit(
            [&](auto& one) {
                if constexpr (std::same_as<A, Of>)
                    for_each_leaf(one, one, visit);
                else
                    for_each_leaf(a, one, visit);
            },
            of);
    }
}

}  // namespace weft
