#pragma once
// Random draws that are the same on every machine and with every standard library.

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "weft/weft.h"

namespace weft::fuzz {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    bool chance(double probability) { return unit() < probability; }
    /// In [0, count).
    std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(next() % count); }
    float between(float low, float high) { return low + static_cast<float>(unit()) * (high - low); }
    /// In [low, high], each end in one draw of ten.
    int whole(int low, int high) {
        if (chance(0.1)) return low;
        if (chance(0.1)) return high;
        return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1));
    }
    /// In [low, high], as often in each decade; each end in one draw of ten. Precondition: low > 0.
    float of_any_size(float low, float high) {
        if (chance(0.1)) return low;
        if (chance(0.1)) return high;
        const double decades = std::log(static_cast<double>(high) / static_cast<double>(low));
        return static_cast<float>(static_cast<double>(low) * std::exp(unit() * decades));
    }
    Vec3 point(float reach) {
        const float x = between(-reach, reach), y = between(-reach, reach), z = between(-reach, reach);
        return {x, y, z};
    }
    template <class T>
    T one_of(std::initializer_list<T> values) {
        return values.begin()[below(values.size())];
    }

  private:
    std::uint64_t state_;
};

/// The expected answer of a call.
enum class Answer {
    accepted,
    refused,
    either,  ///< within the documented ranges, but beyond all reason
};

template <class T>
struct Drawn {
    T value;
    Answer answer = Answer::accepted;
};

}  // namespace weft::fuzz
