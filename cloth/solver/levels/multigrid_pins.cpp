// The pins of multigrid levels: which springs hold the coarse nodes.

#include <algorithm>
#include <cstdint>
#include <span>

#include "cloth/solver/levels/multigrid.h"

namespace weft {

std::uint32_t Multigrid::place_of_stitch(const Link& link) const {
    const auto at = std::ranges::lower_bound(stitches_, link);
    if (at == stitches_.end() || *at != link) return none;
    return static_cast<std::uint32_t>(slots_.size() * Stencil::lanes) +
           static_cast<std::uint32_t>(at - stitches_.begin());
}

std::uint32_t Multigrid::spring_of(const Link& link) const {
    if (const std::uint32_t place = place_of_stitch(link); place != none) return place;
    const Part& part = part_of(link.first);
    const std::span<const std::uint32_t> slots = slots_of(part);
    const std::uint32_t entry = part.system->entry_between(link.first - part.first, link.second - part.first);
    const auto slot = std::ranges::lower_bound(slots, entry / Stencil::lanes);
    // The slot is listed, except in levels from a malicious file.
    const auto at = std::min<std::ptrdiff_t>(slot - slots.begin(), std::ssize(slots) - 1);
    return (part.first_slot + static_cast<std::uint32_t>(at)) * Stencil::lanes + entry % Stencil::lanes;
}

template <class Body>
void Multigrid::for_each_link_of(std::uint32_t particle, const Body& body) const {
    const auto visit = [&](std::uint32_t neighbour) {
        body(neighbour, Link{std::min(particle, neighbour), std::max(particle, neighbour)});
    };
    const Part& part = part_of(particle);
    if (part.system != nullptr && particle < part.first + part.count) {
        const ImplicitSystem::Neighbours row = part.system->neighbours_of(particle - part.first);
        for (std::uint32_t k = 0; k < row.count; ++k)
            if (part.first + row[k] != particle) visit(part.first + row[k]);
    }
    for (const Link& stitch : stitches_)
        if (stitch.first == particle || stitch.second == particle)
            visit(stitch.first + stitch.second - particle);
}

std::size_t Multigrid::links_of_particle(std::uint32_t particle) const {
    std::size_t count = 0;
    for_each_link_of(particle, [&](std::uint32_t, const Link&) { ++count; });
    return count;
}

void Multigrid::hold_springs_of(std::uint32_t particle, HeldSprings::iterator at) const {
    for_each_link_of(particle, [&](std::uint32_t neighbour, const Link& link) {
        const float weight = is_common() ? 0 : parts_.front().system->constant_block(link.first, link.second);
        *at++ = {particle, neighbour, weight == 0 ? spring_of(link) : constant, weight};
    });
}

void Multigrid::add_constants_of(std::uint32_t particle, double times) noexcept {
    if (is_common()) return;
    const CoarseLevel& level = coarse_.front();
    for_each_link_of(particle, [&](std::uint32_t neighbour, const Link& link) {
        const float block = parts_.front().system->constant_block(link.first, link.second);
        if (block == 0 || pinned_[neighbour] != 0) return;
        for_each_term(level.interpolation(), link, [&](const Link& coarse, float factor) {
            const std::uint32_t place = level.matrix().place_between(coarse, level.lists());
            // The place is in range, except in levels from a malicious file.
            if (place < constants_.size())
                constants_[place] += times * exact_term(factor * block, shifts_[place]);
        });
    });
}

void Multigrid::mark(std::uint32_t particle, bool pinned) noexcept {
    pinned_[particle] = pinned ? 1 : 0;
    add_constants_of(particle, pinned ? -1 : 1);
}

void Multigrid::pin(std::uint32_t particle) {
    if (coarse_.empty() || pinned_[particle] != 0) return;
    const auto later = std::ranges::upper_bound(held_, particle, {}, &HeldSpring::pinned) - held_.begin();
    const auto at = held_.insert(held_.begin() + later, links_of_particle(particle), HeldSpring{});
    hold_springs_of(particle, at);
    mark(particle, true);
}

void Multigrid::unpin(std::uint32_t particle) noexcept {
    if (coarse_.empty() || pinned_[particle] == 0) return;
    const auto own = std::ranges::equal_range(held_, particle, {}, &HeldSpring::pinned);
    held_.erase(own.begin(), own.end());
    mark(particle, false);
}

template <class IsPinned>
void Multigrid::set_pins_where(const IsPinned& is_pinned) {
    const auto particles = static_cast<std::uint32_t>(pinned_.size());
    std::uint32_t others = 0;
    for (std::uint32_t i = 0; i < particles; ++i) others |= pinned_[i] ^ (is_pinned(i) ? 1u : 0u);
    if (others == 0) return;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < particles; ++i)
        if (is_pinned(i)) count += links_of_particle(i);
    held_.reserve(count);
    held_.resize(count);
    auto at = held_.begin();
    for (std::uint32_t i = 0; i < particles; ++i) {
        if ((pinned_[i] != 0) != is_pinned(i)) mark(i, is_pinned(i));
        if (pinned_[i] == 0) continue;
        hold_springs_of(i, at);
        at += static_cast<std::ptrdiff_t>(links_of_particle(i));
    }
}

void Multigrid::set_pins(std::span<const Vec4> positions) {
    if (!coarse_.empty()) set_pins_where([&](std::uint32_t i) { return positions[i].w == 0; });
}

void Multigrid::see_pins() {
    if (!is_common() || coarse_.empty()) return;
    set_pins_where([&](std::uint32_t i) {
        const Part& part = part_of(i);
        if (part.system == nullptr || i >= part.first + part.count) return true;
        return part.equation->positions[i - part.first].w == 0;
    });
}

void Multigrid::reserve_pins(std::size_t count) {
    if (most_links_ == 0) {
        for (std::uint32_t i = 0; i < pinned_.size(); ++i) {
            const std::uint32_t of_particle = parts_.front().system->neighbours_of(i).count;
            most_links_ = std::max(most_links_, of_particle);
            all_links_ += of_particle;
        }
    }
    // `count` particles have at most this many links; and no link is listed more than once from each end.
    held_.reserve(std::min(count * most_links_, all_links_));
}

}  // namespace weft
