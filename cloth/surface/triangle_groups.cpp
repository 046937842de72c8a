#include "cloth/surface/triangle_groups.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "engine/memory/list_checks.h"

namespace weft {

namespace {

constexpr std::uint32_t lanes = TriangleGroups::lanes;
constexpr std::uint32_t no_triangle = ~0u;
constexpr std::uint32_t most_owned = TriangleGroups::most_owned;

template <class T>
SharedBuffer<T> buffer_of(const std::vector<T>& values) {
    return SharedBuffer<T>(values);
}

/// The same triangle, rotated to begin with this corner.
Triangle beginning_with(std::uint32_t corner, const Triangle& t) {
    if (t[0] == corner) return t;
    return t[1] == corner ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

/// The particle that owns each triangle.
class Owners {
  public:
    explicit Owners(const ClothModel& model)
        : model_(model), is_owned_(model.triangles.size()), owned_(model.particle_count) {
        for (std::uint32_t i = 0; i < model.particle_count; ++i) share_out(i);
    }
    /// Triangle k of a particle, which is its first corner; or, if there is none, that particle three times.
    [[nodiscard]] Triangle owned(std::uint32_t particle, std::uint32_t k) const {
        const std::uint32_t t = owned_[particle][k];
        return t == no_triangle ? Triangle{particle, particle, particle}
                                : beginning_with(particle, model_.triangles[t]);
    }
    [[nodiscard]] std::vector<Triangle> left_over() const {
        std::vector<Triangle> result;
        for (std::size_t t = 0; t < is_owned_.size(); ++t)
            if (!is_owned_[t]) result.push_back(model_.triangles[t]);
        return result;
    }

  private:
    /// Particle i takes the triangles whose last corner comes first. The fewest later particles could own
    /// these, so hardly any triangle is left over.
    void share_out(std::uint32_t i) {
        for (std::uint32_t& owned : owned_[i]) {
            auto best = std::pair(no_triangle, no_triangle);
            for (std::uint32_t c = model_.corner_offsets[i]; c < model_.corner_offsets[i + 1]; ++c) {
                const std::uint32_t t = model_.corner_triangles[c];
                if (!is_owned_[t]) best = std::min(best, {std::ranges::max(model_.triangles[t]), t});
            }
            owned = best.second;
            if (owned != no_triangle) is_owned_[owned] = true;
        }
    }

    const ClothModel& model_;
    std::vector<bool> is_owned_;
    std::vector<std::array<std::uint32_t, most_owned>> owned_;
};

/// All rows: triangles, or three times the same corner.
std::vector<Triangle> rows_of(const ClothModel& model) {
    const Owners owners(model);
    std::vector<Triangle> rows;
    for (std::uint32_t first = 0; first < model.particle_count; first += lanes)
        for (std::uint32_t k = 0; k < most_owned; ++k)
            for (std::uint32_t i = first; i < first + lanes; ++i) {
                const std::uint32_t last = model.particle_count - 1;
                rows.push_back(i <= last ? owners.owned(i, k) : Triangle{last, last, last});
            }
    for (const Triangle& triangle : owners.left_over()) rows.push_back(triangle);
    do rows.push_back({});
    while (rows.size() % lanes != 0);
    return rows;
}

/// The rows of each particle's triangles but its own, ascending.
std::vector<std::vector<std::uint32_t>> lists_of_rows(std::span<const Triangle> rows,
                                                      std::uint32_t particles) {
    std::vector<std::vector<std::uint32_t>> lists(particles);
    const std::uint32_t owned_rows = TriangleGroups::own_rows((particles + lanes - 1) / lanes * lanes);
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
        const auto& [a, b, c] = rows[row];
        if (a == b) continue;
        if (row >= owned_rows) lists[a].push_back(row);
        lists[b].push_back(row);
        lists[c].push_back(row);
    }
    return lists;
}

/// Removes the runs of rows that all of a group's particles have from their lists. Returns the first rows.
std::vector<std::uint32_t> take_runs(std::span<std::vector<std::uint32_t>> lists) {
    std::vector<std::uint32_t> runs;
    if (lists.size() < lanes) return runs;
    for (const std::uint32_t first : lists[0]) {
        bool is_shared = true;
        for (std::uint32_t lane = 1; lane < lanes && is_shared; ++lane)
            is_shared = std::ranges::binary_search(lists[lane], first + lane);
        if (is_shared) runs.push_back(first);
    }
    for (std::uint32_t lane = 0; lane < lanes; ++lane)
        for (const std::uint32_t first : runs) std::erase(lists[lane], first + lane);
    return runs;
}

std::uint32_t offset_of(std::uint32_t row) {
    return row * static_cast<std::uint32_t>(sizeof(Vec4));
}

/// Whether these are offsets, as offset_of() returns them, of rows below `end`.
bool are_row_offsets(std::span<const std::uint32_t> offsets, std::uint32_t end) {
    std::uint32_t bits = 0;
    for (const std::uint32_t offset : offsets) bits |= offset;
    return bits % sizeof(Vec4) == 0 && are_below(offsets, end * sizeof(Vec4));
}

}  // namespace

TriangleGroups::TriangleGroups(const ClothModel& model) : particles(model.particle_count) {
    const std::vector<Triangle> triangles = rows_of(model);
    rows = static_cast<std::uint32_t>(triangles.size());
    list_corners(triangles);
    list_sums(lists_of_rows(triangles, particles));
}

void TriangleGroups::list_corners(const std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> listed_corners;
    corner_sources = SharedBuffer<std::uint32_t>(rows / lanes * 3);
    for (std::uint32_t k = 0; k < corner_sources.size(); ++k) {
        const auto corner_in = [&](std::uint32_t lane) { return triangles[k / 3 * lanes + lane][k % 3]; };
        bool is_run = true;
        for (std::uint32_t lane = 1; lane < lanes; ++lane)
            is_run = is_run && corner_in(lane) == corner_in(0) + lane;
        corner_sources[k] =
            is_run ? corner_in(0) : listed + static_cast<std::uint32_t>(listed_corners.size());
        for (std::uint32_t lane = 0; lane < lanes && !is_run; ++lane)
            listed_corners.push_back(offset_of(corner_in(lane)));
    }
    corner_lists = buffer_of(listed_corners);
}

void TriangleGroups::list_sums(std::vector<std::vector<std::uint32_t>> rows_of_particles) {
    const std::uint32_t groups = (particles + lanes - 1) / lanes;
    first_runs = SharedBuffer<std::uint32_t>(groups + 1);
    first_lists = SharedBuffer<std::uint32_t>(groups + 1);
    std::vector<std::uint32_t> all_runs, all_lists;
    for (std::uint32_t g = 0; g < groups; ++g) {
        const auto group =
            std::span(rows_of_particles).subspan(g * lanes, std::min(lanes, particles - g * lanes));
        const std::vector<std::uint32_t> runs = take_runs(group);
        all_runs.insert(all_runs.end(), runs.begin(), runs.end());
        std::size_t most = 0;
        for (const auto& list : group) most = std::max(most, list.size());
        for (std::size_t k = 0; k < most; ++k)
            for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                const bool has = lane < group.size() && k < group[lane].size();
                all_lists.push_back(offset_of(has ? group[lane][k] : rows - 1));
            }
        first_runs[g + 1] = static_cast<std::uint32_t>(all_runs.size());
        first_lists[g + 1] = static_cast<std::uint32_t>(all_lists.size()) / lanes;
    }
    sum_runs = buffer_of(all_runs);
    sum_lists = buffer_of(all_lists);
}

bool TriangleGroups::is_sound(std::uint32_t particle_count) const {
    const std::uint32_t groups = (particle_count + lanes - 1) / lanes;
    if (particles != particle_count || rows % lanes != 0 || rows < own_rows(groups * lanes) ||
        corner_sources.size() != std::size_t{3} * (rows / lanes) || sum_lists.size() % lanes != 0)
        return false;
    const std::size_t listed_corners = corner_lists.size();
    const std::uint32_t last_run = (groups - 1) * lanes;
    const std::size_t last_list = listed_corners < lanes ? 0 : listed + listed_corners - lanes;
    std::uint32_t wrong = 0;
    for (const std::uint32_t source : corner_sources)
        wrong |= (source > last_run ? 1u : 0u) & (source < listed || source > last_list ? 1u : 0u);
    return wrong == 0 && are_offsets(first_runs.span(), groups, sum_runs.size()) &&
           are_offsets(first_lists.span(), groups, sum_lists.size() / lanes) &&
           are_below(sum_runs.span(), rows - lanes + 1) &&
           are_row_offsets(corner_lists.span(), particle_count) && are_row_offsets(sum_lists.span(), rows);
}

}  // namespace weft
