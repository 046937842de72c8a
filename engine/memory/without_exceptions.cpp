#include "engine/memory/without_exceptions.h"

#include <cstdlib>
#include <new>

#include "engine/memory/hooks.h"

namespace weft {

void refuse(Error error) {
#ifdef __cpp_exceptions
    throw Refusal{std::move(error)};
#else
    log_line(LogLevel::warning, "%s; built without exceptions, Weft ends the process", error.message.c_str());
    std::abort();
#endif
}

void refuse_memory() {
#ifdef __cpp_exceptions
    throw std::bad_alloc();
#else
    log_line(LogLevel::warning, "out of memory; built without exceptions, Weft ends the process");
    std::abort();
#endif
}

}  // namespace weft
