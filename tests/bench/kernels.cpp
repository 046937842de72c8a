#include "tests/bench/kernels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "cloth/methods/positional/xpbd_kernel.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/make_system.h"
#include "collision/search/patches.h"
#include "tests/bench/stopwatch.h"

namespace weft::bench {

namespace {

/// The counts that the formulas use, all per particle.
struct Counts {
    bool is_grid;   ///< each spring is kept and worked out once, at its first end
    double blocks;  ///< that the matrix keeps
    double indices, triangles, contacts;

    Counts(const Cloth& cloth, const ImplicitSystem& system) {
        const Stencil& stencil = system.stencil();
        const auto n = static_cast<double>(cloth.model.particle_count);
        const double half_edges = static_cast<double>(cloth.model.neighbours.size()) / n;
        is_grid = system.entries() < cloth.model.neighbours.size();
        blocks = is_grid ? half_edges / 2 : half_edges;
        triangles = static_cast<double>(cloth.model.triangles.size()) / n;
        contacts = 2 * static_cast<double>(cloth.self_counts.pairs) / n;
        double gathered = 0;
        for (std::uint32_t s = 0; s < stencil.slots(); ++s) gathered += stencil.runs[s] == Stencil::no_run;
        indices = is_grid ? 0 : half_edges * gathered / std::max(1u, stencil.slots());
    }
};

// Rows of x y z w are 16 bytes; a block a, d_x, d_y, d_z is 8 in half precision, its index 4 where neighbours
// are not runs, its rest length 4; D^-1 is 24. In a grid the second end of a spring adds up what the first
// found.
Traffic linearise_traffic(const Counts& c) {  // x v air in, b out; per block some 65: n, tension, a, d, b, D
    return {.bytes = 4 * 16 + 4 + 24 + c.blocks * (8 + 4) + 4 * c.indices,
            .flops = 60 + (c.is_grid ? 65 + 16 : 65) * c.blocks};
}
Traffic residual_traffic(const Counts& c) {  // x v air in, residual out
    return {.bytes = 4 * 16 + 4 * c.blocks + 4 * c.indices,
            .flops = 20 + (c.is_grid ? 35 + 3 : 35) * c.blocks};
}
double product_flops(const Counts& c) {  // a (x_i - x_j) + d (d . (x_i - x_j)): 3 + 5 + 9 + 3
    return (c.is_grid ? 20 + 3 : 20) * c.blocks;
}
Traffic multiply_traffic(const Counts& c) {
    return {.bytes = 2 * 16 + 4 + 8 * c.blocks + 4 * c.indices, .flops = 12 + product_flops(c)};
}
Traffic relax_traffic(const Counts& c) {  // b x in, next in and out
    return {.bytes = 4 * 16 + 4 + 24 + 8 * c.blocks + 4 * c.indices, .flops = 36 + product_flops(c)};
}
Traffic precondition_traffic() {
    return {.bytes = 2 * 16 + 24, .flops = 18};
}

/// Sums over the coarse levels, per particle of the finest.
struct CoarseCounts {
    double terms = 0, lists = 0, matrices = 0, read_by_cycle = 0, flops_of_cycle = 0;

