#include "collision/shapes/held_shape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "collision/shapes/hull.h"
#include "collision/shapes/triangles/ranges.h"
#include "engine/error_text.h"
#include "engine/small_matrices.h"

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
        if (!(std::abs(field.heights[k]) <= farthest_collider))
            return out_of_range("HeightField::heights[" + std::to_string(k) + "]",
                                static_cast<double>(field.heights[k]), "from -1e5 to 1e5 m");
    return HeldShape::Data(
        HeldHeights{field.rows, field.columns, field.spacing, {field.heights.begin(), field.heights.end()}});
}

/// A grid of cells, without distances yet, that extends `margin` cells beyond a box.
HeldDistances cells_about(const Eigen::AlignedBox3f& box, float cell, float margin) {
    HeldDistances made{box.min() - Vector3::Constant(margin * cell), cell, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        const float cells = std::ceil(box.sizes()[static_cast<int>(k)] / cell + 2 * margin);
        made.corners[k] = static_cast<std::uint32_t>(cells) + 1;
    }
    return made;
}

std::size_t corners_of(const HeldDistances& cells) {
    return std::size_t{cells.corners[0]} * cells.corners[1] * cells.corners[2];
}

Vector3 corner_of(const HeldDistances& cells, std::size_t x, std::size_t y, std::size_t z) {
    return cells.origin +
           cells.cell * Vector3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

void find_distances(const HeldShape& mesh, HeldDistances& cells) {
    cells.distances.resize(corners_of(cells));
    std::vector<Vec3> row(cells.corners[0]);
    std::vector<Vec4> surfaces(row.size());
    for (std::size_t z = 0; z < cells.corners[2]; ++z)
        for (std::size_t y = 0; y < cells.corners[1]; ++y) {
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = to_vec3(corner_of(cells, x, y, z));
            find_surfaces(mesh, row, std::numeric_limits<float>::infinity(), surfaces);
            for (std::size_t x = 0; x < row.size(); ++x)
                cells.distances[cells.index(x, y, z)] = surfaces[x].w;
        }
}

Result<HeldShape::Data> make_data(const DistanceField& field) {
    if (!field.mesh.closed) return invalid("DistanceField::mesh is not closed; it must be");
    const auto mesh = HeldShape::make(field.mesh);
    if (!mesh) return mesh.error();
    const float longest = mesh->box().sizes().maxCoeff();
    if (!(field.cell >= longest / 512 && field.cell <= farthest_collider))
        return out_of_range("DistanceField::cell", static_cast<double>(field.cell),
                            "from a 512th of the mesh's longest side, " +
                                number_text(static_cast<double>(longest / 512)) + " m, to 1e5 m");
    HeldDistances made = cells_about(mesh->box(), field.cell, 2);
    if (corners_of(made) > most_corners)
        return out_of_range(
            "DistanceField::cell", static_cast<double>(field.cell),
            "so large that there are 2^24 corners at most, not " + std::to_string(corners_of(made)));
    find_distances(*mesh, made);
    return HeldShape::Data(std::move(made));
}

/// A body is convex if all its corners lie behind every face.
bool is_convex_body(const TriangleTree& tree) {
    const float rounding = 1e-4f * tree.box().diagonal().norm();
    for (std::uint32_t t = 0; t < tree.size(); ++t) {
        const auto corner = [&](int k) { return to_vector(tree.vertices()[tree.triangle(t)[k]]); };
        const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
        for (const Vec3& vertex : tree.vertices())
            if (normal.dot(to_vector(vertex) - corner(0)) > rounding) return false;
    }
    return true;
}

/// Centroid and covariance of a surface, weighted by area.
struct Spread {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Matrix3d about_middle = Eigen::Matrix3d::Zero();
};
Spread spread_of(const TriangleTree& tree) {
    Spread spread;
    Eigen::Matrix3d about_origin = Eigen::Matrix3d::Zero();
    double area = 0;
    for (std::uint32_t t = 0; t < tree.size(); ++t) {
        std::array<Eigen::Vector3d, 3> x;
        for (std::size_t k = 0; k < 3; ++k)
            x[k] = to_vector(tree.vertices()[tree.triangle(t)[k]]).cast<double>();
        const double own = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
        const Eigen::Vector3d sum = x[0] + x[1] + x[2];
        area += own;
        spread.middle += own / 3 * sum;
        about_origin += own / 12 * (sum * sum.transpose());
        for (const Eigen::Vector3d& corner : x) about_origin += own / 12 * (corner * corner.transpose());
    }
    spread.middle /= area;
    spread.about_middle = about_origin / area - spread.middle * spread.middle.transpose();
    return spread;
}

}  // namespace

