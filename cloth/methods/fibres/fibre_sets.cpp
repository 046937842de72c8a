#include "cloth/methods/fibres/fibre_sets.h"

#include <algorithm>
#include <utility>

#include "cloth/methods/positional/half_edges.h"
#include "engine/vector.h"

namespace weft {

namespace {

constexpr std::uint32_t none = ~0u;

Vector3 rest_edge(const ClothModel& model, std::uint32_t i, std::uint32_t half_edge) {
    return xyz(model.positions[model.neighbours[half_edge]]) - xyz(model.positions[i]);
}

/// Two half-edges of one particle that continue each other.
struct Continuation {
    float cosine;  ///< -1: straight on
    std::uint32_t a, b;
};

/// By half-edge: the half-edge of the same particle in which its fibre continues, or none. The straightest
/// pairs are matched first; a turn by more than 60 degrees ends the fibre.
std::vector<std::uint32_t> match_continuations(const ClothModel& model) {
    std::vector<std::uint32_t> partner(model.neighbours.size(), none);
    std::vector<Continuation> candidates;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        candidates.clear();
        for (std::uint32_t a = model.spring_offsets[i]; a < model.spring_offsets[i + 1]; ++a) {
            for (std::uint32_t b = a + 1; b < model.spring_offsets[i + 1]; ++b) {
                if (model.kinds[a] != model.kinds[b]) continue;
                const float cosine =
                    rest_edge(model, i, a).normalized().dot(rest_edge(model, i, b).normalized());
                if (cosine < -0.5f) candidates.push_back({cosine, a, b});
            }
        }
        std::ranges::stable_sort(candidates, {}, &Continuation::cosine);
        for (const auto& [cosine, a, b] : candidates) {
            if (partner[a] != none || partner[b] != none) continue;
            partner[a] = b;
            partner[b] = a;
        }
    }
    return partner;
}

/// Follows continuations from half-edge to half-edge, and cuts where a particle would come twice.
class FibreWalk {
  public:
    explicit FibreWalk(const ClothModel& model)
        : model_(model),
          twins_(twin_half_edges(model)),
          partner_(match_continuations(model)),
          used_(model.neighbours.size(), false),
          last_fibre_of_(model.particle_count, none) {
        for (std::size_t e = 0; e < used_.size(); ++e) used_[e] = model.kinds[e] == SpringKind::bending;
    }

    std::vector<Fibre> all() && {
        for (const bool rings : {false, true}) {
            for (std::uint32_t i = 0; i < model_.particle_count; ++i)
                for (std::uint32_t e = model_.spring_offsets[i]; e < model_.spring_offsets[i + 1]; ++e)
                    if (!used_[e] && (rings || partner_[e] == none)) follow(i, e);
        }
        return std::move(fibres_);
    }

  private:
    void follow(std::uint32_t particle, std::uint32_t half_edge) {
        while (half_edge != none && !used_[half_edge]) {
            begin_fibre(particle, half_edge);
            do {
                particle = append(half_edge);
                half_edge = partner_[twins_[half_edge]];
            } while (half_edge != none && !used_[half_edge] && !is_in_fibre(model_.neighbours[half_edge]));
        }
    }

    void begin_fibre(std::uint32_t particle, std::uint32_t half_edge) {
        fibres_.push_back({FibreKind::shear, model_.kinds[half_edge], {particle}, {}});
        last_fibre_of_[particle] = number();
    }

    std::uint32_t append(std::uint32_t half_edge) {
        used_[half_edge] = used_[twins_[half_edge]] = true;
        const std::uint32_t particle = model_.neighbours[half_edge];
        fibres_.back().particles.push_back(particle);
        fibres_.back().half_edges.push_back(half_edge);
        last_fibre_of_[particle] = number();
        return particle;
    }

    [[nodiscard]] std::uint32_t number() const { return static_cast<std::uint32_t>(fibres_.size()); }
    [[nodiscard]] bool is_in_fibre(std::uint32_t particle) const {
        return last_fibre_of_[particle] == number();
    }

    const ClothModel& model_;
    std::vector<std::uint32_t> twins_, partner_;
    std::vector<bool> used_;
    std::vector<std::uint32_t> last_fibre_of_;
    std::vector<Fibre> fibres_;
};

int up_axis(const ClothModel& model) {
    Vector3 lower = xyz(model.positions[0]), upper = lower;
    for (const Vec4& p : model.positions.span()) {
        lower = lower.cwiseMin(xyz(p));
        upper = upper.cwiseMax(xyz(p));
    }
    const Vector3 extent = upper - lower;
    return extent.y() > 0.01f * extent.maxCoeff() ? 1 : 2;
}

bool is_vertical(const ClothModel& model, const Fibre& fibre, int up) {
    float along = 0, across = 0;
    for (std::size_t s = 0; s < fibre.half_edges.size(); ++s) {
        Vector3 edge = rest_edge(model, fibre.particles[s], fibre.half_edges[s]);
        along += std::abs(edge[up]);
        edge[up] = 0;
        across += edge.norm();
    }
    return along > across;
}

/// The fibres of one kind in as few sets as first fit finds, the longest first.
std::vector<std::vector<const Fibre*>> split_into_sets(const std::vector<const Fibre*>& fibres,
                                                       std::uint32_t particles) {
    std::vector<std::vector<const Fibre*>> sets;
    std::vector<std::vector<bool>> taken;  // particles, per set
    for (const Fibre* fibre : fibres) {
        std::size_t set = 0;
        const auto fits = [&](const std::vector<bool>& by_set) {
            return std::ranges::none_of(fibre->particles, [&](std::uint32_t i) { return by_set[i]; });
        };
        while (set < sets.size() && !fits(taken[set])) ++set;
        if (set == sets.size()) {
            sets.emplace_back();
            taken.emplace_back(particles, false);
        }
        sets[set].push_back(fibre);
        for (const std::uint32_t i : fibre->particles) taken[set][i] = true;
    }
    return sets;
}

/// Appends groups of fibres to the rows of FibreSets.
class Packer {
  public:
    explicit Packer(const ClothModel& model) : model_(model) { result_.rows.push_back(0); }

