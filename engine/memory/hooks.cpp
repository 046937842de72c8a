#include "engine/memory/hooks.h"

#include <array>
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

#include "engine/memory/without_exceptions.h"

namespace weft {

namespace {

Hooks the_hooks;
std::atomic<std::uint64_t> bytes_in_use = 0, blocks_in_use = 0;

}  // namespace

Result<void> set_hooks(const Hooks& hooks) {
    return without_exceptions([&]() -> Result<void> {
        const auto both = [](bool one, bool other, const char* names) -> Result<void> {
            if (one == other) return {};
            return Error{ErrorCode::invalid_argument,
                         "one of Hooks::" + std::string(names) + " is null; set both, or neither"};
        };
        if (auto pair = both(hooks.allocate != nullptr, hooks.release != nullptr, "allocate and release");
            !pair)
            return pair;
        if (auto pair =
                both(hooks.begin_zone != nullptr, hooks.end_zone != nullptr, "begin_zone and end_zone");
            !pair)
            return pair;
        if (const MemoryUse use = memory_in_use(); use.blocks > 0)
            return Error{
                ErrorCode::invalid_argument,
                std::to_string(use.blocks) + " buffers are in use; set hooks before there is a cloth"};
        the_hooks = hooks;
        return {};
    });
}

MemoryUse memory_in_use() noexcept {
    return {bytes_in_use.load(std::memory_order_relaxed), blocks_in_use.load(std::memory_order_relaxed)};
}

void* take_memory(std::size_t bytes) {
    void* memory = nullptr;
    if (the_hooks.allocate != nullptr) {
        memory = the_hooks.allocate(the_hooks.user, bytes, memory_alignment);
        if (memory == nullptr) refuse_memory();
    } else {
        memory = ::operator new[](bytes, std::align_val_t{memory_alignment});
    }
    bytes_in_use.fetch_add(bytes, std::memory_order_relaxed);
    blocks_in_use.fetch_add(1, std::memory_order_relaxed);
    return memory;
}

void give_memory_back(void* memory, std::size_t bytes) noexcept {
    if (the_hooks.release != nullptr)
        the_hooks.release(the_hooks.user, memory, bytes, memory_alignment);
    else
        ::operator delete[](memory, std::align_val_t{memory_alignment});
    bytes_in_use.fetch_sub(bytes, std::memory_order_relaxed);
    blocks_in_use.fetch_sub(1, std::memory_order_relaxed);
}

bool is_logged() noexcept {
    return the_hooks.log != nullptr;
}

void log_line(LogLevel level, const char* format, ...) noexcept {
    if (!is_logged()) return;
    std::array<char, 256> line{};
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line.data(), line.size(), format, arguments);
    va_end(arguments);
    the_hooks.log(the_hooks.user, level, line.data());
}

void begin_zone(const char* name) noexcept {
    if (the_hooks.begin_zone != nullptr) the_hooks.begin_zone(the_hooks.user, name);
}

void end_zone(const char* name) noexcept {
    if (the_hooks.end_zone != nullptr) the_hooks.end_zone(the_hooks.user, name);
}

namespace detail {

void fail_value(const Error& error) noexcept {
    std::array<char, 512> line{};
    std::snprintf(line.data(), line.size(), "the value of a Result was read that holds an Error: %s",
                  error.message.c_str());
    fail_assertion(line.data(), "weft/error.h", 0);
}

void fail_error() noexcept {
    fail_assertion("the error of a Result was read that holds none", "weft/error.h", 0);
}

}  // namespace detail

void fail_assertion(const char* condition, const char* file, int line) noexcept {
    if (the_hooks.failed_assertion != nullptr)
        the_hooks.failed_assertion(the_hooks.user, condition, file, line);
    else
        std::fprintf(stderr, "weft: %s:%d: assertion failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace weft
