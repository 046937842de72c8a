#include "demo/study/method_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demo/study/accuracy/bullet_cloth.h"
#include "demo/study/run.h"
#include "demo/study/stability/stability_causes.h"
#include "demo/study/stability/study_solvers.h"

namespace weft::study {

namespace {

constexpr TimeScheme bdf2 = TimeScheme::bdf2;

/// Collects points, curve by curve.
class List {
  public:
    explicit List(Coverage coverage) : coverage_(coverage) {}

    void curve(const std::string& name, const std::string& label) {
        name_ = name;
        label_ = label;
    }
    /// Adds a point to the curve. `quick`: with Coverage::quick, too.
    MethodPoint* add(bool quick, const std::string& setting, const Method& method, int substeps = 1,
                     TimeScheme time_scheme = TimeScheme::backward_euler) {
        if (coverage_ == Coverage::quick && !quick) return &unused_;
        const auto configure = [=](ClothSettings& settings) {
            settings.method = method;
            settings.substeps = substeps;
            settings.time_scheme = time_scheme;
        };
        points_.push_back({name_, label_, setting, configure, {}, false});
        return &points_.back();
    }
    [[nodiscard]] std::vector<MethodPoint> take() { return std::move(points_); }

  private:
    Coverage coverage_;
    std::string name_, label_;
    std::vector<MethodPoint> points_;
    MethodPoint unused_;
};

std::string text(const std::string& what, int number) {
    return what + "=" + std::to_string(number);
}

std::string text(const std::string& what, int number, const std::string& other, int other_number) {
    return text(what, number) + " " + text(other, other_number);
}

/// Marks the library's default; adds a point for it if there is none.
void mark_default(std::vector<MethodPoint>& points) {
    const ClothSettings shipped;
    const auto is_shipped = [&](const MethodPoint& point) {
        const ClothSettings settings = point.applied_to({});
        return !point.make_solver && !point.make_peer && settings.method == shipped.method &&
               settings.substeps == shipped.substeps &&
               resolved(settings.time_scheme, settings.method) ==
                   resolved(shipped.time_scheme, shipped.method) &&
               !settings.tethers.enabled && !settings.finite_elements.enabled;
    };
    auto at = std::ranges::find_if(points, is_shipped);
    if (at == points.end())
        at = points.insert(points.begin(),
                           {"default", "Weft's default", "as shipped", [](ClothSettings&) {}, {}, false});
    at->is_default = true;
}

void add_iterative(List& list) {
    list.curve("jacobi", "Jacobi (Kang)");
    for (const int k : {1, 7, 31, 127}) list.add(k == 7 || k == 31, text("iterations", k), Jacobi{k});
    list.curve("jacobi-tethers", "Jacobi (Kang) with tethers");
    for (const int k : {1, 7, 31}) {
        MethodPoint* const point = list.add(k == 7, text("iterations", k), Jacobi{k});
        point->configure = [configure = point->configure](ClothSettings& settings) {
            configure(settings);
            settings.tethers.enabled = true;
        };
    }
    list.curve("jacobi-substeps", "Jacobi (Kang) in substeps");
    for (const int substeps : {4, 16})
        list.add(false, text("iterations", 7, "substeps", substeps), Jacobi{7}, substeps);
    list.curve("chebyshev", "Chebyshev");
    for (const int k : {8, 32, 128}) list.add(k == 32, text("iterations", k), Chebyshev{k});
    list.curve("cg", "Conjugate gradients");
    for (const int k : {8, 32, 128}) list.add(k == 32, text("iterations", k), ConjugateGradient{k});
}

void add_multilevel(List& list) {
    const auto passes = [](int count) { return Multilevel{.passes = count}; };
    list.curve("multilevel", "Multilevel (BDF2): passes");
    for (const int count : {1, 2, 3, 6, 12})
        list.add(count <= 3, text("passes", count), passes(count), 1, bdf2);
    for (const int count : {1, 3}) {
        const std::string number = std::to_string(count);
        list.curve("multilevel-substeps-" + number,
                   "Multilevel (BDF2): substeps of " + number + (count == 1 ? " pass" : " passes"));
        for (const int substeps : {2, 4, 8})
            list.add(substeps == 2, text("passes", count, "substeps", substeps), passes(count), substeps,
                     bdf2);
    }
    list.curve("multilevel-euler", "Multilevel (Euler): passes");
    for (const int count : {1, 3, 12}) list.add(count == 3, text("passes", count), passes(count));
    list.curve("multilevel-euler-substeps", "Multilevel (Euler): substeps of 1 pass");
    for (const int substeps : {2, 8})
        list.add(false, text("passes", 1, "substeps", substeps), passes(1), substeps);
}

void add_positional(List& list) {
    list.curve("xpbd", "XPBD: substeps");
    for (const int substeps : {1, 4, 16, 64})
        list.add(substeps == 4 || substeps == 16, text("substeps", substeps), Xpbd{1}, substeps);
    list.curve("xpbd-iterations", "XPBD: iterations");
    for (const int k : {4, 16, 64}) list.add(false, text("iterations", k), Xpbd{k});
    list.curve("fibres", "Fibres and sets: iterations");
    for (const int k : {4, 16, 64}) list.add(k == 4, text("iterations", k), Fibres{.iterations = k});
    list.curve("fibres-substeps", "Fibres and sets: substeps");
    for (const int substeps : {4, 16, 64})
        list.add(substeps == 16, text("iterations", 1, "substeps", substeps), Fibres{.iterations = 1},
                 substeps);
}

/// Substeps of a frame in which a step is 1.3 times shorter than the longest that is stable. A mode of
/// frequency omega is damped at the rate c = damping omega^2; the step must keep (omega h)^2 + 2 c h below 4.
/// 0: it would be 10^5 or more.
int explicit_substeps(const StudyScene& scene) {
    constexpr double margin = 1.3;
    const double omega = stiffest_frequency(scene);
    const double damping = static_cast<double>(scene.cloth.fabric.damping);
    const double longest = std::sqrt(damping * damping + 4 / (omega * omega)) - damping;
    const double substeps = std::ceil(static_cast<double>(scene.frame) * margin / longest);
    return substeps < 1e5 ? static_cast<int>(substeps) : 0;
}

void add_explicit(List& list, const StudyScene& scene) {
    list.curve("symplectic-euler", "Symplectic Euler: substeps");
    const int substeps = explicit_substeps(scene);
    if (substeps > 0) list.add(true, text("substeps", substeps), SymplecticEuler{}, substeps);
}

/// Adds Bullet's soft body, whose air is not ours.
void add_bullet([[maybe_unused]] List& list, [[maybe_unused]] const StudyScene& scene) {
#ifdef WEFT_WITH_BULLET
    if (scene.world.wind.air_density > 0) return;
    list.curve("bullet", "Bullet: iterations");
    for (const int k : {5, 20, 80}) {
        list.add(k == 20, text("iterations", k), Xpbd{})->make_peer =
            [k](const StudyScene& from, const Cloth& cloth) { return make_bullet_cloth(from, cloth, k); };
    }
#endif
}

void add_cholesky(List& list) {
    list.curve("cholesky", "Sparse Cholesky");
    MethodPoint* const point = list.add(true, "one factorisation a step", Jacobi{});
    point->make_solver = [](const ClothModel& model, const ClothSettings& settings) {
        return std::make_unique<CholeskySolver>(model, settings);
    };
}

}  // namespace

std::vector<MethodPoint> method_points(Coverage coverage, const StudyScene& scene) {
    // For larger scenes, one factorisation takes seconds, and explicit steps run into the thousands.
    const bool is_large = scene.mesh.positions.size() > 20'000,
               is_medium = scene.mesh.positions.size() > 5'000;
    List list(coverage);
    add_iterative(list);
    add_multilevel(list);
    add_positional(list);
    if (!is_large) add_explicit(list, scene);
    if (!is_medium) add_cholesky(list);
    if (!is_large) add_bullet(list, scene);
    std::vector<MethodPoint> points = list.take();
    mark_default(points);
    return points;
}

std::vector<MethodPoint> only_named(std::vector<MethodPoint> points, const std::string& text) {
    std::erase_if(points,
                  [&](const MethodPoint& point) { return point.name.find(text) == std::string::npos; });
    return points;
}

}  // namespace weft::study
