#pragma once
// Makes recorded calls in a World of its own.

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

    /// Of a record that is whole. Error: what the record holds is not what such a call is given, or the World
    /// refuses it.
    Result<void> make(Call call, std::span<const std::byte> given);
    [[nodiscard]] bool has_world() const { return world_.has_value(); }
    [[nodiscard]] const Replay& replay() const { return replay_; }

  private:
    /// Reads what a call was given, in this order, and makes it.
    template <class... Given, class Act>
    Result<void> with(RecordReader& reader, const Act& act);
    /// Likewise of a call that adds something: its id comes first.
    template <class Id, class... Given, class Act>
    Result<void> adding(RecordReader& reader, const Act& act);
    [[nodiscard]] Result<void> create(RecordReader& reader);
    Result<void> cook(RecordReader& reader);
    Result<void> change_cloth(Call call, RecordReader& reader);
    Result<void> change_collider(Call call, RecordReader& reader);
    Result<void> change_body(Call call, RecordReader& reader);
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
    std::vector<ClothId> cloths_;  // all that were added, as recorded
    StateHash hasher_;
    Replay replay_;
};

}  // namespace weft