    CoarseCounts(const Multigrid& multigrid, double n) {
        for (std::size_t k = 0; k < multigrid.levels(); ++k) {
            const CoarseLevel& level = multigrid.level(k);
            const auto nodes = static_cast<double>(level.nodes());
            const double slots = 16.0 * level.matrix().stencil.slots();
            const GalerkinLists& of = level.lists();
            terms += static_cast<double>(of.factors.size()) / n;
            lists +=
                static_cast<double>(of.group_slots.bytes() + of.fine_links.bytes() + of.factors.bytes()) / n;
            matrices += static_cast<double>(level.matrix().bytes()) / n;
            read_by_cycle +=
                (28 * slots + (4 * 16 + 24) * nodes) / n;  // blocks of 24, indices of 4; b, x, D^-1
            const double passes = k == 0 ? 2 : 4;
            flops_of_cycle += passes * (24 * slots + 36 * nodes) / n;
        }
    }
};
Traffic build_traffic(double springs, const CoarseCounts& coarse) {  // each is unpacked, then summed
    return {.bytes = springs * (8 + 2 * 16) + coarse.lists + coarse.matrices, .flops = 18 * coarse.terms};
}
// b - W x, x = step D^-1 b; restrict and prolong, by 3 weights and 3 indices a node; relax; the coarse
// levels. x is made where it is read in a grid, else it is written, read, and written and read anew when
// corrected.
Traffic cycle_traffic(const Counts& c, const CoarseCounts& coarse) {
    const Traffic first = precondition_traffic();
    const double iterates = c.is_grid ? 24.0 - 16 : first.bytes + 16 + 2 * 16;
    return {.bytes = multiply_traffic(c).bytes + (16 + 24) + 24 + relax_traffic(c).bytes + iterates +
                     coarse.read_by_cycle,
            .flops = (c.is_grid ? 2 : 1) * first.flops + multiply_traffic(c).flops + relax_traffic(c).flops +
                     2 * 18 + coarse.flops_of_cycle};
}
Traffic xpbd_traffic(double springs) {  // 9 values each; start in, moved in and out
    return {.bytes = springs * 36 + 3 * 16, .flops = 45 * springs};
}
Traffic place_traffic() {  // x and who is where in; x, y, z and six sides of 1 / 16 + 1 / 256 of a box out
    return {.bytes = 16 + 4 + 12 + 24.0 / 15, .flops = 6};
}

}  // namespace

struct Kernels::Work {
    explicit Work(Scene& s)
        : scene(s),
          equation(s.equation()),
          system(make_system(s.cloth().model, s.cloth().settings)),
          x(s.particles()),
          y(s.particles()),
          patches(s.cloth().model.positions.span()),
          colours(colour_springs(s.cloth().model)),
          springs(colours.springs()),
          start(s.particles() + SpringColours::stand_ins),
          moved(s.particles() + SpringColours::stand_ins) {
        Parallel& parallel = s.simulation().parallel;
        const auto velocities = std::as_const(s.cloth().state.velocities).span();
        system->linearise(parallel, equation, velocities, LinearisedAbout::base);
        multigrid = std::make_unique<Multigrid>(parallel, *system, s.cloth().state.positions.span());
        multigrid->set_pins(s.cloth().state.positions.span());
        std::ranges::copy(s.cloth().state.positions.span(), start.data());
        for (std::uint32_t k = 0; k < colours.springs(); ++k) {
            const std::uint32_t half_edge = colours.half_edges[k];
            if (half_edge == SpringColours::no_half_edge) continue;
            const float first = start[colours.first[k]].w, second = start[colours.second[k]].w;
            springs.rest_lengths[k] = s.cloth().model.rest_lengths[half_edge];
            springs.first_weights[k] = first;
            springs.second_weights[k] = second;
            springs.responses[k] = first + second > 0 ? 0.5f / (first + second) : 0.0f;
        }
    }

