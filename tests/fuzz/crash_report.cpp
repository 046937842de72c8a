#include "tests/fuzz/crash_report.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

// A function of the sanitizers' runtime; null without it.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace weft::fuzz {

namespace {

const char* log_text = "";
std::size_t log_size = 0;
const std::size_t* present = &log_size;

// Nothing here allocates: the heap may be what broke.
void print_log() {
    char head[64];
    const int size = std::snprintf(head, sizeof head, "\nin number %zu of\n", *present);
    if (write(STDERR_FILENO, head, static_cast<std::size_t>(size)) < 0) return;
    if (write(STDERR_FILENO, log_text, log_size) < 0) return;
}

void on_signal(int signal) {
    print_log();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Signals have a stack of their own: an overflow of the usual one is reported as well.
void install() {
    static char stack[1 << 16];
    stack_t own{};
    own.ss_sp = stack;
    own.ss_size = sizeof stack;
    sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGABRT, SIGALRM}) sigaction(signal, &action, nullptr);
    if (__sanitizer_set_death_callback != nullptr) {
        __sanitizer_set_death_callback(print_log);
    } else {
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) sigaction(signal, &action, nullptr);
    }
}

}  // namespace

void report_crashes_with(const std::string& text, const std::size_t& operation, unsigned longest) {
    static const bool installed = (install(), true);
    static_cast<void>(installed);
    log_text = text.data();
    log_size = text.size();
    present = &operation;
    alarm(longest);
}

}  // namespace weft::fuzz
