#pragma once
// Self-collision avoidance (Kang, section IV): find the pairs that are too close, by patches and a hashed
// grid or by a sorted sweep, and push them apart.

#include <cstdint>
#include <optional>
#include <span>

#include "collision/particles/pair_response.h"
#include "collision/search/hash_grid.h"
#include "collision/search/patches.h"
#include "collision/search/rest_filter.h"
#include "collision/search/search_kernels.h"
#include "collision/search/sweep_grid.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/self_collision.h"
#include "weft/types.h"

namespace weft {

/// Searches of avoidance: see SelfCollisionMethod.
enum class SelfCollisionSearch : std::uint8_t { exact, shifted_grids, sorted_sweep };

struct SelfContactCounts {
    std::uint32_t pairs = 0;    ///< contacts that were resolved
    std::uint32_t dropped = 0;  ///< particles whose list was full; their other contacts are not resolved
    std::uint32_t peak = 0;     ///< most contacts of one particle
};

/// Buffers for the contacts of one cloth. They are made only when its self-collision is switched on.
class SelfContacts {
  public:
    static constexpr std::uint32_t capacity = 16;  ///< contacts kept per particle

    /// Reserves memory for this search, and for all that need none of their own. Precondition: positions at
    /// rest, by which patches are cut, are finite.
    explicit SelfContacts(std::span<const Vec4> rest_positions,
                          SelfCollisionSearch search = SelfCollisionSearch::exact);
    [[nodiscard]] bool has_memory_for(SelfCollisionSearch search) const noexcept {
        return search != SelfCollisionSearch::sorted_sweep || sweep_.has_value();
    }

    /// Finds all pairs closer than `distance`. Each is in both particles' lists, in a fixed order.
    /// Precondition: there is memory for the search.
    void find(Parallel& parallel, std::span<const Vec4> positions, const RestFilter& filter, float distance,
              SelfCollisionSearch search);

    /// Applies the response of the pairs found: it moves particles to `distance`, stops approaching
    /// velocities, and adds Coulomb friction. positions.w is the inverse mass. The changes of a pair's
    /// particles are opposite and along the line between them, so linear and angular momentum are kept;
    /// friction, which acts across that line, keeps linear momentum. Precondition: the positions are those
    /// given to find(). h: length of the substep [s].
    SelfContactCounts respond(Parallel& parallel, float distance, float friction, float h,
                              std::span<Vec4> positions, std::span<Vec4> velocities);

    /// Before respond(): calls visit(i, j, change) for each pair whose approach respond() will stop. `change`
    /// is that of i's velocity [m/s]; j gets the opposite momentum. i is free; if both are, it is the lower.
    template <class Visit>
    void for_each_stopped(const ResponseSettings& settings, std::span<const Vec4> positions,
                          std::span<const Vec4> velocities, const Visit& visit) const {
        PairBatch batch;
        const auto resolve = [&] {
            respond_to_pairs(settings, positions.data(), velocities.data(), batch);
            for (std::uint32_t k = 0; k < batch.count; ++k) {
                const Vector3 change = xyz(batch.velocity_change[k]);
                if (!change.isZero(0)) visit(batch.i[k], batch.j[k], change);
            }
            batch.count = 0;
        };
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
            for (const std::uint32_t j : contacts(i))
                if (i < j && add_pair(i, j, positions, batch) && batch.count == PairBatch::capacity)
                    resolve();
        }
        resolve();
    }

    /// The contacts of particle i that find() found, for tests and for drawing.
    [[nodiscard]] std::span<const std::uint32_t> contacts(std::uint32_t particle) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    // Value in counts_: the list is full, and there were more contacts.
    static constexpr std::uint8_t overflowed = capacity + 1;
    // Value in counts_, within find(): the particle is still to be searched.
    static constexpr std::uint8_t unsearched = 255;

    [[nodiscard]] bool search_patches(Parallel& parallel, const RestFilter& filter, float distance);
    void search_grid(Parallel& parallel, CellShape shape, const RestFilter& filter, float distance);
    void search_sweep(Parallel& parallel, const RestFilter& filter, float distance);
    bool add(std::uint32_t particle, std::uint32_t contact);
    void add(const BlockHits& hits);
    template <class Visit>
    void for_each_touching(const BlockRange& block, const Visit& visit) const;
    bool add_pair(std::uint32_t i, std::uint32_t j, std::span<const Vec4> positions, PairBatch& batch) const;
    [[nodiscard]] bool is_mutual(std::uint32_t particle, std::uint32_t contact) const noexcept;

    Patches patches_;
    HashGrid grid_;
    std::optional<SweepGrid> sweep_;
    AlignedBuffer<std::uint32_t> contacts_;  // `capacity` per particle, ascending
    AlignedBuffer<std::uint8_t> counts_;     // contacts of each particle, or `overflowed`
    AlignedBuffer<Vec4> displacements_,
        velocity_changes_;  // of particles with contacts; others are not written
    AlignedBuffer<SelfContactCounts> block_counts_;
    AlignedBuffer<std::uint32_t> left_out_;  // by block: bits of the patches that are left to the grid
};

}  // namespace weft
