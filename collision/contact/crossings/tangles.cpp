#include "collision/contact/crossings/tangles.h"

#include <algorithm>
#include <utility>

namespace weft {

namespace {

// A contour that has not become shorter for this time [s] is directed by votes.
constexpr float patience_without_votes = 0.33f;
// A contour that has not become shorter for this time [s], with votes, is not pushed: it would only jitter.
constexpr float patience = 1;

// Room for labels, per particle: few are near more than one contour.
constexpr std::size_t labels_per_particle = 2;
constexpr std::size_t corners = 5;

}  // namespace

void Tangles::lay_out(Scratch& scratch, const Room& room) {
    contours_.lay_out(scratch, room.bodies, room.crossings);
    untangling_.lay_out(scratch, room.crossings);
    side_vote_.lay_out(scratch, room.particles, room.pairs);
    scratch.take(core_, corners * room.crossings);
    scratch.take(labels_, labels_per_particle * room.particles);
    scratch.take(label_ends_, room.particles + 1);
    for (auto* array : {&names_, &marks_}) scratch.take(*array, room.particles);
    scratch.take(of_contours_, room.crossings);
}

void Tangles::find(const Start& start, const CrossingList& list, std::span<TangleMemory> memory) {
    const std::size_t room = core_.size() / corners;
    const std::span<const Crossing> crossings =
        list.crossings.span().first(std::min<std::size_t>(list.size, room));
    contours_.trace(start.bodies, crossings);
    untangling_.find(start.bodies, start.positions, crossings, contours_);
    find_core(crossings);
    name_contours(start, crossings, memory);
    dilate(start.bodies);
    remember(memory);
    forget(start.bodies, memory);
    counts_ = {.crossings = list.size, .contours = contours_.size()};
    stop_stalled();
}

void Tangles::recall(std::span<const ContactBody> bodies, std::span<const TangleMemory> memory) {
    active_ = false;
    std::ranges::fill(label_ends_.span(), 0u);
    for (const ContactBody& body : bodies) {
        for (std::uint32_t i = body.first; i < body.first + body.mesh->particles(); ++i) {
            names_[i] = memory[i].steps > 0 ? memory[i].name : 0;
            active_ = active_ || names_[i] != 0;
        }
    }
    untangling_.clear();
    counts_ = {};
}

// Collects the particles of each contour, and counts its crossings in `least`.
void Tangles::find_core(std::span<const Crossing> crossings) {
    core_size_ = 0;
    std::fill_n(of_contours_.data(), contours_.size(), TangleMemory{});
    for (std::uint32_t k = 0; k < crossings.size(); ++k) {
        const std::uint32_t contour = contours_.contour_of(k);
        ++of_contours_[contour].least;
        for (const std::uint32_t i : crossings[k].edge) core_[core_size_++] = {i, contour};
        for (const std::uint32_t i : crossings[k].triangle) core_[core_size_++] = {i, contour};
    }
    const auto core = core_.span().first(core_size_);
    std::ranges::sort(core, [](const Label& a, const Label& b) {
        return a.contour != b.contour ? a.contour < b.contour : a.particle < b.particle;
    });
    core_size_ -= static_cast<std::uint32_t>(std::ranges::unique(core).size());
}

// A contour takes the lowest name that any of its particles remembers, or a new one.
void Tangles::name_contours(const Start& start, std::span<const Crossing> crossings,
                            std::span<const TangleMemory> memory) {
    bool has_voted = false;
    for (std::uint32_t k = 0, next; k < core_size_; k = next) {
        const std::uint32_t contour = core_[k].contour;
        TangleMemory& now = of_contours_[contour];
        const TangleMemory* before = nullptr;
        for (next = k; next < core_size_ && core_[next].contour == contour; ++next) {
            const TangleMemory& its = memory[core_[next].particle];
            if (its.steps > 0 && (before == nullptr || its.name < before->name)) before = &its;
        }
        now.name = before != nullptr ? before->name : core_[k].particle + 1;
        now.steps = TangleMemory::steps_remembered;
        if (before == nullptr) continue;
        const bool begins_to_vote = before->votes == 0 && before->stalled > patience_without_votes;
        now.votes = begins_to_vote ? 1 : before->votes;
        if (now.votes != 0) {
            if (!std::exchange(has_voted, true)) side_vote_.begin(start.bodies, start.positions, start.near);
            now.least += push_by_votes(contour, crossings);
        }
        if (begins_to_vote || now.least < before->least) continue;
        now.least = before->least;
        now.stalled = before->stalled + start.h;
    }
}

/// Directs the contour's rows by votes. Returns the number of votes for the other side.
std::uint32_t Tangles::push_by_votes(std::uint32_t contour, std::span<const Crossing> crossings) {
    const SideVote::Result result = side_vote_.of(contour, crossings, contours_);
    const std::span<UntanglingRow> rows = untangling_.rows();
    if (result.side == 0) return 0;
    contours_.for_each_crossing(contour, [&](std::uint32_t k) {
        set_xyz(rows[k].direction, side_vote_.way_of(crossings[k], contours_.side_of_edge(k), result.side));
    });
    return result.minority;
}

// Labels the core and one ring around it: features next to a crossing are the next to cross.
void Tangles::dilate(std::span<const ContactBody> bodies) {
    label_count_ = 0;
    std::ranges::fill(marks_.span(), 0u);
    for (const auto& [particle, contour] : std::as_const(core_).span().first(core_size_)) {
        const ContactBody& body = bodies[body_of(bodies, particle)];
        for (const std::uint32_t t : body.mesh->triangles_of(particle - body.first)) {
            for (const std::uint32_t of_mesh : body.mesh->triangles()[t]) {
                const std::uint32_t i = body.first + of_mesh;
                if (marks_[i] == contour + 1 || label_count_ == labels_.size()) continue;
                marks_[i] = contour + 1;
                labels_[label_count_++] = {i, contour};
            }
        }
    }
    std::ranges::sort(labels_.span().first(label_count_));
    std::ranges::fill(label_ends_.span(), 0u);
    for (std::uint32_t k = 0; k < label_count_; ++k) label_ends_[labels_[k].particle + 1] = k + 1;
    for (std::size_t i = 1; i < label_ends_.size(); ++i)
        label_ends_[i] = std::max(label_ends_[i], label_ends_[i - 1]);
}

// A particle near several contours remembers the one with the lowest name.
void Tangles::remember(std::span<TangleMemory> memory) {
    for (std::uint32_t k = 0, next; k < label_count_; k = next) {
        const std::uint32_t i = labels_[k].particle;
        const TangleMemory* lowest = &of_contours_[labels_[k].contour];
        for (next = k; next < label_count_ && labels_[next].particle == i; ++next) {
            const TangleMemory& other = of_contours_[labels_[next].contour];
            if (other.name < lowest->name) lowest = &other;
        }
        memory[i] = *lowest;
    }
}

void Tangles::forget(std::span<const ContactBody> bodies, std::span<TangleMemory> memory) {
    active_ = label_count_ > 0;
    for (const ContactBody& body : bodies) {
        for (std::uint32_t i = body.first; i < body.first + body.mesh->particles(); ++i) {
            TangleMemory& its = memory[i];
            names_[i] = its.steps > 0 ? its.name : 0;
            if (its.steps == 0 || label_ends_[i + 1] > label_ends_[i]) continue;
            active_ = true;
            if (--its.steps == 0) its = {};
        }
    }
}

void Tangles::stop_stalled() {
    for (const TangleMemory& contour : of_contours_.span().first(contours_.size()))
        counts_.stalled += contour.stalled > patience ? 1 : 0;
    if (counts_.stalled == 0) return;
    const std::span<UntanglingRow> rows = untangling_.rows();
    for (std::uint32_t k = 0; k < rows.size(); ++k)
        if (of_contours_[contours_.contour_of(k)].stalled > patience) rows[k].direction.w = 0;
}

bool Tangles::share_contour(std::uint32_t a, std::uint32_t b) const {
    if (names_[a] == 0 || names_[b] == 0) return false;
    const std::span<const Label> labels = labels_.span();
    const auto of = [&](std::uint32_t i) {
        return labels.subspan(label_ends_[i], label_ends_[i + 1] - label_ends_[i]);
    };
    const std::span<const Label> of_a = of(a), of_b = of(b);
    if (of_a.empty() || of_b.empty()) return names_[a] == names_[b];
    for (const Label& one : of_a)
        for (const Label& other : of_b)
            if (one.contour == other.contour) return true;
    return false;
}

bool Tangles::share_contour(const FeaturePair& pair, std::uint32_t corners_of_a) const {
    for (std::uint32_t a = 0; a < corners_of_a; ++a)
        for (std::uint32_t b = corners_of_a; b < 4; ++b)
            if (share_contour(pair.corners[a], pair.corners[b])) return true;
    return false;
}

void Tangles::exempt(Parallel& parallel, const PairList& pairs, std::span<std::uint8_t> exempt) const {
    parallel.ranges(pairs.size, [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin; k < range.end; ++k)
            exempt[k] = active_ && share_contour(pairs.pairs[k], pairs.corners_of_a(k)) ? 1 : 0;
    });
}

}  // namespace weft
