#pragma once
// Checks of structs that a host sets, by the lists of their fields.

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "collision/shapes/collider_motion.h"
#include "engine/error_text.h"
#include "engine/fields.h"

namespace weft {

/// Checks values, and keeps the first error. A struct with an enumeration needs its names_of().
class FieldChecks {
  public:
    /// Checks all fields of a struct, and of the structs in it.
    template <HasFields T>
    void fields(const T& of) {
        for_each_leaf(of, of,
                      [&](const char* owner, const char* field, const auto& value, const auto&... range) {
                          if (!first_) first_ = error(owner, field, value, range...);
                      });
    }
    /// Checks a number that no list has, or against a narrower range.
    void number(const char* owner, const char* field, double value, const Range& range) {
        if (!first_) first_ = error(owner, field, value, range);
    }
    void allow(bool good, const char* complaint) {
        if (!first_ && !good) first_ = Error{ErrorCode::invalid_argument, complaint};
    }
    [[nodiscard]] Result<void> result() const { return first_ ? Result<void>(*first_) : Result<void>(); }

  private:
    using Found = std::optional<Error>;

    static std::string full(const char* owner, const char* field) {
        return std::string(owner) + "::" + field;
    }
    template <class Number>
    requires std::is_arithmetic_v<Number>
    static Found error(const char* owner, const char* field, Number value, const Range& range) {
        const auto number = static_cast<double>(value);
        if (range.has(number)) return {};
        return out_of_range(full(owner, field), number, right(range, number));
    }
    static Found error(const char* owner, const char* field, const Vec3& value, const Range& range) {
        for (const float each : {value.x, value.y, value.z}) {
            if (range.has(static_cast<double>(each))) continue;
            if (range.right) return out_of_range(full(owner, field), value, range.right);
            if (range.least > 0) return error(owner, field, each, range);  // a length: itself says enough
            return out_of_range(full(owner, field), value, right(range, 1) + " in every component");
        }
        return {};
    }
    static Found error(const char* owner, const char* field, const Rotation& value) {
        const auto valid = validate_rotation(full(owner, field), value);
        return valid ? Found() : Found(valid.error());
    }
    template <class Value>
    static Found error(const char* owner, const char* field, const Value& value) {
        if constexpr (std::is_enum_v<Value>) {
            const auto [type, names] = names_of(value);
            const auto number = static_cast<std::int64_t>(value);
            if (std::cmp_greater_equal(number, 0) && std::cmp_less(number, names.size())) return {};
            std::string all;
            for (const char* each : names)
                all.append(all.empty() ? "" : " or ").append(type).append("::").append(each);
            return out_of_range(full(owner, field), static_cast<double>(number), all);
        } else {
            static_assert(!std::is_floating_point_v<Value> && !std::is_same_v<Value, int> &&
                              !std::is_same_v<Value, Vec3>,
                          "a number needs a range in its struct's list");
            return {};
        }
    }
    /// The range as an error recommends it: "from 0 to 1".
    static std::string right(const Range& range, double value) {
        if (range.right) return range.right;
        const auto text = [](float end) { return number_text(static_cast<double>(end)); };
        if (range.is_open_end(value)) return "below " + text(range.greatest);
        return (range.ends == Ends::or_zero ? "0, or from " : "from ") + text(range.least) + " to " +
               text(range.greatest);
    }

    std::optional<Error> first_;
};

/// Error: the first field that is out of its range.
template <HasFields T>
[[nodiscard]] Result<void> validate_fields(const T& of) {
    FieldChecks checks;
    checks.fields(of);
    return checks.result();
}

}  // namespace weft
