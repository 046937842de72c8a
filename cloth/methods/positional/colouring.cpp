#include "cloth/methods/positional/colouring.h"

#include <algorithm>

#include "cloth/methods/positional/half_edges.h"

namespace weft {

namespace {

constexpr std::uint32_t no_colour = ~0u;

/// A proper edge colouring that grows spring by spring.
class Colouring {
  public:
    explicit Colouring(const ClothModel& model)
        : model_(model), twins_(twin_half_edges(model)), colour_of_(model.neighbours.size(), no_colour) {
        std::uint32_t most_springs = 0;
        for (std::uint32_t i = 0; i < model.particle_count; ++i)
            most_springs = std::max(most_springs, row_end(i) - row_begin(i));
        springs_of_.assign(most_springs, 0);
        free_at_first_.assign(most_springs, false);
        free_at_second_.assign(most_springs, false);
    }

    /// Gives a spring the rarest colour free at both ends. If there is none, one is made free or added.
    void colour(std::uint32_t first, std::uint32_t half_edge) {
        const std::uint32_t second = model_.neighbours[half_edge];
        mark_free(first, free_at_first_);
        mark_free(second, free_at_second_);
        std::uint32_t chosen = no_colour;
        for (std::uint32_t c = 0; c < springs_of_.size(); ++c) {
            if (!free_at_first_[c] || !free_at_second_[c]) continue;
            if (chosen == no_colour || springs_of_[c] < springs_of_[chosen]) chosen = c;
        }
        if (chosen == no_colour) chosen = make_free(first, second);
        if (chosen == no_colour) chosen = add_colour();
        set(half_edge, chosen);
    }

    [[nodiscard]] std::vector<std::uint32_t> result() && { return std::move(colour_of_); }

  private:
    [[nodiscard]] std::uint32_t row_begin(std::uint32_t i) const { return model_.spring_offsets[i]; }
    [[nodiscard]] std::uint32_t row_end(std::uint32_t i) const { return model_.spring_offsets[i + 1]; }

    void mark_free(std::uint32_t particle, std::vector<bool>& is_free) const {
        is_free.assign(springs_of_.size(), true);
        for (std::uint32_t e = row_begin(particle); e < row_end(particle); ++e)
            if (colour_of_[e] != no_colour) is_free[colour_of_[e]] = false;
    }

    /// The half-edge of that colour at a particle, or row_end.
    [[nodiscard]] std::uint32_t find(std::uint32_t particle, std::uint32_t colour) const {
        std::uint32_t e = row_begin(particle);
        while (e < row_end(particle) && colour_of_[e] != colour) ++e;
        return e;
    }

    // Kempe's exchange: a is free at the first end and b at the second. A path of colours a, b, a, .. begins
    // at the second end. Exchanging the two along it makes a free at both ends, unless it leads to the first.
    std::uint32_t make_free(std::uint32_t first, std::uint32_t second) {
        for (std::uint32_t a = 0; a < free_at_first_.size(); ++a) {
            if (!free_at_first_[a]) continue;
            for (std::uint32_t b = 0; b < free_at_second_.size(); ++b) {
                if (free_at_second_[b] && exchange_along_path(second, a, b, first)) return a;
            }
        }
        return no_colour;
    }

    bool exchange_along_path(std::uint32_t start, std::uint32_t a, std::uint32_t b, std::uint32_t forbidden) {
        path_.clear();
        std::uint32_t particle = start, colour = a;
        for (std::uint32_t e; (e = find(particle, colour)) != row_end(particle);) {
            path_.push_back(e);
            particle = model_.neighbours[e];
            colour = colour == a ? b : a;
        }
        if (particle == forbidden) return false;
        for (const std::uint32_t e : path_) set(e, colour_of_[e] == a ? b : a);
        return true;
    }

    std::uint32_t add_colour() {
        springs_of_.push_back(0);
        return static_cast<std::uint32_t>(springs_of_.size()) - 1;
    }

    void set(std::uint32_t half_edge, std::uint32_t colour) {
        if (colour_of_[half_edge] != no_colour) --springs_of_[colour_of_[half_edge]];
        ++springs_of_[colour];
        colour_of_[half_edge] = colour_of_[twins_[half_edge]] = colour;
    }

    const ClothModel& model_;
    std::vector<std::uint32_t> twins_;
    std::vector<std::uint32_t> colour_of_;   // by half-edge
    std::vector<std::uint32_t> springs_of_;  // by colour: the number of its springs
    std::vector<bool> free_at_first_, free_at_second_;
    std::vector<std::uint32_t> path_;
};

/// Calls body(i, e) for every spring once, e being its half-edge at its lower particle i, in ascending order.
template <class Body>
void for_each_spring(const ClothModel& model, const Body& body) {
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            if (i < model.neighbours[e] && model.kinds[e] != SpringKind::bending) body(i, e);
}

std::vector<std::uint32_t> colours_of_mesh(const ClothModel& model) {
    Colouring colouring(model);
    for_each_spring(model, [&](std::uint32_t i, std::uint32_t e) { colouring.colour(i, e); });
    return std::move(colouring).result();
}

/// Springs of one kind and direction form lines, whose springs take two colours in turn, so that a colour is
/// regular in memory.
std::uint32_t grid_colour(const ClothModel& model, std::uint32_t low, std::uint32_t half_edge) {
    const std::uint32_t high = model.neighbours[half_edge];
    const std::uint32_t row = low / model.columns, column = low % model.columns;
    const bool along_row = high / model.columns == row;
    switch (model.kinds[half_edge]) {
        case SpringKind::structural:
            return along_row ? column % 2 : 2 + row % 2;
        case SpringKind::shear:
            return (high % model.columns > column ? 4 : 6) + row % 2;
        case SpringKind::bending:
            break;
    }
    return no_colour;
}

std::vector<std::uint32_t> colours_of_grid(const ClothModel& model) {
    std::vector<std::uint32_t> colours(model.neighbours.size(), no_colour);
    for_each_spring(model, [&](std::uint32_t i, std::uint32_t e) { colours[e] = grid_colour(model, i, e); });
    return colours;
}

}  // namespace

SpringColours colour_springs(const ClothModel& model) {
    const std::vector<std::uint32_t> colour_of =
        model.columns > 0 ? colours_of_grid(model) : colours_of_mesh(model);
    std::vector<std::uint32_t> counts;
    for_each_spring(model, [&](std::uint32_t, std::uint32_t e) {
        if (colour_of[e] >= counts.size()) counts.resize(colour_of[e] + 1);
        ++counts[colour_of[e]];
    });

    SpringColours result;
    result.offsets.push_back(0);
    for (const std::uint32_t count : counts) {
        const std::uint32_t groups = (count + SpringColours::lanes - 1) / SpringColours::lanes;
        result.offsets.push_back(result.offsets.back() + groups * SpringColours::lanes);
    }
    result.first = AlignedBuffer<std::uint32_t>(result.springs());
    result.second = AlignedBuffer<std::uint32_t>(result.springs());
    result.half_edges = AlignedBuffer<std::uint32_t>(result.springs());
    std::ranges::fill(result.first.span(), model.particle_count);
    std::ranges::fill(result.second.span(), model.particle_count + 1);
    std::ranges::fill(result.half_edges.span(), SpringColours::no_half_edge);

    std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for_each_spring(model, [&](std::uint32_t i, std::uint32_t e) {
        const std::uint32_t spring = next[colour_of[e]]++;
        result.first[spring] = i;
        result.second[spring] = model.neighbours[e];
        result.half_edges[spring] = e;
    });
    return result;
}

}  // namespace weft
