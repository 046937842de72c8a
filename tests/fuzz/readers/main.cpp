// weft_fuzz_readers: damaged files for everything that reads files, the same for the same seed.

#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>

#include "tests/fuzz/crash_report.h"
#include "tests/fuzz/readers/reader.h"

#ifdef __SANITIZE_ADDRESS__
extern "C" const char* __asan_default_options() {
    return "max_allocation_size_mb=2048";
}
#endif

namespace weft::fuzz {
namespace {

/// The files have some kilobytes: whoever asks for gigabytes because of one has believed a number in it.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__
    constexpr rlim_t most = rlim_t{4} << 30;
    const rlimit limit{most, most};
    must(setrlimit(RLIMIT_AS, &limit) == 0, "memory cannot be limited");
#endif
}

constexpr const char* usage =
    "weft_fuzz_readers [--seed S] [--files N] [--seconds T] [--only READER]\n"
    "Gives each reader N damaged files (1000), drawn from seed S (1), for T seconds at most (60) for all of "
    "them. At the\n"
    "first fault it prints the reader and the number of the file, and leaves the file: --only READER --seed "
    "S --files 1\n"
    "with that number as the seed reads it again.\n";

struct Options {
    std::uint64_t seed = 1, files = 1000, seconds = 60;
    std::string only;
};

std::optional<Options> parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        if (++i == count) return std::nullopt;
        if (name == "--only") {
            options.only = arguments[i];
            continue;
        }
        std::uint64_t* const value = name == "--seed"      ? &options.seed
                                     : name == "--files"   ? &options.files
                                     : name == "--seconds" ? &options.seconds
                                                           : nullptr;
        if (value == nullptr) return std::nullopt;
        const char* const end = arguments[i] + std::strlen(arguments[i]);
        if (std::from_chars(arguments[i], end, *value).ptr != end) return std::nullopt;
    }
    return options;
}

class Run {
  public:
    explicit Run(const Options& options)
        : options_(options),
          folder_(std::filesystem::temp_directory_path() /
                  ("weft_fuzz_readers_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }

    /// Each reader has its share of the time, and what others have left of theirs.
    [[nodiscard]] bool all() {
        std::vector<Reader> readers = library_readers();
        for (Reader& each : demo_readers()) readers.push_back(std::move(each));
        if (!options_.only.empty())
            std::erase_if(readers, [&](const Reader& r) { return r.name != options_.only; });
        const auto begin = Clock::now();
        for (std::size_t r = 0; r < readers.size(); ++r) {
            const auto share = std::chrono::duration<double>(static_cast<double>(options_.seconds) *
                                                             static_cast<double>(r + 1) /
                                                             static_cast<double>(readers.size()));
            if (!one(readers[r], begin + std::chrono::duration_cast<Clock::duration>(share))) return false;
        }
        std::filesystem::remove_all(folder_);
        return true;
    }

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool one(const Reader& reader, Clock::time_point end) {
        constexpr unsigned longest = 20;  // for a file [s]
        std::uint64_t read = 0, accepted = 0;
        const auto begin = Clock::now();
        log_ = reader.name;
        for (; read < options_.files && Clock::now() < end; ++read) {
            file_ = options_.seed + read;
            report_crashes_with(log_, file_, longest);
            Random random(file_);
            try {
                accepted += reader.read_one(random, folder_) ? 1 : 0;
            } catch (const Broken& broken) {
                return fails(broken.what);
            } catch (const std::exception& thrown) {
                return fails(std::string("an exception: ") + thrown.what());
            }
        }
        std::printf(
            "%-10s %7llu files, %5.1f %% accepted, %5.1f s\n", reader.name.c_str(),
            static_cast<unsigned long long>(read),
            100 * static_cast<double>(accepted) / static_cast<double>(std::max<std::uint64_t>(read, 1)),
            std::chrono::duration<double>(Clock::now() - begin).count());
        std::fflush(stdout);
        return true;
    }

    [[nodiscard]] bool fails(const std::string& what) const {
        std::fprintf(stderr, "%s, seed %zu: %s\nThe file is in %s\n", log_.c_str(), file_, what.c_str(),
                     folder_.c_str());
        return false;
    }

    Options options_;
    std::filesystem::path folder_;
    std::string log_;
    std::size_t file_ = 0;
};

}  // namespace
}  // namespace weft::fuzz

int main(int count, char** arguments) {
    const auto options = weft::fuzz::parse(count, arguments);
    if (!options) {
        std::fputs(weft::fuzz::usage, stderr);
        return 2;
    }
    weft::fuzz::limit_memory();
    return weft::fuzz::Run(*options).all() ? EXIT_SUCCESS : EXIT_FAILURE;
}
