#pragma once
// Sheets placed in space, from which scenes are made.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

/// Maps a point of the pattern, u along the length and v along the width [m], to space.
using PlaceOf = std::function<Eigen::Vector3d(double u, double v)>;

/// A sheet `length` by `width` [m], its rows along the length, with the flat pattern as its rest shape.
struct Piece {
    double length, width;
    std::uint32_t columns, rows;  ///< particles along length and width
    [[nodiscard]] double edge() const { return length / (columns - 1); }
};
/// A piece of about `particles` particles in squares. columns - 1 is a multiple of `parts`, so that folds can
/// be between cells.
[[nodiscard]] Piece piece(double length, double width, std::uint32_t particles, std::uint32_t parts = 1);
[[nodiscard]] Mesh placed_sheet(const Piece& piece, const PlaceOf& place);
/// A vertex of the piece's sheet.
[[nodiscard]] inline std::uint32_t vertex_at(const Piece& piece, std::uint32_t row, std::uint32_t column) {
    return row * piece.columns + column;
}
[[nodiscard]] std::vector<std::uint32_t> column_of(const Piece& piece, std::uint32_t column);

/// Sheets of squares as one general mesh; their first vertices are the layers.
[[nodiscard]] PlacedCloth joined(const std::vector<Mesh>& sheets);

/// The default distance of self-collision for a mesh of edges of this length [m].
[[nodiscard]] double usual_distance(double edge);

/// `particles`, or where that is 0, a scene's own number.
[[nodiscard]] inline std::uint32_t or_else(std::uint32_t particles, std::uint32_t usual) {
    return particles == 0 ? usual : particles;
}

/// A scene's sheets are one cloth, or several of one World.
enum class Made { one_mesh, cloths };
[[nodiscard]] std::string named(const std::string& name, Made made);
[[nodiscard]] std::vector<PlacedCloth> layered(const std::vector<Mesh>& sheets, Made made);

/// A sheet that lies level, turned about its middle, which is over the origin.
[[nodiscard]] Mesh level_sheet(const Piece& sheet, double height, double turn);

/// World settings with still air.
[[nodiscard]] WorldSettings still_air();
/// World settings without air and gravity; cloth in this World should have no air_damping.
[[nodiscard]] WorldSettings zero_gravity();
[[nodiscard]] Collider ground();
[[nodiscard]] Vec3 to_point(const Eigen::Vector3d& p);

}  // namespace weft::demo
