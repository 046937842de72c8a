#include "cloth/store/read_cloth.h"

#include <algorithm>
#include <utility>

#include "cloth/store/check_saved.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

Result<void> check_cloth(const std::string& name, const ClothHead& saved, const ClothHead& here) {
    struct Count {
        std::uint32_t ClothHead::*member;
        const char *of, *what_to_do;
    };
    static constexpr Count counts[] = {
        {&ClothHead::record, "particles in BDF2's record", "set the time scheme and the method that it had"},
        {&ClothHead::tangles, "particles with contact", "set the self-collision that it had"},
        {&ClothHead::held, "particles held by colliders",
         "set the method and the collider response that it had, and add colliders before where it had some"},
        {&ClothHead::rest, "times of rest", "set ClothSettings::sleep_speed as it was"},
        {&ClothHead::skin, "places and normals of its skin",
         "set the maps of leashes and backstops that it had"},
        {&ClothHead::detail, "particles with a budget",
         "set WorldSettings::budget to 0 where it was, and above where it was above"}};
    const auto check = [&](const Count& count) -> Result<void> {
        const std::uint32_t then = saved.*count.member, now = here.*count.member;
        if (then == now) return {};
        return does_not_fit(name + " has " + std::to_string(then) + ' ' + count.of + ", the one here " +
                            std::to_string(now) + "; " + count.what_to_do);
    };
    if (auto same = check({&ClothHead::particles, "particles", "give it the mesh that it had"}); !same)
        return same;
    if (saved.mesh != here.mesh)
        return does_not_fit(name + " has other triangles than the one here; give it the mesh that it had");
    for (const Count& count : counts)
        if (auto same = check(count); !same) return same;
    if (saved.frame > 1)
        return refused("has " + std::to_string(saved.frame) + " frames of " + name + "; it must be 0 or 1");
    return {};
}

/// Bytes of a cloth's part with the pins and the frame that its head announces, and the shares of `bodies`.
std::size_t part_bytes(const ClothState& state, const ClothHead& head, std::size_t bodies) {
    SaveSize size;
    for_each_part(state, size);
    const std::size_t a_pin = sizeof(Pin::particle) + 3 * sizeof(float);
    const std::size_t has = a_pin * state.pins.size() + (state.frame ? sizeof(FrameState) : 0) +
                            std::span(state.shares).size_bytes();
    return size.bytes() + a_pin * head.pins + head.frame * sizeof(FrameState) + bodies * sizeof(BodyShare) -
           has;
}

/// Reads a cloth's state. What bodies gave it is forgotten where the World has not as many bodies as the
/// save.
struct StateReader {
    const SaveReader& part;
    std::size_t bodies;

    template <class T, std::size_t extent>
    void operator()(std::span<T, extent> of_state) const {
        part(of_state);
    }
    void shares(std::span<BodyShare> here) const {
        if (here.size() == bodies) return part(here);
        part.skip(bodies * sizeof(BodyShare));
        std::ranges::fill(here, BodyShare{});
    }
};

}  // namespace

Error refused(std::string why) {
    return {ErrorCode::malformed_file, "the save " + std::move(why)};
}
Error does_not_fit(std::string why) {
    return {ErrorCode::invalid_argument, "the save does not fit: " + std::move(why)};
}

std::uint64_t hash_of(std::span<const std::byte> bytes) {
    StateHash hash;
    hash.add(bytes);
    return hash.value();
}

Result<SaveHead> read_head(std::span<const std::byte> saved, const std::array<char, 8>& mark) {
    SaveHead head;
    if (saved.size() < sizeof head)
        return refused("has " + std::to_string(saved.size()) + " bytes; its head alone takes " +
                       std::to_string(sizeof head));
    std::memcpy(&head, saved.data(), sizeof head);
    if (head.mark != mark && head.mark == cloth_mark)
        return refused("is of one cloth; restore_cloth() restores it");
    if (head.mark != mark && head.mark == save_mark)
        return refused("is of a World; restore() and restore_cloths() restore it");
    if (head.mark != mark)
        return refused("is none of Weft's: it does not begin with " + std::string(mark.begin(), mark.end()));
    if (head.version != save_version)
        return refused("has version " + std::to_string(head.version) + "; this library reads version " +
                       std::to_string(save_version));
    if (head.bytes != saved.size())
        return refused("has " + std::to_string(head.bytes) + " bytes; " + std::to_string(saved.size()) +
                       " were given");
    if (head.hash != hash_of(saved.subspan(sizeof head)))
        return refused("is damaged: its bytes are not those that were written");
    return head;
}

Result<void> check_left(const SaveReader& reader, std::size_t bytes) {
    if (reader.left() >= bytes) return {};
    return refused("is not whole, though its checksum is right: " + std::to_string(bytes) +
                   " bytes are to follow, of which there are " + std::to_string(reader.left()));
}

Result<ReadCloth> prepare_cloth(Simulation& simulation, Cloth& cloth, const std::string& name,
                                const ClothHead& head, std::size_t bodies, const SaveReader& reader) {
    const ClothState& here = cloth.state;
    const ClothHead own(here, cloth.model.fingerprint, cloth.settings.key);
    if (auto fits = check_cloth(name, head, own); !fits) return fits.error();
    const std::size_t bytes = part_bytes(here, head, bodies);
    if (auto there = check_left(reader, bytes); !there) return there.error();
    if (head.bytes != bytes)
        return refused("says that " + name + " has " + std::to_string(head.bytes) + " bytes; it must be " +
                       std::to_string(bytes));
    if (auto sound = check_cloth_part(name, head, here, bodies, reader.after(0)); !sound)
        return sound.error();
    ReadCloth read{&cloth, std::vector<Pin>(head.pins), head.frame != 0, bodies, reader.after(0)};
    visit_pins(read.pins, reader.after(head.bytes_before_pins()));
    cloth.prepare_restore(read.pins);
    if (read.is_in_frame) cloth.seen_colliders.reserve(simulation.state.colliders.size());
    reader.skip(bytes);
    return read;
}

void overwrite_cloth(Simulation& simulation, ReadCloth& read) {
    ClothState& state = read.cloth->state;
    state.pins = std::move(read.pins);
    state.frame.reset();
    if (read.is_in_frame) state.frame.emplace();
    for_each_part(state, StateReader{read.part, read.bodies});
    simulation.state_has_changed(*read.cloth);
}

}  // namespace weft
