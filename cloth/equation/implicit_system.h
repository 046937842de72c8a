#pragma once
// The linear system of one implicit step, W dv = b, as solvers see it. Springs and finite elements each
// implement it.

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "cloth/equation/contacts.h"
#include "cloth/equation/grid/grid_windows.h"
#include "cloth/equation/sparse/stencil.h"
#include "cloth/equation/sparse/transfers.h"
#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

struct SavedSprings;

/// The point of the equation that a system is linearised about.
enum class LinearisedAbout {
    base,     ///< x_base, as Kang does: the present positions, for backward Euler
    iterate,  ///< x_base + gamma v, as Newton's method does
};

/// One step of relaxation: next_i = x_i + step D_i^-1 (b_i - (W x)_i) + momentum (x_i - next_i). On entry
/// `next` holds the iterate before x; without momentum it may hold anything. Block Jacobi has step 1 and
/// momentum 0. A semi-iteration is a sequence of such steps.
struct Relaxation {
    float step = 1;
    float momentum = 0;
};

/// Vectors whose dot products with x are summed during a multiplication, while x is in registers; null: 0.
using DottedWith = std::array<const Vec4*, 3>;
struct Products {
    std::array<double, 3> dots{};  ///< of x with these
    double x_wx = 0;               ///< x . W x

    friend Products operator+(Products l, const Products& r) {
        for (std::size_t k = 0; k < l.dots.size(); ++k) l.dots[k] += r.dots[k];
        l.x_wx += r.x_wx;
        return l;
    }
};

/// Vectors are one Vec4 a particle, w 0, in AlignedBuffers (kernels read whole groups of 16). W is symmetric
/// positive definite on the free particles. Rows of pinned ones (inverse mass 0) give 0, as if absent.
class ImplicitSystem {
  public:
    explicit ImplicitSystem(std::uint32_t particles) : particles_(particles) {}
    virtual ~ImplicitSystem() = default;
    ImplicitSystem& operator=(const ImplicitSystem&) = delete;

    /// A system of the same kind for another cloth of this model, with its copy of the model, before its
    /// first step. Constant parts are shared.
    [[nodiscard]] virtual std::unique_ptr<ImplicitSystem> clone(const ClothModel& model) const = 0;
    /// The constant part of a system of springs; nothing for other systems.
    [[nodiscard]] virtual std::optional<SavedSprings> springs() const = 0;
    /// Allocates its own copy of the shared memory that prepare() writes. May run out of memory.
    virtual void make_own(const Fabric& /*fabric*/) {}
    /// Computes what depends on the fabric alone. A step with another fabric does so first.
    virtual void prepare(const Fabric& /*fabric*/) noexcept {}
    /// Lays out the arrays that each linearisation fills and that are only read until the next.
    virtual void lay_out(Scratch& scratch);
    /// lay_out() in memory of its own. A system that was made has such memory; its clones do not.
    void lay_out_alone() { own_scratch_.lay_out(*this); }

    /// Makes W and b of the equation, linearised: with dv from W dv = b, v + dv solves it. Precondition: if
    /// it is linearised about its base, `velocities` are the equation's own.
    virtual void linearise(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                           LinearisedAbout about) = 0;
    /// residual = gamma f - M (v - v_base), at `velocities`. It is the b of a linearisation there, at the
    /// cost of b alone.
    virtual void residual(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                          std::span<Vec4> residual) = 0;

