#include "cloth/fabric/springs/ring_order.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace weft {

namespace {

constexpr std::uint32_t none = RingPlace::none;

/// A corner is a triangle at the particle, between two of its neighbours.
struct Corner {
    std::uint32_t triangle;
    std::array<std::uint32_t, 2> beside;  // places in the list of neighbours
    bool is_used = false;
};

/// A neighbour of a particle, with the triangles of this copy of their edge.
struct Neighbour {
    std::uint32_t half_edge, copy;
    std::array<std::uint32_t, 2> corners{none, none};

    [[nodiscard]] bool is_end() const { return corners[0] != none && corners[1] == none; }
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;
/// These edges have a copy for each of their triangles.
using CutEdges = std::set<Edge>;

/// Fan orders the triangles round one particle at a time.
class Fan {
  public:
    explicit Fan(const ClothModel& model) : model_(model) {}

    void look_at(std::uint32_t particle, const CutEdges& cut);
    /// Appends the particle's ring to the places and returns its opening.
    std::uint32_t list(std::vector<RingPlace>& places);
    /// Cuts closed rings of the particle, unless a single one is all that the particle has.
    void cut_open(std::uint32_t particle, CutEdges& cut);

  private:
    [[nodiscard]] std::uint32_t copy_for(std::uint32_t particle, std::uint32_t neighbour, const CutEdges& cut,
                                         std::uint32_t corner);
    /// Appends the neighbours that unused triangles connect to the first one. Returns the triangle that leads
    /// back to the first, or none.
    std::uint32_t follow(std::uint32_t first, std::vector<RingPlace>& places);
    /// Appends all chains, and then all closed rings.
    void follow_all(std::vector<RingPlace>& places);
    [[nodiscard]] Corner* next_corner(const Neighbour& from);

    const ClothModel& model_;
    std::vector<Neighbour> neighbours_;
    std::vector<Corner> corners_;
    std::uint32_t chains_ = 0, opening_ = none;  // of the last closed ring
    std::vector<std::uint32_t> closed_;          // the neighbour at which each closed ring begins
};

Edge edge_between(std::uint32_t i, std::uint32_t j) {
    return {std::min(i, j), std::max(i, j)};
}

/// The index of the copy of an edge that gets one more triangle. Triangles come in ascending order, so both
/// ends give each copy the same triangle.
std::uint32_t Fan::copy_for(std::uint32_t particle, std::uint32_t neighbour, const CutEdges& cut,
                            std::uint32_t corner) {
    const std::uint32_t half_edge = half_edge_between(model_, particle, neighbour);
    const std::size_t most = cut.contains(edge_between(particle, neighbour)) ? 1 : 2;
    std::uint32_t copies = 0;
    for (std::uint32_t k = 0; k < neighbours_.size(); ++k) {
        if (neighbours_[k].half_edge != half_edge) continue;
        ++copies;
        for (std::size_t c = 0; c < most; ++c) {
            if (neighbours_[k].corners[c] != none) continue;
            neighbours_[k].corners[c] = corner;
            return k;
        }
    }
    neighbours_.push_back({half_edge, copies, {corner, none}});
    return static_cast<std::uint32_t>(neighbours_.size()) - 1;
}

void Fan::look_at(std::uint32_t particle, const CutEdges& cut) {
    neighbours_.clear();
    corners_.clear();
    for (std::uint32_t e = model_.spring_offsets[particle]; e < model_.spring_offsets[particle + 1]; ++e)
        if (model_.kinds[e] != SpringKind::bending) neighbours_.push_back({e, 0});
    if (model_.rows > 0) return;  // a sheet's springs are sides of cells, not of triangles
    for (std::uint32_t c = model_.corner_offsets[particle]; c < model_.corner_offsets[particle + 1]; ++c) {
        const std::uint32_t t = model_.corner_triangles[c];
        const Triangle& triangle = model_.triangles[t];
        const std::uint32_t k = corner_at(triangle, particle);
        const auto corner = static_cast<std::uint32_t>(corners_.size());
        corners_.push_back({t,
                            {copy_for(particle, triangle[(k + 1) % 3], cut, corner),
                             copy_for(particle, triangle[(k + 2) % 3], cut, corner)}});
    }
}

Corner* Fan::next_corner(const Neighbour& from) {
    for (const std::uint32_t corner : from.corners)
        if (corner != none && !corners_[corner].is_used) return &corners_[corner];
    return nullptr;
}

std::uint32_t Fan::follow(std::uint32_t first, std::vector<RingPlace>& places) {
    std::uint32_t at = first;
    places.push_back({neighbours_[at].half_edge, neighbours_[at].copy});
    while (Corner* const corner = next_corner(neighbours_[at])) {
        corner->is_used = true;
        at = corner->beside[corner->beside[0] == at ? 1 : 0];
        if (at == first) return corner->triangle;
        places.back().triangle = corner->triangle;
        places.push_back({neighbours_[at].half_edge, neighbours_[at].copy});
    }
    return none;
}

void Fan::follow_all(std::vector<RingPlace>& places) {
    const auto count = static_cast<std::uint32_t>(neighbours_.size());
    chains_ = 0;
    closed_.clear();
    opening_ = none;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (!neighbours_[k].is_end() || next_corner(neighbours_[k]) == nullptr) continue;
        follow(k, places);
        ++chains_;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        if (next_corner(neighbours_[k]) == nullptr) continue;
        opening_ = follow(k, places);
        closed_.push_back(model_.neighbours[neighbours_[k].half_edge]);
    }
}

std::uint32_t Fan::list(std::vector<RingPlace>& places) {
    follow_all(places);
    for (const Neighbour& neighbour : neighbours_)
        if (neighbour.corners[0] == none) places.push_back({neighbour.half_edge, neighbour.copy});
    return opening_;
}

void Fan::cut_open(std::uint32_t particle, CutEdges& cut) {
    std::vector<RingPlace> unused;
    follow_all(unused);
    if (chains_ + closed_.size() == 1) return;
    for (const std::uint32_t neighbour : closed_) cut.insert(edge_between(particle, neighbour));
}

}  // namespace

RingOrder::RingOrder(const ClothModel& model) : offsets{0} {
    Fan fan(model);
    CutEdges cut;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        fan.look_at(i, cut);
        fan.cut_open(i, cut);
    }
    places.reserve(model.neighbours.size());
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        fan.look_at(i, cut);
        openings.push_back(fan.list(places));
        offsets.push_back(static_cast<std::uint32_t>(places.size()));
    }
}

Stencil RingOrder::stencil(const ClothModel& model) const {
    std::vector<std::uint32_t> rows{0}, neighbours, half_edges;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t p = offsets[i]; p < end(i); ++p) {
            neighbours.push_back(model.neighbours[places[p].half_edge]);
            half_edges.push_back(places[p].copy == 0 ? places[p].half_edge : none);
        }
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            if (model.kinds[e] != SpringKind::bending) continue;
            neighbours.push_back(model.neighbours[e]);
            half_edges.push_back(e);
        }
        rows.push_back(static_cast<std::uint32_t>(neighbours.size()));
    }
    Stencil made(rows, neighbours, Stencil::Order::as_given);
    SharedBuffer<std::uint16_t> slot_of(model.neighbours.size());
    for (std::size_t k = 0; k < half_edges.size(); ++k)
        if (half_edges[k] != none) slot_of[half_edges[k]] = made.slot_of[k];
    made.slot_of = std::move(slot_of);
    return made;
}

}  // namespace weft
