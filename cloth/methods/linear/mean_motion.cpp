#include "cloth/methods/linear/mean_motion.h"

#include <algorithm>
#include <utility>

#include "engine/small_matrices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/linear/mean_motion.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/external_row-inl.h"

#ifndef WEFT_CLOTH_METHODS_LINEAR_MEAN_MOTION_TYPES
#define WEFT_CLOTH_METHODS_LINEAR_MEAN_MOTION_TYPES
namespace weft {

/// The particles of one component within some groups of 16, and the data of their rows.
struct PieceRows {
    const std::uint32_t* components;
    std::uint32_t component;
    std::span<const std::uint32_t> groups;
    const ContactRows* contacts;
    const Vec4* right_side;
    const Vec4* dv;  // null: 0
};

/// One sum for each of a group's 16 lanes, so that results are the same at any vector width.
struct LaneSums {
    enum Of : std::uint32_t { left_x, left_y, left_z, row_sum, xx, yy, zz, xy, xz, yz, count };
    alignas(64) float values[count][Stencil::lanes];
    alignas(64) float least_row_sum[Stencil::lanes];

    /// The total, summed by halves, which a compiler turns into vectors.
    [[nodiscard]] float all(Of of) const {
        float v[Stencil::lanes];
        std::copy_n(values[of], Stencil::lanes, v);
        for (std::uint32_t half = Stencil::lanes / 2; half > 0; half /= 2)
            for (std::uint32_t k = 0; k < half; ++k) v[k] += v[k + half];
        return v[0];
    }
};

/// The motions that a block's particles get.
struct MotionRows {
    const std::uint32_t* components;
    const Vec4* motions;  // by component
    const ContactRows* contacts;
    bool is_of_one_component;
};

}  // namespace weft
#endif

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Sums b - W dv, row sums and contact over a piece. Springs cancel out of the sum.
void sum_piece(const PieceRows& piece, LaneSums& sums) {
    const Tag d;
    const hn::RebindToUnsigned<Tag> unsigned_lanes;
    const auto wanted = hn::Set(unsigned_lanes, piece.component);
    for (std::uint32_t lane = 0; lane < group_lanes; lane += part_lanes) {
        Lanes3 left = zero3();
        Lanes row_sum = set(0), least = set(1);
        SymmetricLanes held = zero_symmetric();
        for (const std::uint32_t group : piece.groups) {
            const std::uint32_t i = group * group_lanes + lane;
            const auto is_of =
                hn::RebindMask(d, hn::Eq(hn::Load(unsigned_lanes, piece.components + i), wanted));
            const Lanes4 b = load_rows(piece.right_side + i);
            Lanes3 row = xyz(b);
            if (piece.dv != nullptr) row = row - b.w * xyz(load_rows(piece.dv + i));
            if (touches(piece.contacts, i)) {
                const SymmetricLanes g = contact_blocks(*piece.contacts, i);
                held = held + keep_where(is_of, g);
                if (piece.dv != nullptr) row = row - g * xyz(load_rows(piece.dv + i));
            }
            left = left + keep_where(is_of, row);
            row_sum = hn::Add(row_sum, hn::IfThenElseZero(is_of, b.w));
            least = hn::Min(least, hn::IfThenElse(is_of, b.w, set(1)));
        }
        const Lanes all[] = {left.x,  left.y,  left.z,  row_sum, held.xx,
                             held.yy, held.zz, held.xy, held.xz, held.yz};
        for (std::uint32_t k = 0; k < LaneSums::count; ++k) hn::Store(all[k], d, sums.values[k] + lane);
        hn::Store(least, d, sums.least_row_sum + lane);
    }
}

HWY_INLINE Lanes3 motion_of(const MotionRows& rows, std::uint32_t i) {
    const std::uint32_t* const components = rows.components + i;
    if (!rows.is_of_one_component) return gather_rows(rows.motions, components);
    const Vec4& u = rows.motions[*components];
    return {set(u.x), set(u.y), set(u.z)};
}

/// b -= (r I + G) u.
void subtract_motion(const MotionRows& rows, const BlockRange& range, Vec4* right_side) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 u = motion_of(rows, i);
        const Lanes4 b = load_rows(right_side + i);
        Lanes3 left = xyz(b) - b.w * u;
        if (touches(rows.contacts, i)) left = left - contact_blocks(*rows.contacts, i) * u;
        store_rows(left, b.w, right_side + i);
    }
}