    Scene& scene;
    StepEquation equation;
    std::unique_ptr<ImplicitSystem> system;
    std::unique_ptr<Multigrid> multigrid;
    AlignedBuffer<Vec4> x, y;
    Patches patches;
    SpringColours colours;
    XpbdSprings springs;
    AlignedBuffer<Vec4> start, moved;
};

std::vector<KernelName> Kernels::names() {
    std::vector<KernelName> names;
    for (const char* name : {"linearise", "residual", "multiply", "relax", "precondition", "coarse operators",
                             "V-cycle", "xpbd sweep", "place patches"})
        names.push_back({name, false});
    for (const char* name :
         {"wind", "advance", "colliders", "self search", "self response", "guard", "normals"})
        names.push_back({name, true});
    return names;
}

Kernels::Kernels(Scene& scene) : work_(std::make_unique<Work>(scene)) {
    Work& w = *work_;
    Parallel& parallel = scene.simulation().parallel;
    const Counts c(scene.cloth(), *w.system);
    const double springs = c.is_grid ? c.blocks : c.blocks / 2;
    const CoarseCounts coarse(*w.multigrid, scene.particles());
    const auto add = [&](const char* name, const Traffic& traffic, auto run) {
        kernels_.push_back({name, traffic, [run, &parallel] { return seconds_of(parallel.width(), run); }});
    };
    const auto velocities = std::as_const(scene.cloth().state.velocities).span();
    const auto b = std::as_const(w.system->right_side()).span();

    add("linearise", linearise_traffic(c), [&w, &parallel, velocities] {
        w.system->linearise(parallel, w.equation, velocities, LinearisedAbout::base);
    });
    add("residual", residual_traffic(c),
        [&w, &parallel, velocities] { w.system->residual(parallel, w.equation, velocities, w.y.span()); });
    add("multiply", multiply_traffic(c), [&w, &parallel, b] { w.system->multiply(parallel, b, w.y.span()); });
    add("relax", relax_traffic(c),
        [&w, &parallel, b] { w.system->relax(parallel, b, w.x.span(), {.step = 0.8f}, w.y.span()); });
    add("precondition", precondition_traffic(),
        [&w, &parallel, b] { w.system->precondition(parallel, b, 0.8f, w.y.span()); });
    add("coarse operators", build_traffic(springs, coarse),
        [&w, &parallel] { w.multigrid->build(parallel); });
    add("V-cycle", cycle_traffic(c, coarse),
        [&w, &parallel, b] { w.multigrid->cycle(parallel, b, w.y.span()); });
    add("xpbd sweep", xpbd_traffic(springs), [&w, &parallel] {
        sweep_springs(parallel, w.colours, 0, {.first = true, .last = true}, w.springs, w.start.data(),
                      w.moved.data());
    });
    add("place patches", place_traffic(),
        [&w, &parallel] { w.patches.place(parallel, w.scene.cloth().state.positions.span()); });

    const auto add_stage = [&](const char* name, const Traffic& traffic, bool each_substep = true) {
        const int times = each_substep ? scene.simulation().settings.substeps : 1;
        kernels_.push_back({name, traffic, [&w, name, times] {
                                w.scene.frame();
                                for (const StageTime& stage : w.scene.simulation().profiler.stages())
                                    if (std::strcmp(stage.name, name) == 0)
                                        return 1e-3 * static_cast<double>(stage.last) / times;
                                throw std::runtime_error(std::string("the step has no stage ") + name);
                            }});
    };
    // In a grid x, v and how cells are cut in, forces out; the mean wind blows. Else per triangle its
    // corners' indices, 12, and a result of 16 out and in; per corner the list's 4.
    const double lists = c.triangles * (12 + 2 * 16 + 3 * 4);
    add_stage("wind", {.bytes = 3 * 16 + (c.is_grid ? 1 : lists),
                       .flops = (c.is_grid ? 100 + 9 : 80 + 9) * c.triangles});
    add_stage("advance", {.bytes = 6 * 16, .flops = 20});
    add_stage("colliders", {.bytes = 2 * 16, .flops = 25});
    // Patches are placed, then read with their boxes; contacts out. In a draped sheet five blocks' boxes,
    // four patches and 25 particles are near a patch: 11 flops a box, 8 a pair.
    add_stage("self search", {.bytes = place_traffic().bytes + 12 + 24.0 / 15 + 1 + 4 * c.contacts,
                              .flops = place_traffic().flops + (5 + 4) * 11 + 25 * 8});
    add_stage("self response", {.bytes = 1 + c.contacts * (4 + 2 * 32 + 2 * 32), .flops = 60 * c.contacts});
    add_stage("guard", {.bytes = 2 * 16, .flops = 15}, false);
    add_stage("normals", {.bytes = 2 * 16 + (c.is_grid ? 1 : lists), .flops = (20 + 9) * c.triangles + 10},
              false);
}

Kernels::~Kernels() = default;
Kernels::Kernels(Kernels&&) noexcept = default;

const Kernel* Kernels::find(const std::string& name) const {
    const auto at = std::ranges::find(kernels_, name, &Kernel::name);
    return at == kernels_.end() ? nullptr : &*at;
}

}  // namespace weft::bench
