#pragma once
// Errors as values. Nothing in Weft's interface throws.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "weft/export.h"

namespace weft {

enum class ErrorCode : std::uint8_t {
    invalid_argument,  ///< a setting or value outside its documented range
    stale_id,          ///< an id that is null, or whose object has been removed
    invalid_mesh,      ///< a mesh from which no cloth can be made
    file_not_found,    ///< a file that does not exist, or cannot be read or written
    malformed_file,    ///< a file whose content breaks its format
    out_of_memory,     ///< the system refused memory
    unsupported,       ///< the system lacks what is needed: a display, OpenGL 3.3
    cancelled,         ///< the host's own callback asked for it
};

/// An error's code, and a message that names the offending value and what would be right.
struct Error {
    ErrorCode code = ErrorCode::invalid_argument;
    std::string message;
};

namespace detail {
/// Ends the process, in release builds too, after Hooks::failed_assertion or standard error has received the
/// error's message: a caller that reads the value of a Result that holds an Error would go on without one.
[[noreturn]] WEFT_API void fail_value(const Error& error) noexcept;
/// The same for the error of a Result that holds none.
[[noreturn]] WEFT_API void fail_error() noexcept;
}  // namespace detail

/// A T or an Error. Test it before use: `if (!result) report(result.error().message);`
/// Reading the value of an Error ends the process with the error's message.
///
/// Name a Result before a loop over what it holds: in `for (auto& p : make_sheet()->positions)` C++20 ends
/// the life of the Result before the loop begins. value() and * are sound there, since they hand the T over.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool ok() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept { return ok(); }

    /// Precondition: ok().
    [[nodiscard]] T& value() & noexcept { return *checked(std::get_if<0>(&content_)); }
    [[nodiscard]] const T& value() const& noexcept { return *checked(std::get_if<0>(&content_)); }
    [[nodiscard]] T value() && { return std::move(*checked(std::get_if<0>(&content_))); }
    T& operator*() & noexcept { return value(); }
    const T& operator*() const& noexcept { return value(); }
    T operator*() && { return std::move(*this).value(); }
    T* operator->() noexcept { return &value(); }
    const T* operator->() const noexcept { return &value(); }

    /// Precondition: !ok().
    [[nodiscard]] const Error& error() const noexcept {
        const Error* const error = std::get_if<1>(&content_);
        if (error == nullptr) detail::fail_error();
        return *error;
    }

  private:
    template <class Value>
    Value* checked(Value* value) const noexcept {
        if (value == nullptr) detail::fail_value(error());
        return value;
    }
    std::variant<T, Error> content_;
};

/// A reference to a T that is kept elsewhere and outlives the Result, or an Error.
template <class T>
class [[nodiscard]] Result<T&> {
  public:
    Result(T& value) : value_(&value) {}
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool ok() const noexcept { return value_ != nullptr; }
    explicit operator bool() const noexcept { return ok(); }

    /// Precondition: ok().
    [[nodiscard]] T& value() const noexcept {
        if (!ok()) detail::fail_value(error_);
        return *value_;
    }
    T& operator*() const noexcept { return value(); }
    T* operator->() const noexcept { return &value(); }

    /// Precondition: !ok().
    [[nodiscard]] const Error& error() const noexcept {
        if (ok()) detail::fail_error();
        return error_;
    }

  private:
    T* value_ = nullptr;
    Error error_;
};

/// Success or an Error.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), ok_(false) {}

    [[nodiscard]] bool ok() const noexcept { return ok_; }
    explicit operator bool() const noexcept { return ok_; }

    /// Precondition: !ok().
    [[nodiscard]] const Error& error() const noexcept {
        if (ok_) detail::fail_error();
        return error_;
    }

  private:
    Error error_;
    bool ok_ = true;
};

}  // namespace weft
