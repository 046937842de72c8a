#include "tests/fuzz/snapshot.h"

#include <cstring>

#include "tests/fuzz/text.h"

namespace weft::fuzz {

std::uint64_t fingerprint(std::span<const Vec4> values, std::uint64_t hash) {
    constexpr std::uint64_t prime = 0x100000001b3u;  // FNV-1a, eight bytes at a time
    for (const Vec4& value : values) {
        std::uint64_t words[2];
        std::memcpy(words, &value, sizeof words);
        for (const std::uint64_t word : words) hash = (hash ^ word) * prime;
    }
    return hash;
}

std::string snapshot(const World& world, std::span<const ClothId> cloths,
                     std::span<const ColliderId> colliders) {
    std::string text = text_of(world.settings()) + "\nhash " + std::to_string(world.state_hash()) +
                       "\nstep " + std::to_string(world.report().step) + '\n';
    for (const ClothId id : cloths) {
        const auto found = world.cloth(id);
        if (!found) continue;
        std::uint64_t hash = 0;
        for (const auto& buffer :
             {found->positions, found->previous_positions, found->velocities, found->normals})
            hash = fingerprint(buffer, hash);
        text += text_of(world.cloth_settings(id).value()) + '\n' + text_of(world.cloth_info(id).value()) +
                '\n' + std::to_string(hash) + '\n';
    }
    for (const ColliderId id : colliders)
        if (const auto found = world.collider(id)) text += text_of(*found) + '\n';
    return text;
}

}  // namespace weft::fuzz
