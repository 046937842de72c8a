// weft_bench: Google Benchmark's arguments, or --roofline[=THREADS], or --peers, or --ratios, or --calls.

#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdio>
#include <string_view>

#include "tests/bench/frames.h"

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        constexpr std::string_view roofline = "--roofline";
        if (argument == "--peers") {
            weft::bench::print_peers();
            return 0;
        }
        if (argument == "--ratios") {
            weft::bench::print_ratios();
            return 0;
        }
        if (argument == "--calls") {
            weft::bench::print_calls();
            return 0;
        }
        if (argument.starts_with(roofline)) {
            int threads = 1;
            if (argument != roofline) {
                const char* const end = argument.data() + argument.size();
                const auto parsed = std::from_chars(argument.data() + roofline.size() + 1, end, threads);
                if (argument[roofline.size()] != '=' || parsed.ptr != end || threads < 1 || threads > 256) {
                    std::fprintf(stderr, "weft_bench: --roofline=THREADS, 1 to 256\n");
                    return 2;
                }
            }
            weft::bench::print_roofline(threads);
            return 0;
        }
    }
    weft::bench::register_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
