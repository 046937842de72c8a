#pragma once
// The loops of pair_rows.h, many pairs at a time; compiled once for each kind of machine.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Contact parameters of one pair, constant through a substep.
struct PairLaw {
    float radius = 0;    ///< features nearer than this are pushed apart [m]; 0: they are left alone
    float friction = 0;  ///< Coulomb coefficient
};

/// Sixteen pairs in a substep, one a lane, with their last linearisation. Lanes past the last pair have
/// weight 0 and never push.
struct alignas(64) PairGroup {
    static constexpr std::uint32_t lanes = 16;

    std::uint32_t corners[4][lanes];
    float weights[4][lanes];
    float normal[3][lanes];
    float radius[lanes], friction[lanes];
    float mass[lanes];                   // 1 / sum b^2 w [kg]; 0: no corner can open the gap
    float gap[lanes];                    // at the base positions [m]
    float spring[lanes], damper[lanes];  // [kg]; spring 0: the pair does not push
    float at_rest[lanes];  // impulse along the normal at zero velocity, as last linearised; infinity: not
                           // linearised yet [kg m/s]
};

/// A pair's share for its corners: a corner of weight b gets b times the impulse and |b| times the matrix. A
/// share fills one cache line, because corners read shares in no order.
struct alignas(64) PairShare {
    Vec4 weights;
    Vec4 diagonal;      // xx, yy, zz of K [kg]; w: the spring
    Vec4 off_diagonal;  // xy, xz, yz
    Vec4 impulse;       // c - K u [kg m/s]
};

/// A corner of a pair that pushes.
struct PushedCorner {
    std::uint32_t pair;
    float weight;
};

/// Sums of a particle's shares over all its pairs.
struct PushedParticle {
    Vec4 diagonal, off_diagonal, impulse;  // as in PairShare
};

/// Input of fill_groups(): `numbers` index the pairs in the list.
struct PairSources {
    const std::uint32_t* numbers;
    const PairList* list;
    const PairLaw* laws;
    const Vec4* base_positions;  // w = inverse mass
};

/// Fills groups with the pairs of a range, which begins at a whole group.
void fill_groups(const PairSources& from, const BlockRange& pairs, PairGroup* groups);

/// The constants of PairRows::linearise.
struct PairStiffness {
    float gamma;
    float spring_per_mass;  // [1]
};

/// Linearises the pairs of a range at these velocities of particles.
void linearise_groups(const PairStiffness& stiffness, const Vec4* velocities, const BlockRange& pairs,
                      PairGroup* groups, PairShare* shares);

/// Sums a particle's shares over its places, 4 * pair + corner, and lists those pushed. Returns their number.
std::uint32_t gather_shares(std::span<const std::uint32_t> places, const PairShare* shares,
                            PushedParticle& sum, PushedCorner* pushed);

/// products[pair] = K u for the pairs of a range that push; returns the sum of u . K u.
double multiply_groups(const Vec4* vector, const BlockRange& pairs, const PairGroup* groups, Vec4* products);

/// Some rows of particles, and the pairs that push them.
struct PushedRows {
    std::uint32_t begin, end;
    std::uint32_t first;             // the particle that the target begins with
    const std::uint32_t* particles;  // by row
    const std::uint32_t* starts;     // by row: where its corners begin
    const std::uint32_t* counts;     // by row: the number of its corners
    const PushedCorner* corners;
};

/// target[particle - first] += sum of weight times products of the corners.
void add_pushed(const PushedRows& rows, const Vec4* products, Vec4* target);

}  // namespace weft
