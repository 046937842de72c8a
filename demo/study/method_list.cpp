#include "demo/study/method_list.h"

#include <utility>

namespace weft::study {

namespace {

/// A point of one of the library's methods.
MethodPoint library_point(const std::string& name, const std::string& label, const std::string& setting,
                          const Method& method, int substeps = 1,
                          TimeScheme time_scheme = TimeScheme::backward_euler) {
    const auto configure = [=](ClothSettings& settings) {
        settings.method = method;
        settings.substeps = substeps;
        settings.time_scheme = time_scheme;
    };
    return {name, label, setting, configure, {}, false};
}

std::string numbered(const std::string& what, int number) {
    return what + "=" + std::to_string(number);
}

void append_jacobi(std::vector<MethodPoint>& points, Coverage coverage) {
    const std::vector<int> odd =
        coverage == Coverage::all ? std::vector{1, 3, 7, 15, 31, 63, 127, 255} : std::vector{7, 31, 127};
    for (const int k : odd)
        points.push_back(library_point("jacobi", "Jacobi (Kang), odd", numbered("iterations", k), Jacobi{k}));
    if (coverage == Coverage::quick) return;
    for (const int k : {8, 16, 64}) {
        points.push_back(
            library_point("jacobi-even", "Jacobi (Kang), even", numbered("iterations", k), Jacobi{k}));
    }
}

}  // namespace

std::vector<MethodPoint> method_points(Coverage coverage) {
    std::vector<MethodPoint> points;
    append_jacobi(points, coverage);
    return points;
}

std::vector<MethodPoint> usual_points() {
    return {
        library_point("jacobi", "Jacobi (Kang), odd", numbered("iterations", 15), Jacobi{15}),
        library_point("jacobi-even", "Jacobi (Kang), even", numbered("iterations", 16), Jacobi{16}),
    };
}

std::vector<MethodPoint> only_named(std::vector<MethodPoint> points, const std::string& text) {
    std::erase_if(points,
                  [&](const MethodPoint& point) { return point.name.find(text) == std::string::npos; });
    return points;
}

}  // namespace weft::study
