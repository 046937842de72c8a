#pragma once
// The motion of a whole component, solved exactly.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/cook.h"
#include "cloth/system/contacts.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Springs do not feel a translation u, so along it the system of a component without pins is one of three
/// equations: (sum_i r_i I + G_i) u = sum_i b_i, where contact adds G_i. Few Jacobi iterations leave this,
/// the slowest mode, almost unsolved, and stiff cloth hovers. Solved before the iteration and again after it,
/// u makes free fall exact, and what lands is stopped, however few iterations run; the converged solution
/// stays what it is (deflation: Nicolaides 1987).
class MeanMotion {
  public:
    explicit MeanMotion(const CookedCloth& model);

    /// Before the iteration: finds u of each component in which no particle is pinned, and subtracts
    /// (r_i I + G_i) u from b_i. `contacts` may be null.
    void take_out(Parallel& parallel, const ContactRows* contacts, std::span<Vec4> right_side);
    /// After the iteration: adds u to dv, and solves the rows' sum anew, which the iteration has disturbed.
    void put_back(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> right_side,
                  std::span<Vec4> dv);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Particles of one component within one block of the list.
    struct Piece {
        std::uint32_t component, begin, end;
    };
    /// Rows of one component, or of a part of it.
    struct Rows {
        Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        bool pinned = false;

        void add(const Rows& more);
    };

    /// body(piece) for each piece, a block of the list after the other.
    template <class Body>
    void for_each_block(Parallel& parallel, const Body& body) const;
    /// Solves for u of each component; again: added to the u before. right_side_of(i) is what particle i adds
    /// to the right side, w its row sum.
    template <class RightSide>
    void solve(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> row_sums,
               const RightSide& right_side_of, bool again);

    std::span<const std::uint32_t> particles_;  // of the model, component by component
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> block_pieces_;  // pieces of block k: [block_pieces_[k], block_pieces_[k + 1])
    std::vector<Rows> partials_;               // of the pieces
    std::vector<Vec4> motions_;                // u of each component, w 1; 0 where a particle is pinned
};

}  // namespace weft
