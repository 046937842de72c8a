#include "tests/fuzz/crash_report.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "tests/fuzz/play.h"

// Of the sanitizers' runtime; null without it.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace weft::fuzz {

namespace {

constexpr unsigned longest_script = 600;  // [s]

const char* log_text = "";
std::size_t log_size = 0;

// Nothing here allocates: the heap may be what broke.
void print_log() {
    char head[64];
    const int size = std::snprintf(head, sizeof head, "\nin operation %zu of\n", present_operation());
    if (write(STDERR_FILENO, head, static_cast<std::size_t>(size)) < 0) return;
    if (write(STDERR_FILENO, log_text, log_size) < 0) return;
}

void on_signal(int signal) {
    print_log();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void install() {
    for (const int signal : {SIGABRT, SIGALRM}) std::signal(signal, on_signal);
    if (__sanitizer_set_death_callback != nullptr) {
        __sanitizer_set_death_callback(print_log);
    } else {
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, on_signal);
    }
}

}  // namespace

void report_crashes_with(const std::string& text) {
    static const bool installed = (install(), true);
    static_cast<void>(installed);
    log_text = text.data();
    log_size = text.size();
    alarm(longest_script);
}

}  // namespace weft::fuzz
