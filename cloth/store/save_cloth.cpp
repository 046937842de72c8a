// Saves of one cloth, and the cloths of a World's save one by one.

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "cloth/store/parts.h"
#include "cloth/store/read_cloth.h"
#include "cloth/store/save.h"
#include "engine/bounds.h"

namespace weft {

namespace {

bool may_cross(const Cloth& a, const Cloth& b) {
    return a.has_features() && b.has_features() && may_meet(a, b) &&
           overlap({a.extent.lower, a.extent.upper}, {b.extent.lower, b.extent.upper});
}

/// Overwrites cloths among others that stay as they are.
void restore_among_others(Simulation& simulation, std::span<ReadCloth> cloths) {
    for (ReadCloth& read : cloths) {
        Cloth& cloth = *read.cloth;
        simulation.wake_near(cloth);  // what lay on it
        overwrite_cloth(simulation, read);
        for (SeamRows* seam : cloth.seams) seam->forget_forces();
        simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& other) {
            if (other.get() != &cloth && may_cross(cloth, *other)) cloth.state.may_cross = 1;
        });
    }
    simulation.clear_contacts();
}

/// The World's cloths by their keys. Error: two have the same.
Result<std::unordered_map<std::uint64_t, Cloth*>> cloths_by_key(Simulation& simulation) {
    std::unordered_map<std::uint64_t, Cloth*> cloths;
    Result<void> checked;
    simulation.cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        const std::uint64_t key = cloth->settings.key;
        if (key != 0 && !cloths.emplace(key, cloth.get()).second)
            checked = Error{ErrorCode::invalid_argument, "two cloths have ClothSettings::key " +
                                                             std::to_string(key) + "; give each its own"};
    });
    if (!checked) return checked.error();
    return cloths;
}

}  // namespace

std::size_t save_size(const Cloth& cloth) {
    SaveSize size;
    for_each_cloth_part(cloth, size);
    return sizeof(SaveHead) + size.bytes();
}

Result<void> save_cloth(const Cloth& cloth, std::span<std::byte> to) {
    const SaveHead head{.mark = cloth_mark,
                        .cloths = 1,
                        .bodies = static_cast<std::uint32_t>(cloth.state.shares.size()),
                        .bytes = save_size(cloth)};
    return write_save("save_cloth", head, to,
                      [&](const SaveWriter& writer) { for_each_cloth_part(cloth, writer); });
}

Result<void> restore_cloth(Simulation& simulation, Cloth& cloth, std::span<const std::byte> saved) {
    const auto head = read_head(saved, cloth_mark);
    if (!head) return head.error();
    const SaveReader reader(saved.subspan(sizeof(SaveHead)));
    ClothHead of_cloth;
    if (auto there = check_left(reader, sizeof of_cloth); !there) return there;
    reader(std::span(&of_cloth, 1));
    auto read = prepare_cloth(simulation, cloth, "its cloth", of_cloth, head->bodies, reader);
    if (!read) return read.error();
    if (reader.left() > 0)
        return refused("goes on for " + std::to_string(reader.left()) + " bytes behind its cloth");
    restore_among_others(simulation, std::span(&*read, 1));
    return {};
}

Result<std::uint32_t> restore_cloths(Simulation& simulation, std::span<const std::byte> saved) {
    const auto head = read_head(saved, save_mark);
    if (!head) return head.error();
    auto here = cloths_by_key(simulation);
    if (!here) return here.error();
    const SaveReader reader(saved.subspan(sizeof(SaveHead)));
    if (auto there = check_left(reader, head->before_cloths); !there) return there.error();
    reader.skip(head->before_cloths);
    std::vector<ReadCloth> cloths;
    for (std::uint32_t number = 0; number < head->cloths; ++number) {
        ClothHead of_cloth;
        if (auto there = check_left(reader, sizeof of_cloth); !there) return there.error();
        reader(std::span(&of_cloth, 1));
        const auto at = here->find(of_cloth.key);
        if (at == here->end()) {
            if (auto there = check_left(reader, of_cloth.bytes); !there) return there.error();
            reader.skip(of_cloth.bytes);
            continue;
        }
        const std::string name = "its cloth of the key " + std::to_string(of_cloth.key);
        const auto is_same = [&](const ReadCloth& read) { return read.cloth == at->second; };
        if (std::ranges::any_of(cloths, is_same)) return refused("has " + name + " twice");
        auto read = prepare_cloth(simulation, *at->second, name, of_cloth, head->bodies, reader);
        if (!read) return read.error();
        cloths.push_back(*std::move(read));
    }
    restore_among_others(simulation, cloths);
    return static_cast<std::uint32_t>(cloths.size());
}

}  // namespace weft
