#pragma once
// A tree of named values, written as JSON or indented for people.

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "cloth/settings/fields.h"
#include "cloth/settings/names.h"
#include "weft/cloth_id.h"

namespace weft {

/// Values of an object have names; in a list the name is empty.
class Outline {
  public:
    explicit Outline(DescriptionFormat format) : is_json_(format == DescriptionFormat::json) {
        if (is_json_) text_ += '{';
    }
    [[nodiscard]] std::string finish() && {
        text_ += is_json_ ? "}\n" : "";
        return std::move(text_);
    }

    /// Calls `write` for the content.
    template <class Write>
    void object(std::string_view name, const Write& write) {
        within(name, '{', '}', write);
    }
    template <class Write>
    void list(std::string_view name, const Write& write) {
        within(name, '[', ']', write);
    }

    void value(std::string_view name, bool value) { line(name, value ? "true" : "false"); }
    void value(std::string_view name, const char* words) { line(name, quoted(words)); }
    template <std::integral T>
    requires(!std::same_as<T, bool>) void value(std::string_view name, T number) {
        line(name, std::to_string(number));
    }
    void value(std::string_view name, float number) { line(name, text_of(number)); }
    void value(std::string_view name, const Vec3& v) { numbers(name, {v.x, v.y, v.z}); }
    void value(std::string_view name, const Rotation& r) { numbers(name, {r.x, r.y, r.z, r.w}); }
    template <class Id>
    requires requires(Id id) { id.generation; }
    void value(std::string_view name, const Id& id) {
        line(name, '[' + std::to_string(id.index) + ", " + std::to_string(id.generation) + ']');
    }
    void value(std::string_view name, StepFlags flags) {
        std::string all;
        for_each_flag(flags, [&](const char* flag) { all += (all.empty() ? "" : ", ") + quoted(flag); });
        line(name, is_json_ ? '[' + all + ']' : all.empty() ? "none" : all);
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void value(std::string_view name, Enum value) { line(name, quoted(name_of(value))); }
    /// Writes the sources or shelters that are set.
    template <HasFields T, std::size_t count>
    void value(std::string_view name, const std::array<T, count>& all) {
        list(name, [&] {
            for (const T& each : all)
                if (each.kind != decltype(each.kind)::none) value("", each);
        });
    }
    template <HasFields T>
    void value(std::string_view name, const T& of) {
        object(name, [&] { fields(of); });
    }
    template <class... Kinds>
    void value(std::string_view name, const std::variant<Kinds...>& one) {
        object(name, [&] {
            std::visit(
                [&](const auto& kind) {
                    value("kind", struct_name(kind));
                    fields(kind);
                },
                one);
        });
    }
    /// Writes the fields of `of`, without an object around them.
    template <class T>
    void fields(const T& of) {
        for_each_field(of, [&](const char* field, const auto& each) { value(field, each); });
    }

  private:
    /// The shortest text that reads back as the same float; JSON has no infinity.
    [[nodiscard]] std::string text_of(float number) const {
        if (is_json_ && !std::isfinite(number)) return "null";
        char digits[32];
        return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
    }
    [[nodiscard]] std::string quoted(const char* words) const {
        return is_json_ ? '"' + std::string(words) + '"' : std::string(words);
    }
    void numbers(std::string_view name, std::initializer_list<float> all) {
        std::string list;
        for (const float number : all) list += (list.empty() ? "[" : ", ") + text_of(number);
        line(name, list + ']');
    }
    void begin(std::string_view name) {
        if (is_json_) {
            if (!is_first_) text_ += ',';
            if (!name.empty()) text_.append("\"").append(name).append("\":");
        } else {
            text_.append(2 * depth_, ' ').append(name.empty() ? "-" : name);
            if (!name.empty()) text_ += ':';
        }
        is_first_ = false;
    }
    void line(std::string_view name, std::string_view words) {
        begin(name);
        if (!is_json_) text_ += ' ';
        text_.append(words);
        if (!is_json_) text_ += '\n';
    }
    template <class Write>
    void within(std::string_view name, char opens, char closes, const Write& write) {
        begin(name);
        text_ += is_json_ ? opens : '\n';
        is_first_ = true;
        ++depth_;
        write();
        --depth_;
        is_first_ = false;
        if (is_json_) text_ += closes;
    }

    std::string text_;
    std::size_t depth_ = 0;
    bool is_json_, is_first_ = true;
};

}  // namespace weft