    void add(const std::vector<const Fibre*>& set) {
        const std::uint32_t begin = groups();
        std::vector<std::uint32_t> blocks{begin};
        std::uint32_t rows_in_block = 0;
        for (std::size_t first = 0; first < set.size(); first += FibreSets::lanes) {
            add_group(
                std::span(set).subspan(first, std::min<std::size_t>(FibreSets::lanes, set.size() - first)),
                groups() - begin);
            rows_in_block += result_.rows_of(groups() - 1);
            if (rows_in_block >= rows_per_block) {
                blocks.push_back(groups());
                rows_in_block = 0;
            }
        }
        if (blocks.back() != groups()) blocks.push_back(groups());
        result_.stand_ins = std::max(result_.stand_ins, groups() - begin);
        result_.sets.push_back({set.front()->kind, begin, groups(), std::move(blocks)});
    }

    FibreSets finish() && {
        result_.particles = AlignedBuffer<std::uint32_t>(particles_.size());
        result_.rest_lengths = AlignedBuffer<float>(rest_lengths_.size());
        std::ranges::copy(particles_, result_.particles.data());
        std::ranges::copy(rest_lengths_, result_.rest_lengths.data());
        result_.half_edges = AlignedBuffer<std::uint32_t>(half_edges_.size());
        std::ranges::copy(half_edges_, result_.half_edges.data());
        return std::move(result_);
    }

  private:
    // Work that outweighs handing it to another thread: some 2000 springs.
    static constexpr std::uint32_t rows_per_block = 128;

    [[nodiscard]] std::uint32_t groups() const { return static_cast<std::uint32_t>(result_.rows.size()) - 1; }

    /// Precondition: the longest fibre comes first.
    void add_group(std::span<const Fibre* const> fibres, std::uint32_t group_in_set) {
        const auto rows = static_cast<std::uint32_t>(fibres.front()->half_edges.size());
        const std::uint32_t stand_in = model_.particle_count + group_in_set;
        for (std::uint32_t row = 0; row <= rows; ++row) {
            for (std::uint32_t lane = 0; lane < FibreSets::lanes; ++lane) {
                const Fibre* fibre = lane < fibres.size() ? fibres[lane] : nullptr;
                const bool has_particle = fibre && row < fibre->particles.size();
                particles_.push_back(has_particle ? fibre->particles[row] : stand_in);
                if (row == rows) continue;
                const bool has_spring = fibre && row < fibre->half_edges.size();
                rest_lengths_.push_back(has_spring ? model_.rest_lengths[fibre->half_edges[row]]
                                                   : FibreSets::no_spring);
                half_edges_.push_back(has_spring ? fibre->half_edges[row] : 0);
            }
        }
        result_.rows.push_back(result_.rows.back() + rows);
    }

    const ClothModel& model_;
    FibreSets result_;
    std::vector<std::uint32_t> particles_, half_edges_;
    std::vector<float> rest_lengths_;
};

}  // namespace

std::vector<Fibre> find_fibres(const ClothModel& model) {
    std::vector<Fibre> fibres = FibreWalk(model).all();
    const int up = up_axis(model);
    for (Fibre& fibre : fibres) {
        if (fibre.springs != SpringKind::structural) continue;
        fibre.kind = is_vertical(model, fibre, up) ? FibreKind::vertical : FibreKind::horizontal;
    }
    return fibres;
}

FibreSets make_fibre_sets(const ClothModel& model) {
    std::vector<Fibre> fibres = find_fibres(model);
    std::ranges::stable_sort(fibres, std::greater<>{}, [](const Fibre& f) { return f.particles.size(); });
    static constexpr std::pair<FibreKind, SpringKind> order[] = {
        {FibreKind::shear, SpringKind::shear},
        {FibreKind::horizontal, SpringKind::structural},
        {FibreKind::vertical, SpringKind::structural}};
    Packer packer(model);
    for (const auto& [kind, springs] : order) {
        std::vector<const Fibre*> of_kind;
        for (const Fibre& fibre : fibres)
            if (fibre.kind == kind && fibre.springs == springs) of_kind.push_back(&fibre);
        for (const auto& set : split_into_sets(of_kind, model.particle_count)) packer.add(set);
    }
    return std::move(packer).finish();
}

std::size_t FibreSets::bytes() const noexcept {
    std::size_t in_sets = rows.size() * sizeof(std::uint32_t);
    for (const FibreSet& set : sets) in_sets += sizeof(FibreSet) + set.blocks.size() * sizeof(std::uint32_t);
    return in_sets + particles.bytes() + rest_lengths.bytes() + half_edges.bytes();
}

}  // namespace weft
