#include "collision/shapes/held_shape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "collision/shapes/hull.h"
#include "collision/shapes/ranges.h"
#include "engine/error_text.h"

namespace weft {

namespace {

constexpr std::size_t most_corners = std::size_t{1} << 24;

Error invalid(const std::string& message) {
    return {ErrorCode::invalid_argument, message};
}

Result<HeldShape::Data> make_data(const TriangleMesh& mesh) {
    auto tree = TriangleTree::make("TriangleMesh", mesh.vertices, mesh.triangles, mesh.closed);
    if (!tree) return tree.error();
    return HeldShape::Data(std::move(tree).value());
}

Result<HeldShape::Data> make_data(const ConvexHull& hull) {
    const auto mesh = hull_of(hull.points);
    if (!mesh) return mesh.error();
    auto tree = TriangleTree::make("ConvexHull", mesh->vertices, mesh->triangles, true);
    if (!tree) return tree.error();
    return HeldShape::Data(std::move(tree).value());
}

Result<HeldShape::Data> make_data(const HeightField& field) {
    const std::size_t vertices = std::size_t{field.rows} * field.columns;
    if (field.rows < 2 || field.columns < 2 || vertices > most_corners)
        return invalid("HeightField has " + std::to_string(field.rows) + " rows and " +
                       std::to_string(field.columns) +
                       " columns; it must have at least 2 of each, and 2^24 vertices at most");
    if (field.heights.size() != vertices)
        return invalid("HeightField::heights has " + std::to_string(field.heights.size()) +
                       "; it must have rows x columns, " + std::to_string(vertices));
    if (!(field.spacing >= 1e-4f && field.spacing <= 1e4f))
        return out_of_range("HeightField::spacing", static_cast<double>(field.spacing), "from 1e-4 to 1e4 m");
    for (std::size_t k = 0; k < vertices; ++k)
        if (!(std::abs(field.heights[k]) <= farthest))
            return out_of_range("HeightField::heights[" + std::to_string(k) + "]",
                                static_cast<double>(field.heights[k]), "from -1e5 to 1e5 m");
    return HeldShape::Data(
        HeldHeights{field.rows, field.columns, field.spacing, {field.heights.begin(), field.heights.end()}});
}

/// Distances from the mesh at the corners of cells that go two beyond it.
Result<HeldShape::Data> make_data(const DistanceField& field) {
    if (!field.mesh.closed) return invalid("DistanceField::mesh is not closed; it must be");
    const auto mesh = HeldShape::make(field.mesh);
    if (!mesh) return mesh.error();
    const Vector3 sizes = mesh->box().sizes();
    if (!(field.cell >= sizes.maxCoeff() / 512 && field.cell <= farthest))
        return out_of_range("DistanceField::cell", static_cast<double>(field.cell),
                            "from a 512th of the mesh's longest side, " +
                                number_text(static_cast<double>(sizes.maxCoeff() / 512)) + " m, to 1e5 m");
    constexpr float margin = 2;
    HeldDistances made{};
    made.cell = field.cell;
    made.origin = mesh->box().min() - Vector3::Constant(margin * field.cell);
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cells = static_cast<std::uint32_t>(std::ceil(sizes[axis] / field.cell + 2 * margin));
        made.corners[static_cast<std::size_t>(axis)] = cells + 1;
        count *= cells + 1;
    }
    if (count > most_corners)
        return out_of_range("DistanceField::cell", static_cast<double>(field.cell),
                            "so large that there are 2^24 corners at most, not " + std::to_string(count));
    made.distances.resize(count);
    std::vector<Vec3> row(made.corners[0]);
    std::vector<Vec4> surfaces(row.size());
    std::size_t next = 0;
    for (std::uint32_t z = 0; z < made.corners[2]; ++z)
        for (std::uint32_t y = 0; y < made.corners[1]; ++y) {
            for (std::uint32_t x = 0; x < row.size(); ++x)
                row[x] =
                    to_vec3(made.origin + made.cell * Vector3(static_cast<float>(x), static_cast<float>(y),
                                                              static_cast<float>(z)));
            find_surfaces(*mesh, row, std::numeric_limits<float>::infinity(), surfaces);
            for (const Vec4& surface : surfaces) made.distances[next++] = surface.w;
        }
    return HeldShape::Data(std::move(made));
}

}  // namespace

Result<HeldShape> HeldShape::make(const Shape& shape) {
    auto data = std::visit([](const auto& of_kind) { return make_data(of_kind); }, shape);
    if (!data) return data.error();
    return HeldShape(std::move(data).value(), std::holds_alternative<ConvexHull>(shape));
}

Result<void> HeldShape::deform(std::span<const Vec3> vertices, std::uint64_t step) {
    auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr || convex_) return invalid("the shape is no TriangleMesh; only those deform");
    if (auto done = tree->deform("TriangleMesh", vertices, deforms_in_ == step); !done) return done;
    deforms_in_ = step;
    find_box();
    return {};
}

void HeldShape::find_box() {
    if (const auto* const tree = std::get_if<TriangleTree>(&data_)) {
        box_ = tree->box();
    } else if (const auto* const ground = std::get_if<HeldHeights>(&data_)) {
        const auto [least, most] = std::ranges::minmax(ground->heights);
        const Vector3 far = ground->vertex(ground->rows - 1, ground->columns - 1);
        // Solid however far down.
        box_ = {Vector3(0, std::min(least, -farthest), 0), Vector3(far.x(), most, far.z())};
    } else {
        const auto& field = std::get<HeldDistances>(data_);
        const Vector3 cells(static_cast<float>(field.corners[0] - 1),
                            static_cast<float>(field.corners[1] - 1),
                            static_cast<float>(field.corners[2] - 1));
        // All that is solid lies a cell and more within.
        const Vector3 margin = Vector3::Constant(field.cell);
        box_ = {field.origin + margin, field.origin + field.cell * cells - margin};
    }
}

ShapeInfo HeldShape::info() const {
    ShapeInfo info{.bounds = {to_vec3(box_.min()), to_vec3(box_.max())}};
    if (const auto* const tree = std::get_if<TriangleTree>(&data_)) {
        info.triangles = static_cast<std::uint32_t>(tree->size());
        info.bytes = sizeof(HeldShape) + tree->bytes();
    } else if (const auto* const ground = std::get_if<HeldHeights>(&data_)) {
        info.triangles = ground->triangles();
        info.bytes = sizeof(HeldShape) + ground->heights.capacity() * sizeof(float);
    } else {
        const auto& field = std::get<HeldDistances>(data_);
        info.error = 0.87f * field.cell;
        info.bytes = sizeof(HeldShape) + field.distances.capacity() * sizeof(float);
    }
    return info;
}

}  // namespace weft
