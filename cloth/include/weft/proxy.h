#pragma once
// Simulated meshes of a wanted size, made from fine ones that are drawn over them.

#include <cstdint>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/mesh.h"

namespace weft {

struct ProxySettings {
    /// Wanted number of vertices of the proxy, 12 to 2^20. It has within a tenth of these where the mesh's
    /// borders have not more by themselves.
    std::uint32_t particles = 3000;
    /// Greatest thickness of a doubled mesh [m], 0 to 1: where two layers that face away from each other are
    /// nearer, the one of less area is left out. A layer stays that goes on at an end, since the mesh is
    /// folded there; where it ends at rims, over which the other layer begins, the mesh is doubled. 0: all
    /// layers stay.
    float thickness = 0.004f;
};

/// Sizes and counts of a proxy that make_proxy() made.
struct ProxyReport {
    float cell = 0;                        ///< length of edge that the wanted number has [m]
    float shortest_edge = 0;               ///< of the proxy [m]
    float longest_edge = 0;                ///< of the proxy [m]
    std::uint32_t parts = 0;               ///< connected parts that the proxy has
    std::uint32_t left_out_parts = 0;      ///< parts below the size of two cells, as buttons are
    std::uint32_t left_out_triangles = 0;  ///< triangles of the mesh that are a doubled mesh's other layer
    std::uint32_t closed_holes = 0;        ///< borders shorter than three cells, as buttonholes are
    /// Greatest distance of a vertex of the fine mesh from the proxy [m]. Bind with a little more as
    /// DrawnMeshSettings::reach, not with far more: a lining's vertices face as the far side of a sleeve
    /// does.
    float reach = 0;
};

/// Makes a mesh of the wanted number of vertices, with even edges, over the same surface: what is simulated
/// where `fine` is drawn (DrawnMesh). Vertices lie on the fine surface, and those of borders on its borders.
/// Edges have two triangles or one; where `fine` has more at an edge, as a collar sewn on has, parts are
/// separated. The rest shape is `fine` in space: patterns and texture coordinates are not kept. The same mesh
/// gives the same proxy.
///
/// The surface is cut into cells of equal size round the vertices (Valette, Chassery, "Approximated
/// centroidal Voronoi diagrams", 2004), which takes half a millisecond a vertex of the proxy, and is for
/// tools. Errors: a mesh of which no cloth could be made, naming the element; a setting out of
/// range; a mesh of which nothing is left at this size.
[[nodiscard]] WEFT_API Result<Mesh> make_proxy(const Mesh& fine, const ProxySettings& settings = {},
                                               ProxyReport* report = nullptr);

}  // namespace weft
