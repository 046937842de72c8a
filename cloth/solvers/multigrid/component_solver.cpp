#include "cloth/solvers/multigrid/component_solver.h"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "engine/vector.h"

namespace weft {

namespace {

using Factor = Eigen::Map<Eigen::MatrixXd>;
using ConstFactor = Eigen::Map<const Eigen::MatrixXd>;

/// How many components a thread takes at a time.
constexpr std::uint32_t components_at_a_time = 16;

}  // namespace

ComponentSolver::ComponentSolver(const Components& components, const GalerkinLists& lists) {
    std::vector<std::uint32_t> number(components.count(), none), local(components.of_node.size());
    std::uint32_t count = 0, node_count = 0;
    for (std::uint32_t c = 0; c < components.count(); ++c) {
        if (components.size(c) > most_nodes) continue;
        number[c] = count++;
        node_count += components.size(c);
    }
    components_.resize(count + std::size_t{1});
    number_.assign(components.of_node.size(), none);
    nodes_.reserve(node_count);
    for (std::uint32_t c = 0; c < components.count(); ++c) {
        if (number[c] == none) continue;
        const std::size_t rows = std::size_t{3} * components.size(c);
        components_[number[c] + std::size_t{1}].factor = components_[number[c]].factor + rows * rows;
        for (std::uint32_t k = 0; k < components.size(c); ++k) {
            const std::uint32_t node = components.nodes[components.offsets[c] + k];
            local[node] = k;
            number_[node] = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back(node);
        }
        components_[number[c] + std::size_t{1}].node = static_cast<std::uint32_t>(nodes_.size());
    }
    factors_ = AlignedBuffer<double>(components_.back().factor);

    const auto number_of = [&](const Link& link) { return number[components.of_node[link.first]]; };
    for (const Link& link : lists.links)
        if (number_of(link) != none) ++components_[number_of(link) + std::size_t{1}].link;
    for (std::uint32_t c = 0; c < count; ++c) components_[c + std::size_t{1}].link += components_[c].link;
    links_.resize(components_.back().link);
    std::vector<std::uint32_t> next(count);
    for (std::uint32_t c = 0; c < count; ++c) next[c] = components_[c].link;
    for (std::size_t k = 0; k < lists.links.size(); ++k) {
        const Link& link = lists.links[k];
        if (number_of(link) != none)
            links_[next[number_of(link)]++] = {lists.places[k], local[link.first], local[link.second]};
    }
}

void ComponentSolver::factorise(Parallel& parallel, const CoarseMatrix& matrix, const CoarsePairs& pairs) {
    const auto body = [&](const BlockRange& range) {
        for (std::uint32_t c = range.begin; c < range.end; ++c) factorise(c, matrix, pairs);
    };
    parallel.ranges(count(), body, components_at_a_time);
}

void ComponentSolver::factorise(std::uint32_t component, const CoarseMatrix& matrix,
                                const CoarsePairs& pairs) {
    const Component &begin = components_[component], &end = components_[component + std::size_t{1}];
    const Eigen::Index rows = 3 * static_cast<Eigen::Index>(end.node - begin.node);
    Factor block(&factors_[begin.factor], rows, rows);
    block.setZero();
    for (std::uint32_t k = begin.node; k < end.node; ++k) {
        const Eigen::Index i = 3 * static_cast<Eigen::Index>(k - begin.node);
        block.block<3, 3>(i, i) = matrix.ground_rows[nodes_[k]].full();
    }
    for (std::uint32_t k = begin.link; k < end.link; ++k) {
        const Eigen::Matrix3d stiffness = matrix.links[links_[k].place].full();
        const Eigen::Index i = 3 * static_cast<Eigen::Index>(links_[k].first),
                           j = 3 * static_cast<Eigen::Index>(links_[k].second);
        block.block<3, 3>(i, i) += stiffness;
        block.block<3, 3>(j, j) += stiffness;
        block.block<3, 3>(i, j) -= stiffness;
        block.block<3, 3>(j, i) -= stiffness;
    }
    for (const CoarsePairs::Row& row : pairs.rows()) {
        const auto place = [&](std::uint32_t k) { return number_[row.nodes[k]] - begin.node; };
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
    // A node of pinned particles alone has a row of zeros, and W was summed in single precision.
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
    const Component &begin = components_[component], &end = components_[component + std::size_t{1}];
    const Eigen::Index rows = 3 * static_cast<Eigen::Index>(end.node - begin.node);
    const ConstFactor lower(&factors_[begin.factor], rows, rows);
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 * most_nodes, 1> values(rows);
    for (std::uint32_t k = begin.node; k < end.node; ++k)
        values.segment<3>(3 * static_cast<Eigen::Index>(k - begin.node)) = xyz(b[nodes_[k]]).cast<double>();
    lower.triangularView<Eigen::Lower>().solveInPlace(values);
    lower.transpose().triangularView<Eigen::Upper>().solveInPlace(values);
    for (std::uint32_t k = begin.node; k < end.node; ++k) {
        const Eigen::Vector3d value = values.segment<3>(3 * static_cast<Eigen::Index>(k - begin.node));
        x[nodes_[k]] = to_vec4(value.cast<float>(), 0);
    }
}

std::size_t ComponentSolver::bytes() const noexcept {
    return components_.size() * sizeof(Component) + (nodes_.size() + number_.size()) * sizeof(std::uint32_t) +
           links_.size() * sizeof(LocalLink) + factors_.bytes();
}

}  // namespace weft
