// Steps have the bytes that other kinds of machines and other compilers gave them: one set for all that round
// a * b + c once, and one for the rest.
//
// To record them again: WEFT_RECORD_HASHES=1 build/release/bin/weft_targets_tests
// --gtest_filter='*PortableHash*'

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>

#include "tests/guarantees/method_cases.h"
#include "tests/targets/targets.h"

namespace weft::test {
namespace {

constexpr std::uint32_t side = 17;
constexpr int steps = 30;

/// "METHOD fused HASH" and "METHOD plain HASH", a line each.
using Hashes = std::map<std::string, std::string>;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;  // since WASI has no streams of files

Hashes read_hashes() {
    Hashes hashes;
    const File in(std::fopen(WEFT_PORTABLE_HASHES, "r"), std::fclose);
    char method[128], rounding[16], hash[32];
    while (in && std::fscanf(in.get(), "%127s %15s %31s", method, rounding, hash) == 3)
        hashes[std::string(method) + ' ' + rounding] = hash;
    return hashes;
}

std::string hash_under(std::int64_t target, const MethodCase& method_case) {
    use_target(target);
    LoweredSheet run(method_case, 1, side);
    for (int step = 0; step < steps; ++step) {
        run.before_step();
        EXPECT_FALSE(has(run.step().flags, StepFlags::state_restored)) << "in step " << step;
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, run.world().state_hash());
    return text;
}

class PortableHash : public testing::TestWithParam<MethodCase> {
  protected:
    void TearDown() override {
        use_target(vector_targets().empty() ? reference_target() : vector_targets().front());
    }
};

TEST_P(PortableHash, IsThatOfEveryMachine) {
    Hashes recorded = read_hashes();
    std::vector<std::int64_t> targets = vector_targets();
    if (has_reference_target()) targets.push_back(reference_target());
    for (const std::int64_t target : targets) {
        const std::string key = GetParam().name + (is_fused(target) ? " fused" : " plain");
        const std::string hash = hash_under(target, GetParam());
        if (std::getenv("WEFT_RECORD_HASHES") != nullptr)
            recorded[key] = hash;
        else
            EXPECT_EQ(hash, recorded[key]) << "under " << hwy::TargetName(target);
    }
    if (std::getenv("WEFT_RECORD_HASHES") == nullptr) return;
    const File out(std::fopen(WEFT_PORTABLE_HASHES, "w"), std::fclose);
    ASSERT_TRUE(out) << WEFT_PORTABLE_HASHES << " cannot be written";
    for (const auto& [key, hash] : recorded) std::fprintf(out.get(), "%s %s\n", key.c_str(), hash.c_str());
}

INSTANTIATE_TEST_SUITE_P(Methods, PortableHash, testing::ValuesIn(method_cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft::test
