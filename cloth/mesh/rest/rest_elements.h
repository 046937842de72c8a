#pragma once
// The rest shape for finite elements: triangles in the pattern's axes, and pairs of them that share an edge.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "cloth/mesh/rest/rigidity.h"
#include "engine/vector.h"

namespace weft {

/// Sides of a triangle from its corner 0 to corners 1 and 2, in the pattern's axes [m].
struct RestSides {
    Eigen::Vector2f to1, to2;
};

/// A triangle's sides. A mesh with a pattern has them in the panel's own axes. Otherwise the mesh is the rest
/// shape, and warp runs along the rows of a grid, or upwards in a general mesh, or along +X in triangles of
/// it that lie flat.
[[nodiscard]] RestSides rest_sides(const ClothModel& model, std::uint32_t triangle);

/// Least height over longest side at which a triangle bends as stiffly as the fabric.
constexpr double least_bending_height = 0.02;

/// Factor of a triangle's bending, from 0 to 1: 1 for a sound triangle, and the cube of its height over that
/// of a sound one for a sliver. Between two needles bending is stiff by the inverse cube of that height,
/// while mass hardly depends on it.
[[nodiscard]] double sliver_factor(const RestSides& sides);

/// Two triangles about their shared edge: (0, 1, 2) and (1, 0, 3), in the order in which the first is wound.
struct Hinge {
    std::array<std::uint32_t, 4> particles;
    /// Bergou et al. 2006: |sum_k q_k x_k| is the edge's length times its angle, while that is small. From
    /// each triangle's own panel; sum_k q_k is 0.
    std::array<float, 4> q;
    std::array<float, 2> feet;  ///< of each apex: distance of its foot from the edge's start, over its height
    float length;               ///< of the edge, mean of both panels' [m]
    float least_height;         ///< of the two triangles over the edge, about [m]
    float angle;                ///< at rest; 0 on a flat pattern
    float rigidity;             ///< of the fabric across the edge, over that along its warp
    float weight;               ///< see Bending; includes `rigidity` and `softening`
    float softening;            ///< the lesser sliver_factor of the two triangles
};

/// Positions of the hinge's particles when it is flat: its edge lies along x from particle 0 to 1 [m].
[[nodiscard]] std::array<Eigen::Vector2d, 4> flat_hinge(const Hinge& hinge);

/// A triangle's curvature is the mean over it of what its edges bend (Grinspun et al. 2006, discrete shape
/// operators), each edge's bend shared between its two triangles by their areas: Lambda = sum_e phi_e / (A +
/// A') m_e m_e^T, m_e being the edge's normal in the plane and phi_e its length times its angle. The energy
/// B/2 sum_T A |Lambda|^2 is thus
///
///     B/2 ( sum_e w_e phi_e^2 + 2 sum_ef w_ef phi_e phi_f )
///     w_e = 1 / (A + A'),   w_ef = A (m_e . m_f)^2 w_e w_f
///
/// over hinges e and pairs of them in one triangle. With a rigidity B D, see rigidity.h, w_e is multiplied by
/// m m^T : D m m^T, the mean of both triangles', and (m_e . m_f)^2 becomes m_e m_e^T : D m_f m_f^T.
/// Equilateral meshes bend to any cylinder as the plate does, grids of right triangles to those along their
/// threads (to diagonal ones half as stiff again); irregular meshes are too stiff, by a part that goes with
/// the square of their irregularity. Hinges by themselves (w_ef = 0) make a grid with chessboard diagonals a
/// sixth too soft along its threads, because its particles of four and of eight neighbours give way between
/// one another.
struct HingePair {
    std::uint32_t first, second;
    float weight;
};
struct Bending {
    static constexpr std::uint32_t no_hinge = ~0u;

    std::vector<Hinge> hinges;            ///< in ascending order of their edges
    std::vector<Rigidity> rigidities;     ///< of hinges, with x along the edge; empty: all are 1
    std::vector<HingePair> pairs;         ///< by triangles
    std::vector<std::uint32_t> of_sides;  ///< [3 triangle + side]: its hinge, or no_hinge at a border
};
[[nodiscard]] Bending bending_elements(const ClothModel& model);

}  // namespace weft
