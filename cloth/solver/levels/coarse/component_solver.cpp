#include "cloth/solver/levels/coarse/component_solver.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "engine/memory/list_checks.h"
#include "engine/vector.h"

namespace weft {

namespace {

using Factor = Eigen::Map<Eigen::MatrixXd>;
using ConstFactor = Eigen::Map<const Eigen::MatrixXd>;

/// The number of components that a thread takes at a time.
constexpr std::uint32_t components_at_a_time = 16;

}  // namespace

SmallComponents::SmallComponents(const Components& of_level, const CoarseLinks& of) {
    std::vector<std::uint32_t> count_of(of_level.count(), none), local(of_level.of_node.size()), node_list;
    number = SharedBuffer<std::uint32_t>(of_level.of_node.size());
    std::ranges::fill(number.span(), none);
    std::vector<Component> starts(1);
    for (std::uint32_t c = 0; c < of_level.count(); ++c) {
        if (of_level.size(c) > most_nodes) continue;
        count_of[c] = static_cast<std::uint32_t>(starts.size()) - 1;
        for (std::uint32_t k = 0; k < of_level.size(c); ++k) {
            const std::uint32_t node = of_level.nodes[of_level.offsets[c] + k];
            local[node] = k;
            number[node] = static_cast<std::uint32_t>(node_list.size());
            node_list.push_back(node);
        }
        const std::uint64_t rows = std::uint64_t{3} * of_level.size(c);
        starts.push_back(
            {static_cast<std::uint32_t>(node_list.size()), 0, starts.back().factor + rows * rows});
    }

    const auto component_of = [&](const Link& link) { return count_of[of_level.of_node[link.first]]; };
    for (const Link& link : of.links)
        if (component_of(link) != none) ++starts[component_of(link) + std::size_t{1}].link;
    for (std::size_t c = 1; c < starts.size(); ++c) starts[c].link += starts[c - 1].link;
    std::vector<LocalLink> local_links(starts.back().link);
    std::vector<std::uint32_t> next;
    for (const Component& start : starts) next.push_back(start.link);
    for (std::size_t k = 0; k < of.links.size(); ++k) {
        const Link& link = of.links[k];
        if (component_of(link) != none)
            local_links[next[component_of(link)]++] = {of.places[k], local[link.first], local[link.second]};
    }
    components = SharedBuffer<Component>(starts);
    nodes = SharedBuffer<std::uint32_t>(node_list);
    links = SharedBuffer<LocalLink>(local_links);
}

bool SmallComponents::is_sound(std::uint32_t level_nodes, std::size_t places) const {
    if (components.empty() || number.size() != level_nodes || !are_below(nodes.span(), level_nodes))
        return false;
    std::uint32_t wrong = 0;
    for (const std::uint32_t place : number)
        wrong |= (place >= nodes.size() ? 1u : 0u) & (place != none ? 1u : 0u);
    const Component &first = components[0], &last = components[components.size() - 1];
    wrong |= (first.node | first.link) != 0 || first.factor != 0 || last.node != nodes.size() ||
             last.link != links.size();
    for (std::size_t c = 1; c < components.size() && wrong == 0; ++c) {
        const Component &begin = components[c - 1], &end = components[c];
        const std::uint32_t count = end.node - begin.node;
        if (count == 0 || count > most_nodes ||
            end.factor - begin.factor != std::uint64_t{9} * count * count || begin.link > end.link ||
            end.link > links.size())
            return false;
        for (std::uint32_t k = begin.link; k < end.link; ++k)
            wrong |= links[k].first >= count || links[k].second >= count || links[k].place >= places;
    }
    return wrong == 0;
}

void ComponentSolver::factorise(Parallel& parallel, const CoarseMatrix& matrix, const CoarsePairs& pairs) {
    const auto body = [&](const BlockRange& range) {
        for (std::uint32_t c = range.begin; c < range.end; ++c) factorise(c, matrix, pairs);
    };
    parallel.ranges(count(), body, components_at_a_time);
}

void ComponentSolver::factorise(std::uint32_t component, const CoarseMatrix& matrix,
                                const CoarsePairs& pairs) {
    const Component &begin = lists_.components[component],
                    &end = lists_.components[component + std::size_t{1}];
    const Eigen::Index rows = 3 * static_cast<Eigen::Index>(end.node - begin.node);
    Factor block(&factors_[begin.factor], rows, rows);
    block.setZero();
    for (std::uint32_t k = begin.node; k < end.node; ++k) {
        const Eigen::Index i = 3 * static_cast<Eigen::Index>(k - begin.node);
        block.block<3, 3>(i, i) = matrix.ground_rows[lists_.nodes[k]].full();
    }
    for (std::uint32_t k = begin.link; k < end.link; ++k) {
        const Eigen::Matrix3d stiffness = matrix.links[lists_.links[k].place].full();
        const Eigen::Index i = 3 * static_cast<Eigen::Index>(lists_.links[k].first),
                           j = 3 * static_cast<Eigen::Index>(lists_.links[k].second);
        block.block<3, 3>(i, i) += stiffness;
        block.block<3, 3>(j, j) += stiffness;
        block.block<3, 3>(i, j) -= stiffness;
        block.block<3, 3>(j, i) -= stiffness;
    }
    for (const CoarsePairs::Row& row : pairs.rows()) {
        const auto place = [&](std::uint32_t k) { return lists_.number[row.nodes[k]] - begin.node; };
        bool is_within = true;
        for (std::uint32_t k = 0; k < row.count; ++k) is_within &= place(k) < end.node - begin.node;
        if (!is_within) continue;
        const Eigen::Matrix3d stiffness = row.stiffness.full();
        for (std::uint32_t k = 0; k < row.count; ++k) {
            const auto i = 3 * static_cast<Eigen::Index>(place(k));
            const double bound = static_cast<double>(row.reach * std::abs(row.weights[k]));
            block.block<3, 3>(i, i) -= bound * stiffness;
            for (std::uint32_t m = 0; m < row.count; ++m) {
                const double factor = static_cast<double>(row.weights[k] * row.weights[m]);
                block.block<3, 3>(i, 3 * static_cast<Eigen::Index>(place(m))) += factor * stiffness;
            }
        }
    }
    // Shifted: a node of pinned particles alone has a row of zeros, and W was summed in single precision.
    const double largest = block.diagonal().maxCoeff();
    block.diagonal().array() += largest > 0 ? 1e-6 * largest : 1.0;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(block);
}

void ComponentSolver::solve(Parallel& parallel, std::span<const Vec4> b, std::span<Vec4> x) const {
    const auto body = [&](const BlockRange& range) {
        for (std::uint32_t c = range.begin; c < range.end; ++c) solve(c, b, x);
    };
    parallel.ranges(count(), body, components_at_a_time);
}

void ComponentSolver::solve(std::uint32_t component, std::span<const Vec4> b, std::span<Vec4> x) const {
    const Component &begin = lists_.components[component],
                    &end = lists_.components[component + std::size_t{1}];
    const Eigen::Index rows = 3 * static_cast<Eigen::Index>(end.node - begin.node);
    const ConstFactor lower(&factors_[begin.factor], rows, rows);
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 * most_nodes, 1> values(rows);
    for (std::uint32_t k = begin.node; k < end.node; ++k)
        values.segment<3>(3 * static_cast<Eigen::Index>(k - begin.node)) =
            xyz(b[lists_.nodes[k]]).cast<double>();
    lower.triangularView<Eigen::Lower>().solveInPlace(values);
    lower.transpose().triangularView<Eigen::Upper>().solveInPlace(values);
    for (std::uint32_t k = begin.node; k < end.node; ++k) {
        const Eigen::Vector3d value = values.segment<3>(3 * static_cast<Eigen::Index>(k - begin.node));
        x[lists_.nodes[k]] = to_vec4(value.cast<float>(), 0);
    }
}

}  // namespace weft
