#include "cloth/solvers/linear/mean_motion.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace weft {

namespace {

/// (r_i I + G_i) v.
Vector3 row_times(const ContactRows* contacts, std::uint32_t i, float row_sum, const Vector3& v) {
    const Vector3 product = row_sum * v;
    return touches(contacts, i) ? Vector3(product + contacts->block(i) * v) : product;
}

}  // namespace

MeanMotion::MeanMotion(const CookedCloth& model)
    : particles_(model.component_particles), motions_(model.component_offsets.size() - 1) {
    const auto count = static_cast<std::uint32_t>(particles_.size());
    std::uint32_t component = 0;
    for (std::uint32_t begin = 0; begin < count;) {
        if (begin % block_size == 0) block_pieces_.push_back(static_cast<std::uint32_t>(pieces_.size()));
        while (model.component_offsets[component + 1] <= begin) ++component;
        const std::uint32_t block_end = std::min(count, begin - begin % block_size + block_size);
        const std::uint32_t end = std::min(block_end, model.component_offsets[component + 1]);
        pieces_.push_back({component, begin, end});
        begin = end;
    }
    block_pieces_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    partials_.resize(pieces_.size());
}

void MeanMotion::Rows::add(const Rows& more) {
    right_side += more.right_side;
    matrix += more.matrix;
    pinned |= more.pinned;
}

template <class Body>
void MeanMotion::for_each_block(Parallel& parallel, const Body& body) const {
    parallel.blocks(static_cast<std::uint32_t>(block_pieces_.size()) - 1, [&](std::uint32_t block) {
        for (std::uint32_t p = block_pieces_[block]; p < block_pieces_[block + 1]; ++p) body(p);
    });
}

template <class RightSide>
void MeanMotion::solve(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> row_sums,
                       const RightSide& right_side_of, bool again) {
    for_each_block(parallel, [&](std::uint32_t p) {
        Rows sum;
        double masses = 0;
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            const std::uint32_t i = particles_[k];
            sum.pinned |= row_sums[i].w == 0;
            sum.right_side += right_side_of(i).template cast<double>();
            masses += static_cast<double>(row_sums[i].w);
            if (touches(contacts, i)) sum.matrix += contacts->block(i).full();
        }
        sum.matrix.diagonal().array() += masses;
        partials_[p] = sum;
    });
    for (std::size_t p = 0; p < pieces_.size();) {
        const std::uint32_t component = pieces_[p].component;
        Rows all;
        for (; p < pieces_.size() && pieces_[p].component == component; ++p) all.add(partials_[p]);
        Vec4& motion = motions_[component];
        if (all.pinned) {
            motion = {};
            continue;
        }
        const Eigen::Vector3d u = all.matrix.llt().solve(all.right_side);
        motion = to_vec4((again ? xyz(motion) : Vector3(Vector3::Zero())) + u.cast<float>(), 1);
    }
}

void MeanMotion::take_out(Parallel& parallel, const ContactRows* contacts, std::span<Vec4> right_side) {
    solve(
        parallel, contacts, right_side, [&](std::uint32_t i) { return xyz(right_side[i]); }, false);
    for_each_block(parallel, [&](std::uint32_t p) {
        const Vec4& motion = motions_[pieces_[p].component];
        if (motion.w == 0) return;
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            Vec4& b = right_side[particles_[k]];
            set_xyz(b, xyz(b) - row_times(contacts, particles_[k], b.w, xyz(motion)));
        }
    });
}

// dv = u + dv' + u', where u' solves the sum of all rows of W u' = b' - W dv'. take_out() has left b' with
// the sum 0, and springs have none.
void MeanMotion::put_back(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> right_side,
                          std::span<Vec4> dv) {
    solve(
        parallel, contacts, right_side,
        [&](std::uint32_t i) { return row_times(contacts, i, right_side[i].w, -xyz(dv[i])); }, true);
    for_each_block(parallel, [&](std::uint32_t p) {
        const Vec4& motion = motions_[pieces_[p].component];
        if (motion.w == 0) return;
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            Vec4& change = dv[particles_[k]];
            set_xyz(change, xyz(change) + xyz(motion));
        }
    });
}

std::size_t MeanMotion::bytes() const noexcept {
    return pieces_.size() * sizeof(Piece) + block_pieces_.size() * sizeof(std::uint32_t) +
           partials_.size() * sizeof(Rows) + motions_.size() * sizeof(Vec4);
}

}  // namespace weft
