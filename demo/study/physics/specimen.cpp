#include "demo/study/physics/specimen.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace weft::study {

namespace {

Vec2 point(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

std::uint32_t number_of(double parts) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(parts)));
}

Mesh sheet_mesh(const Strip& strip) {
    const std::uint32_t across = number_of(strip.width / strip.length * strip.cells);
    Mesh mesh = make_sheet({.rows = across + 1, .columns = strip.cells + 1}).value();
    for (std::uint32_t row = 0; row <= across; ++row)
        for (std::uint32_t column = 0; column <= strip.cells; ++column)
            mesh.pattern.push_back(point(strip.length * column / strip.cells, strip.width * row / across));
    return mesh;
}

/// Columns of nodes. Odd columns are shifted by half a side, and have half sides at their ends.
Mesh triangle_mesh(const Strip& strip) {
    const double column = strip.length / strip.cells;
    const std::uint32_t across = number_of(strip.width / column * std::numbers::sqrt3 / 2);
    Mesh mesh;
    std::vector<std::vector<std::uint32_t>> columns;
    for (std::uint32_t k = 0; k <= strip.cells; ++k) {
        std::vector<double> heights{0};
        for (std::uint32_t j = 0; j < across; ++j) heights.push_back(k % 2 == 0 ? j + 1.0 : j + 0.5);
        if (k % 2 == 1) heights.push_back(across);
        std::vector<std::uint32_t> nodes;
        for (const double height : heights) {
            nodes.push_back(static_cast<std::uint32_t>(mesh.pattern.size()));
            mesh.pattern.push_back(point(column * k, strip.width * height / across));
        }
        columns.push_back(nodes);
    }
    // Between two columns, whichever next node is lower ends the next triangle.
    for (std::size_t k = 0; k + 1 < columns.size(); ++k) {
        const auto &left = columns[k], &right = columns[k + 1];
        std::size_t l = 0, r = 0;
        while (l + 1 < left.size() || r + 1 < right.size()) {
            const bool on_left =
                r + 1 == right.size() ||
                (l + 1 < left.size() && mesh.pattern[left[l + 1]].y <= mesh.pattern[right[r + 1]].y);
            const std::uint32_t next = on_left ? left[l + 1] : right[r + 1];
            mesh.triangles.push_back({left[l], right[r], next});
            ++(on_left ? l : r);
        }
    }
    return mesh;
}

}  // namespace

const char* name_of(ForceModel model) {
    switch (model) {
        case ForceModel::sheet:
            return "springs, sheet";
        case ForceModel::mesh:
            return "springs, mesh";
        case ForceModel::elements:
            return "elements, mesh";
    }
    return "";
}

ClothSettings made_of(ForceModel model, const Fabric& fabric) {
    ClothSettings settings;
    settings.fabric = fabric;
    settings.finite_elements.enabled = model == ForceModel::elements;
    settings.air_damping = 0;
    return settings;
}

Mesh strip_mesh(ForceModel model, const Strip& strip, const Place& place) {
    Mesh mesh = model == ForceModel::sheet ? sheet_mesh(strip) : triangle_mesh(strip);
    mesh.positions.clear();
    for (const Vec2& p : mesh.pattern) mesh.positions.push_back(place(p));
    return mesh;
}

float noise(std::uint32_t number) {
    std::uint32_t h = number * 0x9E3779B9u + 0x7F4A7C15u;
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return static_cast<float>((h ^ (h >> 16)) >> 8) / 8388608.0f - 1.0f;
}

}  // namespace weft::study
