#include "demo/options/fabric_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "demo/must.h"
#include "demo/number_json.h"

namespace weft::demo {
namespace {

using Json = nlohmann::ordered_json;

/// Sets a field. Throws Refusal.
void set(const SettingNumber& field, const Json& value) {
    if (auto done = number_from_json(field, field.field, value); !done) refuse(done.error().message);
}

/// The numbers of the settings' fabric.
std::vector<SettingNumber> fields_of(ClothSettings& settings) {
    std::vector<SettingNumber> fields = *numbers_of(settings);
    std::erase_if(fields, [](const SettingNumber& each) { return each.type != std::string_view("Fabric"); });
    return fields;
}

const SettingNumber* find(const std::vector<SettingNumber>& fields, std::string_view name) {
    const auto found = std::ranges::find(fields, name, [](const auto& each) { return each.field; });
    return found == fields.end() ? nullptr : &*found;
}

Fabric read_own(const Json& json) {
    ClothSettings settings;
    const auto fields = fields_of(settings);
    for (const auto& [key, value] : json.items()) {
        const SettingNumber* const field = find(fields, key);
        if (field == nullptr) {
            std::string all;
            for (const SettingNumber& each : fields) all.append(each.field).append(", ");
            refuse("a fabric has no " + quoted_json(Json(key)) + "; it has " + all +
                   "or those of a measured one: density, stretching, bending");
        }
        set(*field, value);
    }
    return settings.fabric;
}

/// Reads a table of `rows` rows of `columns` numbers; none if the value is no such table.
std::optional<std::vector<std::vector<double>>> read_table(const Json& file, const char* key,
                                                           std::size_t rows, std::size_t columns) {
    const auto found = file.find(key);
    if (found == file.end() || !found->is_array() || found->size() != rows) return {};
    const Json& json = *found;
    std::vector<std::vector<double>> table;
    for (const Json& row : json) {
        if (!row.is_array() || row.size() != columns) return {};
        if (!std::ranges::all_of(row, [](const Json& each) { return each.is_number(); })) return {};
        table.push_back(row.get<std::vector<double>>());
    }
    return table;
}

/// Mean of the positive values, since a negative stiffness marks a fit that failed; 0 if there are none.
double mean_of_positive(const std::vector<std::vector<double>>& table, std::size_t first, std::size_t last) {
    double sum = 0;
    int count = 0;
    for (const auto& row : table)
        for (std::size_t k = first; k < last; ++k)
            if (row[k] > 0) {
                sum += row[k];
                ++count;
            }
    return count > 0 ? sum / count : 0;
}

constexpr int strains = 40;
constexpr double last_strain = 1.0 / 6;
using Curve = std::array<double, strains>;  // tensions at strains up to last_strain

double strain_at(int k) {
    return last_strain * (k + 1) / strains;
}

/// Tension per width where stiffness is linear from `at_rest` to `stretched` at the last strain.
Curve tension(double at_rest, double stretched) {
    Curve curve{};
    for (int k = 0; k < strains; ++k) {
        const double e = strain_at(k), c = at_rest + (stretched - at_rest) * e / last_strain;
        curve[static_cast<std::size_t>(k)] = std::max(c, 0.0) * (e + e * e / 2) * (1 + e);
    }
    return curve;
}

struct Fit {
    double stiffness, error;  ///< error: the greatest residual over the greatest tension
};
/// Fits K e (1 + stiffening e) to the curve by least squares.
Fit fit(const Curve& curve, double stiffening) {
    double product = 0, square = 0, greatest = 0, error = 0;
    const auto shape = [&](int k) { return strain_at(k) * (1 + stiffening * strain_at(k)); };
    for (int k = 0; k < strains; ++k) {
        product += shape(k) * curve[static_cast<std::size_t>(k)];
        square += shape(k) * shape(k);
    }
    for (int k = 0; k < strains; ++k) {
        const double truth = curve[static_cast<std::size_t>(k)];
        error = std::max(error, std::abs(product / square * shape(k) - truth));
        greatest = std::max(greatest, truth);
    }
    return {product / square, greatest > 0 ? error / greatest : 0};
}

/// K along both axes, and the stiffening with the least greatest error of both.
struct StretchFit {
    double c11, c22, stiffening;
};
StretchFit fit_stiffening(const std::vector<std::vector<double>>& samples) {
    const Curve along1 = tension(samples[0][0], samples[1][0]),
                along2 = tension(samples[0][2], samples[5][2]);
    const auto error = [&](double s) { return std::max(fit(along1, s).error, fit(along2, s).error); };
    double best = 0;
    for (double s = 0; s < 300; s += 0.25)
        if (error(s) < error(best)) best = s;
    return {fit(along1, best).stiffness, fit(along2, best).stiffness, best};
}

Fabric read_measured(const Json& json, MeasuredStretch stretch) {
    for (const auto& [key, value] : json.items())
        if (key != "density" && key != "stretching" && key != "bending")
            refuse("a measured fabric has no " + quoted_json(Json(key)) +
                   "; it has density, stretching and bending");
    ClothSettings settings;
    const auto fields = fields_of(settings);
    const SettingNumber& density = *find(fields, "areal_density");
    if (!json.contains("density")) refuse("density is missing; it must be " + range_text(density));
    set(density, json["density"]);
    const auto stretching = read_table(json, "stretching", 6, 4);
    if (!stretching) refuse("stretching must be 6 rows of 4 numbers: c11, c12, c22, c33 [N/m]");
    const auto bending = read_table(json, "bending", 3, 5);
    if (!bending) refuse("bending must be 3 rows, for 0, 45 and 90 degrees, of 5 numbers [N m]");

    StretchFit k{mean_of_positive(*stretching, 0, 1), mean_of_positive(*stretching, 2, 3), 0};
    const bool is_warp_first = k.c11 >= k.c22;
    if (stretch == MeasuredStretch::stiffening) k = fit_stiffening(*stretching);
    const std::pair<const char*, double> values[] = {{"warp", is_warp_first ? k.c11 : k.c22},
                                                     {"weft", is_warp_first ? k.c22 : k.c11},
                                                     {"shear", mean_of_positive(*stretching, 3, 4)},
                                                     {"bending", 0.25 * mean_of_positive(*bending, 0, 5)},
                                                     {"stiffening", k.stiffening}};
    for (const auto& [field, value] : values) set(*find(fields, field), value);
    return settings.fabric;
}

}  // namespace

Result<Fabric> load_fabric(const std::filesystem::path& file, MeasuredStretch stretch) {
    std::ifstream in(file);
    if (!in)
        return Error{ErrorCode::file_not_found,
                     file.string() + " cannot be read; it must be a JSON file of a fabric"};
    return caught_in(file, [&] {
        const auto parsed = parse_json<Json>(in);
        if (!parsed || !parsed->is_object())
            refuse("it must hold one JSON object, as {\"areal_density\": 0.2, \"warp\": 400}");
        const bool measured = parsed->contains("density") || parsed->contains("stretching");
        return measured ? read_measured(*parsed, stretch) : read_own(*parsed);
    });
}

Result<Fabric> find_fabric(const std::string& name_or_file) {
    constexpr std::string_view stiffening = "stiffening:";
    if (name_or_file.starts_with(stiffening))
        return load_fabric(name_or_file.substr(stiffening.size()), MeasuredStretch::stiffening);
    if (name_or_file.ends_with(".json")) return load_fabric(name_or_file);
    auto named = Fabric::named(name_or_file);
    if (named) return named;
    return Error{named.error().code, named.error().message + "; or a file that ends in .json"};
}

}  // namespace weft::demo
