#pragma once
// The motion of a whole component, solved exactly.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/contacts.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

struct MotionRows;

/// Springs exert no force along a translation u, so for a component without pins u solves three equations:
/// (sum_i r_i I + G_i) u = sum_i b_i, where contact adds G_i. Few iterations leave this slowest mode almost
/// unsolved, and stiff cloth hovers. MeanMotion solves for u before the iteration and again after it: free
/// fall is exact and landing cloth is stopped, however few iterations run. The converged solution does not
/// change (deflation: Nicolaides 1987).
class MeanMotion {
  public:
    explicit MeanMotion(const ClothModel& model);

    /// Before the iteration: finds u of each component in which no particle is pinned, and subtracts
    /// (r_i I + G_i) u from b_i. `contacts` may be null.
    void take_out(Parallel& parallel, const ContactRows* contacts, std::span<Vec4> right_side);
    /// After the iteration: solves the rows' sum anew, which the iteration has disturbed, and adds all u and
    /// the velocities to dv.
    void put_back(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> right_side,
                  std::span<const Vec4> velocities, std::span<Vec4> dv);
    [[nodiscard]] std::uint32_t particles() const noexcept { return particles_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr std::uint32_t none = ~0u;

    /// Particles of one component within one block.
    struct Piece {
        std::uint32_t component, begin, end;  ///< of groups_
    };
    /// Summed rows of one component, or of a piece.
    struct Rows {
        Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        std::uint32_t pinned = none;  ///< a pinned particle of the piece, or none

        void add(const Rows& more);
    };

    void add_pieces(std::uint32_t block, std::vector<std::uint32_t>& seen_in);
    [[nodiscard]] bool is_pinned(std::uint32_t component) const { return pinned_[component] != none; }
    [[nodiscard]] bool any_free() const;
    [[nodiscard]] std::uint32_t pinned_of(const Piece& piece, const Vec4* right_side) const;
    [[nodiscard]] Rows sum(const Piece& piece, const ContactRows* contacts, const Vec4* right_side,
                           const Vec4* dv) const;
    [[nodiscard]] MotionRows motion_rows(std::uint32_t block, const ContactRows* contacts) const;
    /// Finds u of each component in which nothing is pinned. dv: null before the iteration; after it, the
    /// result is added to the earlier u.
    void solve(Parallel& parallel, const ContactRows* contacts, const Vec4* right_side, const Vec4* dv);

    std::uint32_t particles_;
    SharedBuffer<std::uint32_t> components_;   // by particle; behind the last the number of components
    std::vector<Piece> pieces_;                // block by block
    std::vector<std::uint32_t> block_pieces_;  // pieces of block k: [block_pieces_[k], block_pieces_[k + 1])
    std::vector<std::uint32_t> groups_;        // of 16 particles, in which a piece has any
    std::vector<Rows> partials_;               // by piece
    std::vector<Rows> sums_;                   // by component
    AlignedBuffer<Vec4> motions_;              // u by component; 0 where a particle is pinned, and last a 0
    std::vector<std::uint32_t> pinned_;        // by component: a pinned particle, or none
};

}  // namespace weft
