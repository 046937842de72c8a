#pragma once
// The loops of pair_rows.h, many pairs at a time; compiled once for each kind of machine.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// What holds for one pair through a substep.
struct PairLaw {
    float radius = 0;    ///< features nearer than this are pushed apart [m]; 0: they are left alone
    float friction = 0;  ///< Coulomb coefficient
};

/// Sixteen pairs through a substep, by columns, and as they were last linearised. Lanes past the last pair
/// weigh nothing and never push.
struct alignas(64) PairGroup {
    static constexpr std::uint32_t lanes = 16;

    std::uint32_t corners[4][lanes];
    float weights[4][lanes];
    float normal[3][lanes];
    float radius[lanes], friction[lanes];
    float mass[lanes];                   // 1 / sum b^2 w [kg]; 0: nothing of it can move
    float gap[lanes];                    // at the base positions [m]
    float spring[lanes], damper[lanes];  // [kg]; spring 0: it does not push
    float at_rest[lanes];                // impulse along the normal for features that do not move, as last
                                         // linearised; infinity: never yet [kg m/s]
};

/// What a pair has for a corner of weight b: b times the impulse, and |b| times the matrix. In one cache
/// line, since corners read it in no order.
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

/// What a particle gets of all its pairs.
struct PushedParticle {
    Vec4 diagonal, off_diagonal, impulse;  // as in PairShare
};

/// Where pairs are taken from: `numbers` are those in the list.
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

/// Adds up what a particle has of its places, 4 * pair + corner, and lists those that push. Returns how many.
std::uint32_t gather_shares(std::span<const std::uint32_t> places, const PairShare* shares,
                            PushedParticle& sum, PushedCorner* pushed);

/// products[pair] = K u for those of a range that push; returns the sum of u . K u.
double multiply_groups(const Vec4* vector, const BlockRange& pairs, const PairGroup* groups, Vec4* products);

/// Some rows of particles, and the pairs that push them.
struct PushedRows {
    std::uint32_t begin, end;
    std::uint32_t first;             // the particle that the target begins with
    const std::uint32_t* particles;  // of rows
    const std::uint32_t* starts;     // of rows: where their corners begin
    const std::uint32_t* counts;     // of rows: how many they have
    const PushedCorner* corners;
};

/// target[particle - first] += sum of weight times products of the corners.
void add_pushed(const PushedRows& rows, const Vec4* products, Vec4* target);

}  // namespace weft