/// dv += u + v.
void add_motion(const MotionRows& rows, const BlockRange& range, const Vec4* velocities, Vec4* dv) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 change = xyz(load_rows(dv + i)) + motion_of(rows, i);
        store_rows(xyz(load_rows(velocities + i)) + change, set(0), dv + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(sum_piece);
HWY_EXPORT(subtract_motion);
HWY_EXPORT(add_motion);

MeanMotion::MeanMotion(const ClothModel& model)
    : particles_(model.particle_count),
      components_(Stencil::whole_groups(model.particle_count)),
      sums_(model.component_offsets.size() - 1),
      motions_(model.component_offsets.size()),
      pinned_(sums_.size(), none) {
    const auto count = static_cast<std::uint32_t>(sums_.size());
    std::ranges::fill(components_.span(), count);
    for (std::uint32_t c = 0; c < count; ++c)
        for (std::uint32_t k = model.component_offsets[c]; k < model.component_offsets[c + 1]; ++k)
            components_[model.component_particles[k]] = c;
    std::vector<std::uint32_t> seen_in(count, none);
    for (std::uint32_t block = 0; block < block_count(particles_); ++block) add_pieces(block, seen_in);
    block_pieces_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    partials_.resize(pieces_.size());
}

/// `seen_in`: for each component, its last piece.
void MeanMotion::add_pieces(std::uint32_t block, std::vector<std::uint32_t>& seen_in) {
    const auto first = static_cast<std::uint32_t>(pieces_.size());
    const std::uint32_t begin = block * block_size, end = std::min(particles_, begin + block_size);
    block_pieces_.push_back(first);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  // piece, group
    for (std::uint32_t i = begin; i < end; ++i) {
        std::uint32_t& piece = seen_in[components_[i]];
        if (piece == none || piece < first) {
            piece = static_cast<std::uint32_t>(pieces_.size());
            pieces_.push_back({components_[i], 0, 0});
        }
        places.emplace_back(piece, i / Stencil::lanes);
    }
    std::ranges::sort(places);
    const auto repeated = std::ranges::unique(places);
    places.erase(repeated.begin(), repeated.end());
    for (const auto& [piece, group] : places) {
        const auto at = static_cast<std::uint32_t>(groups_.size());
        if (pieces_[piece].end == 0) pieces_[piece].begin = at;
        pieces_[piece].end = at + 1;
        groups_.push_back(group);
    }
}

void MeanMotion::Rows::add(const Rows& more) {
    right_side += more.right_side;
    matrix += more.matrix;
}

bool MeanMotion::any_free() const {
    return std::ranges::find(pinned_, none) != pinned_.end();
}

MotionRows MeanMotion::motion_rows(std::uint32_t block, const ContactRows* contacts) const {
    return {.components = components_.data(),
            .motions = motions_.data(),
            .contacts = contacts,
            .is_of_one_component = block_pieces_[block] + 1 == block_pieces_[block + 1]};
}

MeanMotion::Rows MeanMotion::sum(const Piece& piece, const ContactRows* contacts, const Vec4* right_side,
                                 const Vec4* dv) const {
    LaneSums sums;
    HWY_DYNAMIC_DISPATCH(sum_piece)
    ({.components = components_.data(),
      .component = piece.component,
      .groups = std::span(groups_).subspan(piece.begin, piece.end - piece.begin),
      .contacts = contacts,
      .right_side = right_side,
      .dv = dv},
     sums);
    const Symmetric3 held{sums.all(LaneSums::xx), sums.all(LaneSums::yy), sums.all(LaneSums::zz),
                          sums.all(LaneSums::xy), sums.all(LaneSums::xz), sums.all(LaneSums::yz)};
    Rows rows;
    rows.right_side = {sums.all(LaneSums::left_x), sums.all(LaneSums::left_y), sums.all(LaneSums::left_z)};
    rows.matrix = held.full();
    rows.matrix.diagonal().array() += static_cast<double>(sums.all(LaneSums::row_sum));
    if (std::ranges::min(sums.least_row_sum) == 0) rows.pinned = pinned_of(piece, right_side);
    return rows;
}

/// A particle of the piece whose row sum is 0, or none.
std::uint32_t MeanMotion::pinned_of(const Piece& piece, const Vec4* right_side) const {
    for (std::uint32_t k = piece.begin; k < piece.end; ++k)
        for (std::uint32_t i = groups_[k] * Stencil::lanes; i < (groups_[k] + 1) * Stencil::lanes; ++i)
            if (components_[i] == piece.component && right_side[i].w == 0) return i;
    return none;
}

void MeanMotion::solve(Parallel& parallel, const ContactRows* contacts, const Vec4* right_side,
                       const Vec4* dv) {
    parallel.blocks(block_count(particles_), [&](std::uint32_t block) {
        for (std::uint32_t p = block_pieces_[block]; p < block_pieces_[block + 1]; ++p)
            if (!is_pinned(pieces_[p].component)) partials_[p] = sum(pieces_[p], contacts, right_side, dv);
    });
    std::ranges::fill(sums_, Rows{});
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        const std::uint32_t component = pieces_[p].component;
        if (is_pinned(component)) continue;
        sums_[component].add(partials_[p]);
        pinned_[component] = partials_[p].pinned;
    }
    for (std::uint32_t c = 0; c < sums_.size(); ++c) {
        if (is_pinned(c)) {
            motions_[c] = {};
            continue;
        }
        const Vector3 u = solve_by_llt(sums_[c].matrix, sums_[c].right_side).cast<float>();
        motions_[c] = to_vec4(dv == nullptr ? u : Vector3(xyz(motions_[c]) + u), 0);
    }
}

void MeanMotion::take_out(Parallel& parallel, const ContactRows* contacts, std::span<Vec4> right_side) {
    for (std::uint32_t& particle : pinned_)
        if (particle != none && right_side[particle].w != 0) particle = none;
    solve(parallel, contacts, right_side.data(), nullptr);
    if (!any_free()) return;
    parallel.ranges(particles_, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(subtract_motion)(motion_rows(range.block, contacts), range, right_side.data());
    });
}

// dv becomes v + dv + u + u', where u' solves the sum of all rows of W u' = b' - W dv. take_out() has left b'
// with the sum 0, and springs cancel out of it.
void MeanMotion::put_back(Parallel& parallel, const ContactRows* contacts, std::span<const Vec4> right_side,
                          std::span<const Vec4> velocities, std::span<Vec4> dv) {
    if (any_free()) solve(parallel, contacts, right_side.data(), dv.data());
    parallel.ranges(particles_, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(add_motion)
        (motion_rows(range.block, contacts), range, velocities.data(), dv.data());
    });
}

std::size_t MeanMotion::bytes() const noexcept {
    return components_.bytes() + pieces_.size() * sizeof(Piece) + partials_.size() * sizeof(Rows) +
           sums_.size() * sizeof(Rows) + motions_.bytes() +
           (block_pieces_.size() + groups_.size() + pinned_.size()) * sizeof(std::uint32_t);
}

}  // namespace weft
#endif
