#include "demo/study/stability/stability_causes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "cloth/equation/implicit_system.h"
#include "cloth/solver/make_system.h"
#include "demo/study/machine.h"
#include "demo/study/stability/stability_cell.h"
#include "demo/study/stability/stability_points.h"
#include "weft/settings.h"

namespace weft::study {

namespace {

double value(const CsvRow& row, const std::string& column) {
    return parse_number(row.at(column)).value_or(std::nan(""));
}

bool broke(const CsvRow& row, const char* tolerance) {
    return row.at("broken").find(tolerance) != std::string::npos;
}

/// The same cell of another method; null if it was not run.
const CsvRow* same_cell(const CsvTable& table, const CsvRow& row, const std::string& method) {
    const auto found = std::ranges::find_if(table.rows, [&](const CsvRow& other) {
        return other.at("method") == method &&
               std::ranges::all_of(std::array{"per_side", "start", "stiffness", "hz"},
                                   [&](const char* key) { return other.at(key) == row.at(key); });
    });
    return found == table.rows.end() ? nullptr : &*found;
}

/// Damping rates: beta is that of springs in proportion to their stiffness, c = beta omega^2 in a mode; drag
/// is stability_scene()'s [1/s].
constexpr double drag = 3;
const auto beta = static_cast<double>(Fabric{}.damping);

/// The longest step at which no mode grows [s] (see ExplicitEulerSolver).
double explicit_bound(double omega) {
    const double swinging = std::min(omega, 2 / beta);
    const double bound = beta + drag / (swinging * swinging);
    const double c = beta * omega * omega + drag, discriminant = c * c - 4 * omega * omega;
    return discriminant < 0 ? bound : std::min(bound, 4 / (c + std::sqrt(discriminant)));
}

/// The cause of a failure that the linear bounds of the sheet at rest do not explain.
std::string nonlinear_cause(const CsvRow& row) {
    if (row.at("start") == "collapsed") return "springs squeezed to a point turn within one step";
    return "modes across taut springs are damped by drag alone, which is too little for this step";
}

std::string explicit_cause(const CsvRow& row) {
    const double h = value(row, "h_s");
    if (h <= explicit_bound(value(row, "h_omega") / h)) return nonlinear_cause(row);
    return "the step is longer than damping makes up for: h > c / omega^2 in modes that swing";
}

/// A step of a mode has the determinant 1 - h c and the trace 2 - h c - h^2 omega^2: its eigenvalues stay
/// within the unit circle while h^2 omega^2 + 2 h c < 4.
std::string symplectic_cause(const CsvRow& row) {
    const double h_omega = value(row, "h_omega");
    if (h_omega * h_omega * (1 + 2 * beta / value(row, "h_s")) < 4) return nonlinear_cause(row);
    return "h > 2 / omega of the stiffest mode, or a little less as springs are damped: each step amplifies "
           "it";
}

/// True if exact solutions of each step's linear system break all the tolerances that this cell breaks.
bool exact_steps_fail_alike(const CsvRow& row, const CsvTable& table) {
    const CsvRow* const exact = same_cell(table, row, "cholesky");
    return exact != nullptr &&
           std::ranges::all_of(std::array{"energy", "stretch", "height"},
                               [&](const char* name) { return !broke(row, name) || broke(*exact, name); });
}

/// The linearisation is the cause if an exact solution of the same linear system breaks the same tolerances.
/// Otherwise the cause is `left`, the error that the solver leaves.
std::string linear_cause(const CsvRow& row, const CsvTable& table, const std::string& left) {
    if (row.at("verdict") != word(Verdict::wrong) || !exact_steps_fail_alike(row, table)) return left;
    if (broke(row, "height"))
        return "one linearisation: stiff springs resist turning, and the sheet falls late; an exact "
               "solution does too";
    return "one linearisation: particles leave along tangents and stretch springs; an exact "
           "solution does too";
}

std::string relaxation_cause(const CsvRow& row, const CsvTable& table) {
    if (value(row, "left") <= feeding_part)
        return "a solve leaves less than -1/3 of the error in the stiffest mode: backward Euler feeds it";
    return linear_cause(row, table, "long waves are left unsolved");
}

std::string positional_cause(const CsvRow& row) {
    if (broke(row, "stretch")) return "sweeps carry too little: stretch is left, whatever the stiffness";
    return "a little stretch is left, which at this stiffness is much energy";
}

/// "x 100 at 1/60 s"
std::string cell_name(const CsvRow& row) {
    return "x " + row.at("stiffness") + " at 1/" + row.at("hz") + " s";
}

/// Cells that fail for the same cause: their number, and the first.
struct Failing {
    int cells = 0;
    const CsvRow* first = nullptr;
};

void write_method(std::ostream& out, const CsvTable& table, const std::string& method) {
    std::map<std::string, std::array<int, verdict_count>> counts;  // by start
    std::map<std::string, Failing> causes;
    std::string label;
    for (const CsvRow& row : table.rows) {
        if (row.at("method") != method) continue;
        label = row.at("label");
        const Verdict verdict = verdict_of(row.at("verdict"));
        ++counts[row.at("start")][static_cast<std::size_t>(verdict)];
        if (verdict == Verdict::stable) continue;
        Failing& failing = causes[row.at("start") + ", " + row.at("verdict") + ": " + cause_of(row, table)];
        if (failing.cells++ == 0) failing.first = &row;
    }
    out << '\n' << label << '\n';
    for (const auto& [start, count] : counts) {
        out << "  " << start << ": " << count[0] << " / " << count[1] << " / " << count[2] << " / "
            << count[3] << '\n';
    }
    for (const auto& [cause, failing] : causes) {
        out << "  - " << cause << " (" << failing.cells << (failing.cells == 1 ? " cell" : " cells") << "; "
            << cell_name(*failing.first) << ")\n";
    }
}

}  // namespace

std::string cause_of(const CsvRow& row, const CsvTable& table) {
    const std::string& family = row.at("family");
    if (family == name_of(Family::explicit_euler)) return explicit_cause(row);
    if (family == name_of(Family::symplectic_euler)) return symplectic_cause(row);
    if (family == name_of(Family::relaxation)) return relaxation_cause(row, table);
    if (family == name_of(Family::positional)) return positional_cause(row);
    if (family == name_of(Family::one_linearisation))
        return linear_cause(row, table, "the linear system is left unsolved");
    return exact_steps_fail_alike(row, table)
               ? "the step's equation is left unsolved, where one exact linearisation is not enough either"
               : "the step's equation is left unsolved";
}

void write_causes(const CsvTable& table, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const std::filesystem::path file = folder / "stability-causes.txt";
    std::ofstream out(file);
    out << "Cells of the stability maps by method, and why those fail that do.\n"
           "Per start: stable / bounded but wrong / diverged / not a number.\n"
        << origin_of(table, "stability") << '\n';
    std::vector<std::string> methods;
    for (const CsvRow& row : table.rows)
        if (std::ranges::find(methods, row.at("method")) == methods.end())
            methods.push_back(row.at("method"));
    for (const std::string& method : methods) write_method(out, table, method);
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

namespace {

/// The flat sheet's system W, without drag.
class FlatSystem {
  public:
    FlatSystem(const StudyScene& scene, float gamma, float spring_damping)
        : cloth_(cook(scene.mesh).value(), scene.cloth) {
        cloth_.settings.air_damping = 0;
        cloth_.settings.fabric.damping = spring_damping;
        for (const std::uint32_t vertex : scene.pins) cloth_.pin(cloth_.model.vertex_to_particle[vertex]);
        system_ = make_system(cloth_.model, cloth_.settings);
        const std::span<const Vec4> positions = cloth_.state.positions.span();
        const std::span<const Vec4> velocities = cloth_.state.velocities.span();
        system_->linearise(serial_,
                           {.settings = cloth_.settings,
                            .h = gamma,
                            .gamma = gamma,
                            .rigidity = cloth_.settings.fabric.bending,
                            .positions = positions,
                            .velocities = velocities,
                            .base_positions = positions,
                            .base_velocities = velocities,
                            .external = {}},
                           velocities, LinearisedAbout::base);
    }

    /// The largest eigenvalue of a positive operator: apply(x, y) sets y.
    template <class Operator>
    double largest_eigenvalue(const Operator& apply) {
        const std::uint32_t n = cloth_.state.size();
        std::mt19937 random(1);
        AlignedBuffer<Vec4> x(n), y(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto next = [&] { return static_cast<float>(random()) * 0x1p-31f - 1; };
            if (inverse_mass(i) > 0) x[i] = {next(), next(), next(), 0};
        }
        double eigenvalue = 0;
        for (int iteration = 0; iteration < 400; ++iteration) {
            apply(x, y);
            double squared = 0;
            for (const Vec4& v : y.span()) squared += static_cast<double>(xyz(v).squaredNorm());
            eigenvalue = std::sqrt(squared);
            for (std::uint32_t i = 0; i < n; ++i)
                x[i] = to_vec4(xyz(y[i]) / static_cast<float>(eigenvalue), 0);
        }
        return eigenvalue;
    }

    [[nodiscard]] float inverse_mass(std::uint32_t i) const { return cloth_.state.positions[i].w; }
    ImplicitSystem& operator*() { return *system_; }
    Parallel& serial() { return serial_; }

  private:
    Cloth cloth_;
    Parallel serial_{1};
    std::unique_ptr<ImplicitSystem> system_;
};

}  // namespace

// The eigenvalue is that of M^-1 K: with gamma = 1 and no damping W = M + K.
double stiffest_frequency(const StudyScene& scene) {
    FlatSystem system(scene, 1, 0);
    return std::sqrt(system.largest_eigenvalue([&](AlignedBuffer<Vec4>& x, AlignedBuffer<Vec4>& y) {
        (*system).multiply(system.serial(), x.span(), y.span());
        for (std::uint32_t i = 0; i < x.size(); ++i)
            y[i] = to_vec4(system.inverse_mass(i) * xyz(y[i]) - xyz(x[i]), 0);
    }));
}

double largest_relaxed(const StudyScene& scene) {
    FlatSystem system(scene, scene.frame, scene.cloth.fabric.damping);
    AlignedBuffer<Vec4> product(scene.mesh.positions.size());
    return system.largest_eigenvalue([&](AlignedBuffer<Vec4>& x, AlignedBuffer<Vec4>& y) {
        (*system).multiply(system.serial(), x.span(), product.span());
        (*system).precondition(system.serial(), product.span(), 1, y.span());
    });
}

double left_by_jacobi(int iterations, double lambda) {
    return std::pow(1 - lambda, iterations + 1);
}

}  // namespace weft::study
