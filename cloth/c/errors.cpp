#include "cloth/c/errors.h"

#include <cstring>
#include <string>

#include "weft/weft_c.h"

namespace weft::c {

namespace {

/// So long that no message is cut, but those with a long file name.
constexpr std::size_t most_text = 1024;
thread_local char text_of_error[most_text] = "";

}  // namespace

WeftResult fail(ErrorCode code, const char* text) noexcept {
    std::strncpy(text_of_error, text, most_text - 1);
    return static_cast<WeftResult>(code) + 1;
}

Result<void> are_there(std::initializer_list<std::pair<const void*, const char*>> pointers) {
    for (const auto& [pointer, name] : pointers)
        if (pointer == nullptr)
            return Error{ErrorCode::invalid_argument, std::string(name) + " is a null pointer"};
    return {};
}

}  // namespace weft::c

const char* weft_error_text(void) {
    return weft::c::text_of_error;
}
