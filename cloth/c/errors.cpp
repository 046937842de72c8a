#include "cloth/c/errors.h"

#include <cstring>
#include <string>

#include "cloth/c/sized.h"
#include "engine/memory/without_exceptions.h"
#include "weft/weft_c.h"

namespace weft::c {

namespace {

/// No message is longer, except those with a long file name.
constexpr std::size_t most_text = 1024;
thread_local char text_of_error[most_text] = "";

}  // namespace

WeftResult fail(ErrorCode code, const char* text) noexcept {
    std::strncpy(text_of_error, text, most_text - 1);
    return static_cast<WeftResult>(code) + 1;
}

WeftResult run(Result<void> (*act)(const void*), const void* of) noexcept {
    const Result<void> done = without_exceptions([&] { return act(of); });
    return done ? WEFT_OK : fail(done.error().code, done.error().message.c_str());
}

Error null_pointer(const char* name) {
    return {ErrorCode::invalid_argument, std::string(name) + " is a null pointer"};
}
Error no_items(const char* name, std::size_t count) {
    return {ErrorCode::invalid_argument,
            std::string(name) + ": " + std::to_string(count) + " items at a null pointer"};
}
Error too_short(const char* name, std::size_t stride, std::size_t item) {
    return {ErrorCode::invalid_argument, std::string(name) + ".stride is " + std::to_string(stride) +
                                             " bytes; an item takes " + std::to_string(item)};
}
Error no_room(const char* name, std::size_t bytes, std::size_t stride, std::size_t count, std::size_t item) {
    return {ErrorCode::invalid_argument, std::string(name) + " has " + std::to_string(bytes) +
                                             " bytes and a stride of " + std::to_string(stride) +
                                             "; it takes room for " + std::to_string(count) + " items of " +
                                             std::to_string(item) + " bytes"};
}
Error out_of_choices(const char* name, std::int32_t value, int count) {
    return {ErrorCode::invalid_argument, std::string(name) + " is " + std::to_string(value) +
                                             "; it must be 0 to " + std::to_string(count - 1)};
}

Result<void> check_size(const char* name, std::size_t size, std::size_t first, std::size_t known) {
    if (size >= first && size <= known) return {};
    return Error{ErrorCode::invalid_argument,
                 std::string(name) + ".struct_size is " + std::to_string(size) +
                     "; it must be its sizeof, which is " + std::to_string(known) + " here" +
                     (size > known ? ": the header is newer than the library" : "")};
}

Result<void> are_there(std::initializer_list<std::pair<const void*, const char*>> pointers) {
    for (const auto& [pointer, name] : pointers)
        if (pointer == nullptr) return null_pointer(name);
    return {};
}

}  // namespace weft::c

const char* weft_error_text(void) {
    return weft::c::text_of_error;
}