    /// product = W x, unless `product` is empty. Returns the dot products of x with `with` and with W x.
    Products multiply(Parallel& parallel, const DottedWith& with, std::span<const Vec4> x,
                      std::span<Vec4> product);
    /// product = W x. Returns x . W x.
    double multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
        return multiply(parallel, {}, x, product).x_wx;
    }
    /// multiply() with the terms that W leaves out of the slope about an iterate. Relaxation does not need
    /// these: a preconditioner made of W serves both products.
    Products multiply_coupled(Parallel& parallel, const DottedWith& with, std::span<const Vec4> x,
                              std::span<Vec4> product);
    /// One step of relaxation on W x = b.
    void relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x, Relaxation relaxation,
               std::span<Vec4> next);
    /// x = step D^-1 b: relaxation from 0.
    void precondition(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x) const;
    /// precondition() of the group of rows that particle i is in.
    void precondition_group(std::uint32_t i, std::span<const Vec4> b, float step, std::span<Vec4> x) const;
    /// The first step of a V-cycle: remainder = b - W x with x = step D^-1 b. A system whose
    /// relax_corrected() computes x again does not store it.
    virtual void subtract_first_step(Parallel& parallel, std::span<const Vec4> b, float step,
                                     std::span<Vec4> x, std::span<Vec4> remainder);
    /// The last step of a V-cycle: relaxes once from x + P e, and may overwrite x. Precondition: b, step and
    /// x are as subtract_first_step() left them.
    virtual void relax_corrected(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x,
                                 const Correction& correction, std::span<Vec4> next);

    /// The graph of off-diagonal blocks: which particles share one. A grid's stencil has no lists.
    [[nodiscard]] virtual const Stencil& stencil() const noexcept = 0;
    /// Neighbours of one particle, ascending, each once. The particle itself may occur any number of times.
    struct Neighbours {
        const std::uint32_t* first;
        std::uint32_t count, stride;

        [[nodiscard]] std::uint32_t operator[](std::uint32_t k) const noexcept {
            return first[std::size_t{k} * stride];
        }
    };
    [[nodiscard]] virtual Neighbours neighbours_of(std::uint32_t i) const noexcept;
    /// The entry that holds the block between two neighbours; where both rows hold it, that of row i.
    /// Precondition: i and j are neighbours.
    [[nodiscard]] virtual std::uint32_t entry_between(std::uint32_t i, std::uint32_t j) const;
    [[nodiscard]] virtual std::size_t entries() const noexcept { return stencil().neighbours.size(); }
    /// Springs a I + d d^T that stand for the off-diagonal blocks of some slots (16 entries each), and are
    /// the blocks where the system is of springs. Bending makes a negative where it pulls particles apart.
    /// The coarse levels are made from these. blocks[16 k + lane] belongs to slots[k]: d [sqrt(kg)], w a
    /// [kg]. Rows of pinned particles have them as well.
    virtual void spring_blocks(Parallel& parallel, std::span<const std::uint32_t> slots,
                               std::span<Vec4> blocks) = 0;
    /// spring_blocks() of all slots. Allocates, so no step may call it.
    [[nodiscard]] AlignedBuffer<Vec4> all_spring_blocks(Parallel& parallel);

    /// a / constant_scale() where the block between two neighbours is a I however the cloth moves; else 0.
    [[nodiscard]] virtual float constant_block(std::uint32_t /*i*/, std::uint32_t /*j*/) const { return 0; }
    /// Scale of the constant blocks in the last linearisation.
    [[nodiscard]] virtual float constant_scale() const noexcept { return 0; }

    /// Rows of contact, which add to the diagonal; null: there are no colliders.
    [[nodiscard]] virtual const ContactRows* contacts() const noexcept = 0;

    /// b_i [kg m/s], w row sum r_i = sum_j W_ij [kg]; 0 for pinned particles.
    [[nodiscard]] ScratchArray<Vec4>& right_side() noexcept { return right_side_; }
    [[nodiscard]] const ScratchArray<Vec4>& right_side() const noexcept { return right_side_; }
    /// Bytes without scratch.
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;

  protected:
    ImplicitSystem(const ImplicitSystem&) = default;

    // The operations above on a range of rows: whole groups of 16, except for the last. `window` is null
    // where windows_ are empty.
    /// Returns the rows' shares of the products.
    virtual Products multiply_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                   Vec4* product, GridWindow* window) const = 0;
    /// multiply_rows() with the terms that W leaves out.
    virtual Products multiply_coupled_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                           Vec4* product, GridWindow* window) const {
        return multiply_rows(range, with, x, product, window);
    }
    virtual void subtract_product_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Vec4* remainder,
                                       GridWindow* window) const = 0;
    virtual void precondition_rows(const BlockRange& range, const Vec4* b, float step, Vec4* x) const = 0;
    virtual void relax_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Relaxation relaxation,
                            Vec4* next, GridWindow* window) const = 0;

    /// Begins a linearisation of the contacts and returns their rows; null if there are no colliders.
    static const ContactRows* begin_contacts(const StepEquation& equation) {
        return equation.contacts == nullptr ? nullptr : equation.contacts->begin_pass();
    }
    /// Linearises the contacts of a block. Call it before the block's own rows are made.
    static void linearise_contacts(const StepEquation& equation, std::span<const Vec4> velocities,
                                   const BlockRange& range) {
        if (equation.contacts != nullptr) equation.contacts->linearise(equation, velocities, range);
    }

    using MultiplyRows = Products (ImplicitSystem::*)(const BlockRange&, const DottedWith&, const Vec4*,
                                                      Vec4*, GridWindow*) const;
    Products multiply_by(MultiplyRows rows, Parallel& parallel, const DottedWith& with,
                         std::span<const Vec4> x, std::span<Vec4> product);

    ScratchArray<Vec4> right_side_;
    GridWindows windows_;  // empty unless the matrix is kept by diagonals

  private:
    std::uint32_t particles_;
    ScratchArray<Products> partial_sums_;
    OwnScratch own_scratch_;
};

}  // namespace weft
