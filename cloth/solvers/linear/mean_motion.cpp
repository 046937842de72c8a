#include "cloth/solvers/linear/mean_motion.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace weft {

namespace {

Vector4 to_vector4(const Vector3& v) {
    return {v.x(), v.y(), v.z(), 0};
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
        // Single precision over a quarter of a block, double beyond; four sums, so that none waits for
        // another.
        Vector4 right_sides[4] = {Vector4::Zero(), Vector4::Zero(), Vector4::Zero(), Vector4::Zero()};
        Symmetric3 held;
        float least = 1;
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            const std::uint32_t i = particles_[k];
            right_sides[k % 4] += right_side_of(i);
            least = std::min(least, row_sums[i].w);
            if (touches(contacts, i)) held.add(contacts->block(i));
        }
        const Eigen::Vector4d total = (right_sides[0] + right_sides[1]).cast<double>() +
                                      (right_sides[2] + right_sides[3]).cast<double>();
        sum.right_side = total.head<3>();
        sum.matrix = held.full();
        sum.matrix.diagonal().array() += total.w();
        sum.pinned = least == 0;
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
        parallel, contacts, right_side, [&](std::uint32_t i) -> Vector4 { return load(right_side[i]); },
        false);
    for_each_block(parallel, [&](std::uint32_t p) {
        const Vec4& motion = motions_[pieces_[p].component];
        if (motion.w == 0) return;
        const Vector4 u = to_vector4(xyz(motion));
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            const std::uint32_t i = particles_[k];
            Vec4& b = right_side[i];
            store(b, load(b) - b.w * u);
            if (touches(contacts, i)) set_xyz(b, xyz(b) - contacts->block(i) * xyz(motion));
        }
    });
}

// dv = u + dv' + u', where u' solves the sum of all rows of W u' = b' - W dv'. take_out() has left b' with
// the sum 0, and springs have none.
void MeanMotion::put_back(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> right_side,
                          std::span<Vec4> dv) {
    const auto left_by = [&](std::uint32_t i) -> Vector4 {
        const float row_sum = right_side[i].w;
        Vector4 left = -row_sum * load(dv[i]);
        if (touches(contacts, i)) left -= to_vector4(contacts->block(i) * xyz(dv[i]));
        left.w() = row_sum;
        return left;
    };
    solve(parallel, contacts, right_side, left_by, true);
    for_each_block(parallel, [&](std::uint32_t p) {
        const Vec4& motion = motions_[pieces_[p].component];
        if (motion.w == 0) return;
        const Vector4 u = to_vector4(xyz(motion));
        for (std::uint32_t k = pieces_[p].begin; k < pieces_[p].end; ++k) {
            Vec4& change = dv[particles_[k]];
            store(change, load(change) + u);
        }
    });
}

std::size_t MeanMotion::bytes() const noexcept {
    return pieces_.size() * sizeof(Piece) + block_pieces_.size() * sizeof(std::uint32_t) +
           partials_.size() * sizeof(Rows) + motions_.size() * sizeof(Vec4);
}

}  // namespace weft
