// weft_fuzz: random calls of the public interface, as long as asked, the same for the same seed.

#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include "tests/fuzz/crash_report.h"
#include "tests/fuzz/play.h"

namespace weft::fuzz {
namespace {

constexpr const char* usage =
    "weft_fuzz [--seed S] [--operations N | --seconds T] [--log]\n"
    "Plays scripts of random calls, the first drawn from seed S (1), the next from S + 1, and so on, until N "
    "calls\n"
    "(1000) were made or T seconds have passed. At the first fault it prints the script and its seed: --seed "
    "with\n"
    "that seed and --operations 1 plays it again. --log prints every script before it is played.\n";

struct Options {
    std::uint64_t seed = 1, operations = 1000, seconds = 0;  // seconds 0: by operations
    bool log = false;
};

std::optional<Options> parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        if (name == "--log") {
            options.log = true;
            continue;
        }
        std::uint64_t* const value = name == "--seed"         ? &options.seed
                                     : name == "--operations" ? &options.operations
                                     : name == "--seconds"    ? &options.seconds
                                                              : nullptr;
        if (value == nullptr || ++i == count) return std::nullopt;
        const char* const end = arguments[i] + std::strlen(arguments[i]);
        if (std::from_chars(arguments[i], end, *value).ptr != end) return std::nullopt;
    }
    return options;
}

bool plays_well(const Script& script, const std::string& log) {
    constexpr unsigned longest_script = 600;  // [s]
    report_crashes_with(log, present_operation(), longest_script);
    try {
        play_all_ways(script);
        return true;
    } catch (const Failure& failure) {
        std::fprintf(stderr, "%s\nseed %llu, operation %zu, %s\n%s\n", log.c_str(),
                     static_cast<unsigned long long>(script.seed), failure.operation,
                     text_of(script.operations[failure.operation]).c_str(), failure.what.c_str());
        return false;
    }
}

int run(const Options& options) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    std::uint64_t operations = 0, scripts = 0;
    const auto is_done = [&] {
        return options.seconds > 0 ? Clock::now() - begin >= std::chrono::seconds(options.seconds)
                                   : operations >= options.operations;
    };
    for (; !is_done(); ++scripts) {
        const Script script = random_script(options.seed + scripts);
        const std::string log = "seed " + std::to_string(script.seed) + '\n' + text_of(script);
        if (options.log) {
            std::puts(log.c_str());
            std::fflush(stdout);
        }
        if (!plays_well(script, log)) return EXIT_FAILURE;
        operations += script.operations.size();
    }
    std::printf("%llu scripts of %llu calls from seed %llu on: no fault\n",
                static_cast<unsigned long long>(scripts), static_cast<unsigned long long>(operations),
                static_cast<unsigned long long>(options.seed));
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace weft::fuzz

int main(int count, char** arguments) {
    const auto options = weft::fuzz::parse(count, arguments);
    if (!options) {
        std::fputs(weft::fuzz::usage, stderr);
        return 2;
    }
    return weft::fuzz::run(*options);
}
