#include "cloth/mesh/rest/linear_bending.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Core>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

namespace {

/// The elements of a sheet's threads and cells.
class SheetBending {
  public:
    explicit SheetBending(const ClothModel& model) : model_(model) {}

    [[nodiscard]] std::vector<BendingElement> all() {
        elements_.reserve(3 * std::size_t{model_.particle_count});
        for (std::uint32_t row = 0; row < model_.rows; ++row) {
            for (std::uint32_t column = 0; column < model_.columns; ++column) {
                const std::uint32_t i = row * model_.columns + column;
                if (column > 0 && column + 1 < model_.columns) add_thread(i, 1, width(i, row, false));
                if (row > 0 && row + 1 < model_.rows)
                    add_thread(i, model_.columns, ratio_ * width(i, column, true));
                if (row + 1 < model_.rows && column + 1 < model_.columns) add_twist(i);
            }
        }
        return std::move(elements_);
    }

  private:
    [[nodiscard]] double rest(std::uint32_t i, std::uint32_t j) const {
        return rest_length_between(model_, i, j);
    }
    /// Width of the strip of a thread at particle i: half of the way to the threads beside it [m].
    [[nodiscard]] double width(std::uint32_t i, std::uint32_t place, bool along_column) const {
        const std::uint32_t step = along_column ? 1 : model_.columns;
        const std::uint32_t places = along_column ? model_.columns : model_.rows;
        double sum = 0;
        if (place > 0) sum += rest(i, i - step);
        if (place + 1 < places) sum += rest(i, i + step);
        return sum / 2;
    }
    void add_thread(std::uint32_t i, std::uint32_t step, double width) {
        const double before = rest(i, i - step), after = rest(i, i + step), mean = (before + after) / 2;
        const auto first = static_cast<float>(1 / (before * mean)),
                   last = static_cast<float>(1 / (after * mean));
        elements_.push_back({{i - step, i, i + step, i - step},
                             {first, -(first + last), last, 0},
                             static_cast<float>(mean * width)});
    }
    void add_twist(std::uint32_t i) {
        const std::uint32_t columns = model_.columns;
        const double a = (rest(i, i + 1) + rest(i + columns, i + columns + 1)) / 2;
        const double b = (rest(i, i + columns) + rest(i + 1, i + columns + 1)) / 2;
        elements_.push_back({{i, i + 1, i + columns, i + columns + 1},
                             {1, -1, -1, 1},
                             static_cast<float>(std::sqrt(ratio_) * 2 / (a * b))});
    }

    const ClothModel& model_;
    const double ratio_ = static_cast<double>(model_.bending_ratio);
    std::vector<BendingElement> elements_;
};

// A plate bent to kxx, kyy, kxy gives the hinge phi = a kxx + b kyy + c kxy, with a = sum q x^2 / 2, b = sum
// q y^2 / 2, c = sum q x y. Over cylinders along all directions the mean of its square is S = (3 (a^2 + b^2)
// + 2 a b + c^2) / 8. With k = 1.04 / sqrt(3 S) hinges have the plate's energy, on equilateral meshes exactly
// but for the factor 1.04, on irregular ones within some percent: see tests/bench/MEASUREMENTS.md.
double hinge_weight(const Hinge& hinge) {
    const std::array<Eigen::Vector2d, 4> at = flat_hinge(hinge);
    double a = 0, b = 0, c = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double q = static_cast<double>(hinge.q[k]);
        a += q * at[k].x() * at[k].x() / 2;
        b += q * at[k].y() * at[k].y() / 2;
        c += q * at[k].x() * at[k].y();
    }
    return static_cast<double>(hinge.rigidity * hinge.softening) * 1.04 /
           std::sqrt(3 * (3 * (a * a + b * b) + 2 * a * b + c * c) / 8);
}

void store(std::span<const double> weights, std::span<const double> excess, ClothModel& model) {
    model.bending = SharedBuffer<float>(weights.size());
    model.bending_excess = SharedBuffer<float>(excess.size());
    const auto to_float = [](double value) { return static_cast<float>(value); };
    std::ranges::transform(weights, model.bending.data(), to_float);
    std::ranges::transform(excess, model.bending_excess.data(), to_float);
}

std::vector<BendingElement> hinges_of_mesh(const ClothModel& model) {
    std::vector<BendingElement> elements;
    for (const Hinge& hinge : bending_elements(model).hinges)
        elements.push_back({hinge.particles, hinge.q, static_cast<float>(hinge_weight(hinge))});
    return elements;
}

}  // namespace

std::vector<BendingElement> linear_bending(const ClothModel& model) {
    return model.rows > 0 ? SheetBending(model).all() : hinges_of_mesh(model);
}

void store_bending(const std::vector<BendingElement>& elements, ClothModel& model) {
    std::vector<double> weights(model.neighbours.size()), excess(model.particle_count);
    for (const BendingElement& element : elements) {
        const double k = static_cast<double>(element.k);
        double positive = 0;
        for (const float c : element.c) positive += static_cast<double>(std::max(c, 0.0f));
        for (std::size_t a = 0; a < 4; ++a) {
            const double c = static_cast<double>(element.c[a]);
            if (c == 0) continue;
            const std::uint32_t i = element.particles[a];
            excess[i] += k * std::abs(c) * (positive - std::abs(c));
            for (std::size_t b = 0; b < 4; ++b) {
                const std::uint32_t j = element.particles[b];
                if (element.c[b] == 0 || i == j) continue;
                weights[half_edge_between(model, i, j)] -= k * (c * static_cast<double>(element.c[b]));
            }
        }
    }
    store(weights, excess, model);
}

void store_bending(const VertexBending& bending, ClothModel& model) {
    std::vector<double> weights(model.neighbours.size());
    for (const BendingPair& pair : bending.pairs)
        for (const std::uint32_t e :
             {half_edge_between(model, pair.i, pair.j), half_edge_between(model, pair.j, pair.i)})
            weights[e] = pair.weight;
    store(weights, bending.excess, model);
}

float find_bending_per_area(const ClothModel& model) {
    float greatest = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        if (!(model.rest_area[i] > 0)) continue;
        float sum = 0;
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            sum += std::abs(model.bending[e]);
        greatest = std::max(greatest, sum / model.rest_area[i]);
    }
    return greatest;
}

}  // namespace weft