Result<HeldShape> HeldShape::make(const Shape& shape) {
    auto data = std::visit([](const auto& of_kind) { return make_data(of_kind); }, shape);
    if (!data) return data.error();
    HeldShape made(std::move(data).value(), std::holds_alternative<ConvexHull>(shape));
    const auto* const tree = std::get_if<TriangleTree>(&made.data_);
    made.is_edged_ = tree != nullptr && tree->is_closed() && tree->vertices().size() <= most_edged_corners &&
                     is_convex_body(*tree);
    made.find_coarse();
    made.find_rod();
    made.find_corners();
    return made;
}

/// The rod runs through the surface's centroid, along the axis of its greatest variance.
void HeldShape::find_rod() {
    const auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr || !tree->is_closed()) return;
    const Spread spread = spread_of(*tree);
    const SymmetricAxes axes = symmetric_axes(spread.about_middle);
    const Vector3 middle = spread.middle.cast<float>();
    const Matrix3 across = axes.vectors.cast<float>();  // the rod's axis is the last
    Eigen::AlignedBox3f box;
    for (const Vec3& vertex : tree->vertices())
        box.extend(Vector3(across.transpose() * (to_vector(vertex) - middle)));
    constexpr std::size_t points = 9;
    constexpr float from_ends = 0.1f;  // of the length: there distances are to the sides, not to the ends
    std::array<Vec3, points> along;
    std::array<Vec4, points> surfaces;
    for (std::size_t k = 0; k < points; ++k) {
        const float part = from_ends + (1 - 2 * from_ends) * static_cast<float>(k) / (points - 1);
        along[k] = to_vec3(middle + (box.min().z() + part * box.sizes().z()) * across.col(2));
    }
    find_surfaces(*this, along, std::numeric_limits<float>::infinity(), surfaces);
    float radius = std::numeric_limits<float>::infinity();
    for (const Vec4& surface : surfaces) radius = std::min(radius, -surface.w);
    if (!(radius > 0)) return;
    const float width = std::max(box.max().head<2>().maxCoeff(), -box.min().head<2>().minCoeff());
    const float first = box.min().z() + radius, last = box.max().z() - radius;
    const float one = 0.5f * (first + last);
    rod_ = InnerRod{middle + std::min(first, one) * across.col(2),
                    middle + std::max(last, one) * across.col(2), radius, std::max(width, radius)};
}

void HeldShape::find_corners() {
    if (is_ground()) return;
    const auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree != nullptr && tree->vertices().size() <= most_edged_corners) {
        corners_.assign(tree->vertices().begin(), tree->vertices().end());
        return;
    }
    for (int k = 0; k < 27; ++k) {
        const Vector3 direction(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1),
                                static_cast<float>(k / 9 - 1));
        if (direction.isZero(0)) continue;
        if (tree != nullptr) {
            corners_.push_back(*std::ranges::max_element(
                tree->vertices(), {}, [&](const Vec3& v) { return direction.dot(to_vector(v)); }));
            continue;
        }
        const Vector3 out = box_.center() + 0.5f * box_.sizes().cwiseProduct(direction);
        const Vec3 from = to_vec3(out);
        Vec4 surface{};
        find_surfaces(*this, {&from, 1}, std::numeric_limits<float>::infinity(), {&surface, 1});
        corners_.push_back(to_vec3(out - surface.w * xyz(surface)));
    }
}

void HeldShape::find_coarse() {
    constexpr float cells = 32;  // to the longest side
    const auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr || !tree->is_closed()) return;
    HeldDistances coarse = cells_about(box_, box_.sizes().maxCoeff() / cells, 0.5f);
    find_distances(*this, coarse);
    coarse_ = std::move(coarse);
}

