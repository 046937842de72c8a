#include "tests/fuzz/random/random_settings.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace weft::fuzz {

namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// A box of n x n cells to each side, wound outwards.
void add_closed_box(Random& random, OwnedShape& made) {
    const auto n = 1 + random.below(5);
    const Vec3 half{random.of_any_size(0.01f, 0.5f), random.of_any_size(0.01f, 0.5f),
                    random.of_any_size(0.01f, 0.5f)};
    // Vertices of sides are at one position where sides meet, and so are one.
    const auto point = [&](std::uint32_t side, std::uint32_t u, std::uint32_t v) {
        const auto along = [&](std::uint32_t k) {
            return -1 + 2 * static_cast<float>(k) / static_cast<float>(n);
        };
        const float sign = side % 2 == 0 ? 1.0f : -1.0f;
        std::array<float, 3> p{};
        p[side / 2] = sign;
        p[(side / 2 + 1) % 3] = along(u);
        p[(side / 2 + 2) % 3] = along(v);
        return Vec3{half.x * p[0], half.y * p[1], half.z * p[2]};
    };
    for (std::uint32_t side = 0; side < 6; ++side) {
        const auto first = static_cast<std::uint32_t>(made.vertices.size());
        for (std::uint32_t u = 0; u <= n; ++u)
            for (std::uint32_t v = 0; v <= n; ++v) made.vertices.push_back(point(side, u, v));
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            made.triangles.push_back(side % 2 == 0 ? Corners{a, b, c} : Corners{a, c, b});
        };
        for (std::uint32_t u = 0; u < n; ++u)
            for (std::uint32_t v = 0; v < n; ++v) {
                const std::uint32_t a = first + u * (n + 1) + v, b = a + n + 1;
                add(a, b, b + 1);
                add(a, b + 1, a + 1);
            }
    }
}

void add_open_sheet(Random& random, OwnedShape& made) {
    made.closed = false;
    const std::uint32_t rows = 2 + random.below(7), columns = 2 + random.below(7);
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c)
            made.vertices.push_back(
                {0.1f * static_cast<float>(c), random.between(-0.05f, 0.05f), 0.1f * static_cast<float>(r)});
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        for (std::uint32_t c = 0; c + 1 < columns; ++c) {
            const std::uint32_t a = r * columns + c, b = a + columns;
            made.triangles.push_back({a, b, b + 1});
            made.triangles.push_back({a, b + 1, a + 1});
        }
}

void spoil(Random& random, OwnedShape& made) {
    switch (made.kind) {
        case OwnedShape::Kind::mesh:
        case OwnedShape::Kind::distances:
            if (random.chance(0.5) && made.closed)
                std::swap(made.triangles.back()[0], made.triangles.back()[1]);
            else
                made.triangles.back()[2] = static_cast<std::uint32_t>(made.vertices.size());
            break;
        case OwnedShape::Kind::hull:
            for (Vec3& p : made.vertices) p.y = 0;
            break;
        case OwnedShape::Kind::ground:
            made.heights.back() = no_number;
            break;
    }
}

}  // namespace

Shape OwnedShape::shape() const {
    const TriangleMesh mesh{.vertices = vertices, .triangles = triangles, .closed = closed};
    switch (kind) {
        case Kind::hull:
            return ConvexHull{.points = vertices};
        case Kind::ground:
            return HeightField{.rows = rows, .columns = columns, .spacing = size, .heights = heights};
        case Kind::distances:
            return DistanceField{.mesh = mesh, .cell = size};
        default:
            return mesh;
    }
}

Drawn<OwnedShape> random_shape(Random& random) {
    Drawn<OwnedShape> drawn;
    OwnedShape& made = drawn.value;
    switch (random.below(6)) {
        case 0:
            made.kind = OwnedShape::Kind::hull;
            for (std::uint32_t n = 8 + random.below(60); n > 0; --n)
                made.vertices.push_back(random.point(0.3f));
            break;
        case 1:
            made.kind = OwnedShape::Kind::ground;
            made.rows = 2 + random.below(9);
            made.columns = 2 + random.below(9);
            for (std::uint32_t k = made.rows * made.columns; k > 0; --k)
                made.heights.push_back(random.between(-0.1f, 0.1f));
            break;
        case 2:
            made.kind = OwnedShape::Kind::distances;
            made.size = 0.05f;
            add_closed_box(random, made);
            break;
        case 3:
            add_open_sheet(random, made);
            break;
        default:
            add_closed_box(random, made);
            break;
    }
    drawn.answer = Answer::accepted;
    if (random.chance(0.1)) {
        spoil(random, made);
        drawn.answer = Answer::refused;
    }
    return drawn;
}

Drawn<std::vector<Vec3>> random_deformation(Random& random, const OwnedShape& shape) {
    Drawn<std::vector<Vec3>> drawn;
    drawn.value = shape.vertices;
    drawn.answer = shape.kind == OwnedShape::Kind::mesh ? Answer::accepted : Answer::refused;
    const float scale = random.between(0.5f, 1.5f);
    const Vec3 by = random.point(0.05f);
    for (Vec3& p : drawn.value) p = {scale * p.x + by.x, scale * p.y + by.y, scale * p.z + by.z};
    if (drawn.value.empty() || !random.chance(0.1)) return drawn;
    drawn.answer = Answer::refused;
    if (random.chance(0.5))
        drawn.value.pop_back();
    else
        drawn.value.back().x = no_number;
    return drawn;
}

}  // namespace weft::fuzz
