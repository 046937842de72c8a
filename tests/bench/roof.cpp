#include "tests/bench/roof.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "engine/memory/aligned_buffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/roof.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace weft::bench::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<float>;

/// Twelve chains hide the latency of two units; each starts elsewhere, or a compiler would make them one.
/// Returns the operations done.
double multiply_add(std::size_t rounds, float* sink) {
    const Tag d;
    const auto a = hn::Set(d, 0.999f), b = hn::Set(d, 1e-3f);
    const auto start = [d](float value) HWY_ATTR { return hn::Set(d, value); };
    auto c0 = start(1), c1 = start(2), c2 = start(3), c3 = start(4), c4 = start(5), c5 = start(6),
         c6 = start(7), c7 = start(8), c8 = start(9), c9 = start(10), c10 = start(11), c11 = start(12);
    for (std::size_t k = 0; k < rounds; ++k) {
        c0 = hn::MulAdd(c0, a, b), c1 = hn::MulAdd(c1, a, b), c2 = hn::MulAdd(c2, a, b);
        c3 = hn::MulAdd(c3, a, b), c4 = hn::MulAdd(c4, a, b), c5 = hn::MulAdd(c5, a, b);
        c6 = hn::MulAdd(c6, a, b), c7 = hn::MulAdd(c7, a, b), c8 = hn::MulAdd(c8, a, b);
        c9 = hn::MulAdd(c9, a, b), c10 = hn::MulAdd(c10, a, b), c11 = hn::MulAdd(c11, a, b);
    }
    const auto sum = hn::Add(
        hn::Add(hn::Add(c0, c1), hn::Add(c2, c3)),
        hn::Add(hn::Add(hn::Add(c4, c5), hn::Add(c6, c7)), hn::Add(hn::Add(c8, c9), hn::Add(c10, c11))));
    *sink += hn::GetLane(hn::SumOfLanes(d, sum));
    return 24.0 * static_cast<double>(rounds * hn::Lanes(d));
}

/// Reads all of it once. Precondition: a multiple of 64 vectors.
void read(const float* values, std::size_t count, float* sink) {
    const Tag d;
    const std::size_t lanes = hn::Lanes(d);
    auto s0 = hn::Zero(d), s1 = s0, s2 = s0, s3 = s0;
    for (std::size_t i = 0; i < count; i += 4 * lanes) {
        s0 = hn::Add(s0, hn::Load(d, values + i));
        s1 = hn::Add(s1, hn::Load(d, values + i + lanes));
        s2 = hn::Add(s2, hn::Load(d, values + i + 2 * lanes));
        s3 = hn::Add(s3, hn::Load(d, values + i + 3 * lanes));
    }
    *sink += hn::GetLane(hn::SumOfLanes(d, hn::Add(hn::Add(s0, s1), hn::Add(s2, s3))));
}

const char* target_name() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace
}  // namespace weft::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft::bench {

namespace {

HWY_EXPORT(multiply_add);
HWY_EXPORT(read);
HWY_EXPORT(target_name);

using Clock = std::chrono::steady_clock;

/// The best rate of some rounds, in which each thread does work(thread), which returns how much it did.
double best_rate(int threads, const std::function<double(int)>& work) {
    double best = 0;
    for (int round = 0; round < 8; ++round) {
        std::vector<double> done(static_cast<std::size_t>(threads));
        const auto begin = Clock::now();
        {
            std::vector<std::jthread> team;
            for (int t = 0; t < threads; ++t)
                team.emplace_back([&, t] { done[static_cast<std::size_t>(t)] = work(t); });
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        double sum = 0;
        for (const double part : done) sum += part;
        best = std::max(best, sum / seconds);
    }
    return best;
}

double read_rate(int threads, std::size_t bytes) {
    constexpr std::size_t grain = 16384;  // floats
    const std::size_t each =
        std::max<std::size_t>(bytes / sizeof(float) / static_cast<std::size_t>(threads) / grain, 1) * grain;
    std::vector<AlignedBuffer<float>> buffers;
    for (int t = 0; t < threads; ++t) buffers.emplace_back(each);
    constexpr std::size_t wanted = std::size_t{1} << 28;  // floats: long against starting a thread
    const std::size_t repeats = std::max<std::size_t>(wanted / 8 / each, 1);
    std::vector<float> sinks(static_cast<std::size_t>(threads) * 16);
    return best_rate(threads, [&](int t) {
        const auto index = static_cast<std::size_t>(t);
        for (std::size_t k = 0; k < repeats; ++k)
            HWY_DYNAMIC_DISPATCH(read)(buffers[index].data(), each, &sinks[16 * index]);
        return static_cast<double>(repeats * each * sizeof(float));
    });
}

std::size_t cache_bytes(int name, std::size_t otherwise) {
    const long size = sysconf(name);
    return size > 0 ? static_cast<std::size_t>(size) : otherwise;
}

}  // namespace

double Roof::least_seconds(double bytes, double flop_count, double working_set) const {
    const auto at = std::ranges::find_if(
        reads, [&](const ReadRate& rate) { return working_set <= static_cast<double>(rate.bytes); });
    const ReadRate& rate = at == reads.end() ? reads.back() : *at;
    return std::max(bytes / rate.bytes_per_second, flop_count / flops);
}

Roof measure_roof(int threads) {
    const auto count = static_cast<std::size_t>(threads);
    const std::size_t l2 = cache_bytes(_SC_LEVEL2_CACHE_SIZE, 1u << 20) * count;
    const std::size_t l3 = cache_bytes(_SC_LEVEL3_CACHE_SIZE, 32u << 20);
    std::vector<float> sinks(count * 16);
    Roof roof{.target = HWY_DYNAMIC_DISPATCH(target_name)(),
              .flops = best_rate(threads,
                                 [&](int t) {
                                     return HWY_DYNAMIC_DISPATCH(multiply_add)(
                                         4'000'000, &sinks[16 * static_cast<std::size_t>(t)]);
                                 }),
              .reads = {}};
    // In L2, then from the last level, of which others have their part, and from beyond it.
    const std::size_t beyond = std::max(2 * l3, std::size_t{512} << 20);
    for (const std::size_t bytes : {l2 / 2, l2, 3 * l2 / 2, 2 * l2, 4 * l2, 16 * l2, beyond})
        roof.reads.push_back({bytes, read_rate(threads, bytes)});
    return roof;
}

}  // namespace weft::bench
#endif
