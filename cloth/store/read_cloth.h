#pragma once
// A save's head, written and read, and its cloths, read one by one: all is checked, and all memory made,
// before any state is overwritten.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "cloth/store/save_format.h"
#include "weft/error.h"

namespace weft {

/// Errors: the save is not sound; or it is sound, but of something else.
[[nodiscard]] Error refused(std::string why);
[[nodiscard]] Error does_not_fit(std::string why);

[[nodiscard]] std::uint64_t hash_of(std::span<const std::byte> bytes);
/// Writes the parts of a save by write(SaveWriter), and the head with their hash before them. Error: less
/// room than head.bytes for what `call` writes.
template <class Write>
Result<void> write_save(const char* call, SaveHead head, std::span<std::byte> to, const Write& write) {
    if (to.size() < head.bytes)
        return Error{ErrorCode::invalid_argument, std::string(call) + " needs " + std::to_string(head.bytes) +
                                                      " bytes; " + std::to_string(to.size()) + " were given"};
    write(SaveWriter(to.data() + sizeof head));
    head.hash = hash_of(to.subspan(sizeof head, head.bytes - sizeof head));
    std::memcpy(to.data(), &head, sizeof head);
    return {};
}
/// Error: another mark or version, other bytes than were written.
[[nodiscard]] Result<SaveHead> read_head(std::span<const std::byte> saved, const std::array<char, 8>& mark);
/// Error: fewer bytes are left. A correct checksum does not exclude that: it can be computed for any bytes.
[[nodiscard]] Result<void> check_left(const SaveReader& reader, std::size_t bytes);

/// A cloth's part of a save, which fits a cloth here.
struct ReadCloth {
    Cloth* cloth;
    std::vector<Pin> pins;
    bool is_in_frame;
    std::size_t bodies;  ///< number of bodies whose shares the part has
    SaveReader part;     ///< at its begin
};

/// Reads the part that follows a head, and moves the reader behind it. Nothing is overwritten, but memory for
/// its pins is made. Error, which calls the cloth `name`: the part does not fit the cloth, or is not sound.
[[nodiscard]] Result<ReadCloth> prepare_cloth(Simulation& simulation, Cloth& cloth, const std::string& name,
                                              const ClothHead& head, std::size_t bodies,
                                              const SaveReader& reader);
/// Overwrites the cloth's state.
void overwrite_cloth(Simulation& simulation, ReadCloth& read);

}  // namespace weft
