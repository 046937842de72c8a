#pragma once
// Replays recorded calls in a World of its own.

#include <cstdint>
#include <optional>
#include <vector>

#include "cloth/record/record_reader.h"
#include "weft/cooked_cloth.h"
#include "weft/recording.h"
#include "weft/world.h"

namespace weft {

class Replayer {
  public:
    explicit Replayer(const ReplayOptions& options) : options_(options) {}

    /// Makes the call of a complete record. Error: the record's bytes are no arguments of this call, or the
    /// World refuses the call.
    Result<void> make(Call call, std::span<const std::byte> given);
    [[nodiscard]] bool has_world() const { return world_.has_value(); }
    [[nodiscard]] const Replay& replay() const { return replay_; }

  private:
    /// Reads the arguments of a call, in this order, and makes the call.
    template <class... Given, class Act>
    Result<void> with(RecordReader& reader, const Act& act);
    /// Like with(), for a call that adds an object: the recorded id comes first.
    template <class Id, class... Given, class Act>
    Result<void> adding(RecordReader& reader, const Act& act);
    [[nodiscard]] Result<void> create(RecordReader& reader);
    Result<void> cook(RecordReader& reader);
    Result<void> change_cloth(Call call, RecordReader& reader);
    Result<void> change_collider(Call call, RecordReader& reader);
    Result<void> change_body(Call call, RecordReader& reader);
    Result<void> change_seam(Call call, RecordReader& reader);
    Result<void> choose(RecordReader& reader);
    Result<void> step(RecordReader& reader);
    Result<void> compare(std::uint64_t rest, std::span<const HashOfCloth> cloths);
    [[nodiscard]] WorldSettings with_threads(WorldSettings settings) const {
        settings.threads = options_.threads;
        return settings;
    }

    ReplayOptions options_;
    std::optional<World> world_;
    ReplayedIds ids_;
    std::vector<CookedCloth> cooked_;
    std::vector<ClothId> cloths_;  // recorded ids of all cloths that were added
    StateHash hasher_;
    Replay replay_;
};

}  // namespace weft