// The distance at q is at least that at a corner less the way from the corner to q.
bool HeldShape::may_be_deeper(const Vector3& q, float than) const {
    if (outside_.known()) return !outside_.come_near(q, than);  // all that near to it is inside as well
    if (coarse_.distances.empty()) return true;                 // they are still being computed
    std::array<std::size_t, 3> first{};
    for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        const float at = std::floor((q[axis] - coarse_.origin[axis]) / coarse_.cell);
        const float most = static_cast<float>(std::max(coarse_.corners[k], 2u) - 2);
        first[k] = static_cast<std::size_t>(std::clamp(at, 0.0f, most));
    }
    float least = -std::numeric_limits<float>::infinity();
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t x = first[0] + (corner & 1), y = first[1] + (corner >> 1 & 1),
                          z = first[2] + (corner >> 2);
        const float way = (q - corner_of(coarse_, x, y, z)).norm();
        least = std::max(least, coarse_.distances[coarse_.index(x, y, z)] - 1.001f * way);
    }
    return least < -than;
}

Result<void> HeldShape::deform(std::span<const Vec3> vertices, std::uint64_t step) {
    auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr || convex_) return invalid("the shape is no TriangleMesh; only those deform");
    if (auto valid = tree->validate_deform("TriangleMesh", vertices); !valid) return valid;
    std::vector<Vec3> before;
    if (original_.empty()) before.assign(tree->vertices().begin(), tree->vertices().end());
    if (tree->is_closed()) outside_.reserve();
    tree->deform(vertices, deforms_in_ == step);
    if (original_.empty()) original_ = std::move(before);
    if (tree->is_closed()) outside_.find(*tree);
    deforms_in_ = step;
    find_box();
    return {};
}

HeldShape::Deformation HeldShape::deformation() const noexcept {
    if (original_.empty()) return {};
    const auto* const tree = std::get_if<TriangleTree>(&data_);
    return {tree->vertices(), tree->displacements(), deforms_in_};
}

std::size_t HeldShape::deformable() const noexcept {
    const auto* const tree = std::get_if<TriangleTree>(&data_);
    return tree == nullptr || convex_ ? 0 : tree->vertices().size();
}

void HeldShape::prepare_deformation() {
    original_.reserve(deformable());
    auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr) return;
    tree->reserve_displacements();
    if (tree->is_closed()) outside_.reserve();
}

void HeldShape::put_back(const Deformation& deformation) {
    auto* const tree = std::get_if<TriangleTree>(&data_);
    if (tree == nullptr || (deformation.vertices.empty() && original_.empty())) return;
    if (deformation.vertices.empty()) {
        tree->put_back(original_, {});
        original_.clear();
        outside_.clear();
    } else {
        if (original_.empty()) original_.assign(tree->vertices().begin(), tree->vertices().end());
        tree->put_back(deformation.vertices, deformation.displacements);
        if (tree->is_closed()) outside_.find(*tree);
    }
    deforms_in_ = deformation.step;
    find_box();
}

void HeldShape::find_box() {
    if (const auto* const tree = std::get_if<TriangleTree>(&data_)) {
        box_ = tree->box();
    } else if (const auto* const ground = std::get_if<HeldHeights>(&data_)) {
        const auto [least, most] = std::ranges::minmax(ground->heights);
        const Vector3 far = ground->vertex(ground->rows - 1, ground->columns - 1);
        // The ground is solid at any depth.
        box_ = {Vector3(0, std::min(least, -farthest_collider), 0), Vector3(far.x(), most, far.z())};
    } else {
        const auto& field = std::get<HeldDistances>(data_);
        const Vector3 cells(static_cast<float>(field.corners[0] - 1),
                            static_cast<float>(field.corners[1] - 1),
                            static_cast<float>(field.corners[2] - 1));
        // The solid lies at least a cell within the grid.
        const Vector3 margin = Vector3::Constant(field.cell);
        box_ = {field.origin + margin, field.origin + field.cell * cells - margin};
    }
}

ShapeInfo HeldShape::info() const {
    ShapeInfo info{.bounds = {to_vec3(box_.min()), to_vec3(box_.max())}};
    if (const auto* const tree = std::get_if<TriangleTree>(&data_)) {
        info.triangles = static_cast<std::uint32_t>(tree->size());
        info.bytes = sizeof(HeldShape) + tree->bytes() + coarse_.distances.capacity() * sizeof(float) +
                     original_.capacity() * sizeof(Vec3) + outside_.bytes();
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
