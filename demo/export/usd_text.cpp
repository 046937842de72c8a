#include "demo/export/usd_text.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr int frame_digits = 10;

std::string number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
    return text;
}
std::string tuple(const Vec3& v) {
    return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

/// Writes "[a, b, ...]" of `count` elements.
template <class Element>
void write_list(std::ostream& to, std::size_t count, const Element& element) {
    to << '[';
    for (std::size_t i = 0; i < count; ++i) to << (i == 0 ? "" : ", ") << element(i);
    to << ']';
}

/// Unit normals of vertices: means of their triangles' by area. +Y where a vertex has none.
std::vector<Vec3> normals_of(std::span<const Vec3> points, std::span<const Triangle> triangles) {
    std::vector<Vector3> sums(points.size(), Vector3::Zero());
    for (const auto& [a, b, c] : triangles) {
        const Vector3 corner = to_vector(points[a]);
        const Vector3 area = (to_vector(points[b]) - corner).cross(to_vector(points[c]) - corner);
        for (const std::uint32_t v : {a, b, c}) sums[v] += area;
    }
    std::vector<Vec3> normals;
    for (const Vector3& sum : sums)
        normals.push_back(to_vec3(sum.squaredNorm() > 0 ? sum.stableNormalized() : Vector3::UnitY()));
    return normals;
}

}  // namespace

UsdText::UsdText(const std::filesystem::path& file, const Mesh& mesh)
    : file_(file),
      stream_(file),
      normals_(normals_file(), std::ios::in | std::ios::out | std::ios::trunc),
      triangles_(mesh.triangles),
      points_(mesh.positions.size()) {}

Result<UsdText> UsdText::create(const std::filesystem::path& file, const Mesh& mesh, const Vec3& colour,
                                float roughness, double rate) {
    UsdText text(file, mesh);
    text.write_head(mesh, colour, roughness, rate);
    if (auto written = text.written(); !written) return written.error();
    return text;
}

void UsdText::write_head(const Mesh& mesh, const Vec3& colour, float roughness, double rate) {
    stream_ << "#usda 1.0\n(\n    defaultPrim = \"cloth\"\n    upAxis = \"Y\"\n    metersPerUnit = 1\n"
            << "    timeCodesPerSecond = " << rate << "\n    framesPerSecond = " << rate
            << "\n    startTimeCode = 0\n    endTimeCode = ";
    end_at_ = stream_.tellp();
    stream_
        << std::string(frame_digits, ' ') << "\n)\n\ndef Xform \"cloth\"\n{\n"
        << "    def Material \"fabric\"\n    {\n"
        << "        token outputs:surface.connect = </cloth/fabric/surface.outputs:surface>\n\n"
        << "        def Shader \"surface\"\n        {\n"
        << "            uniform token info:id = \"UsdPreviewSurface\"\n"
        << "            color3f inputs:diffuseColor = " << tuple(colour)
        << "\n            float inputs:roughness = " << number(roughness)
        << "\n            token outputs:surface\n        }\n    }\n\n"
        << "    def Mesh \"mesh\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n"
        << "        rel material:binding = </cloth/fabric>\n"
        << "        uniform bool doubleSided = 1\n        uniform token subdivisionScheme = \"none\"\n"
        << "        int[] faceVertexCounts = ";
    write_list(stream_, triangles_.size(), [](std::size_t) { return 3; });
    stream_ << "\n        int[] faceVertexIndices = ";
    write_list(stream_, 3 * triangles_.size(), [&](std::size_t i) { return triangles_[i / 3][i % 3]; });
    if (!mesh.texcoords.empty()) {
        stream_ << "\n        texCoord2f[] primvars:st = ";
        write_list(stream_, points_, [&](std::size_t v) {
            return "(" + number(mesh.texcoords[v].x) + ", " + number(mesh.texcoords[v].y) + ")";
        });
        stream_ << " (\n            interpolation = \"vertex\"\n        )";
    }
    stream_ << "\n        normal3f[] normals (\n            interpolation = \"vertex\"\n        )"
            << "\n        point3f[] points.timeSamples = {\n";
}

Result<void> UsdText::add(std::span<const Vec3> points) {
    if (points.size() != points_)
        return Error{ErrorCode::invalid_argument, file_.string() + ": a frame has " +
                                                      std::to_string(points.size()) +
                                                      " points; it must have " + std::to_string(points_)};
    const std::vector<Vec3> normals = normals_of(points, triangles_);
    const auto sample = [&](std::ostream& to, std::span<const Vec3> values) {
        to << "            " << frames_ << ": ";
        write_list(to, values.size(), [&](std::size_t v) { return tuple(values[v]); });
        to << ",\n";
    };
    sample(stream_, points);
    sample(normals_, normals);
    ++frames_;
    return written();
}

Result<void> UsdText::close() {
    normals_.seekg(0);
    stream_ << "        }\n        normal3f[] normals.timeSamples = {\n";
    if (frames_ > 0) stream_ << normals_.rdbuf();
    stream_ << "        }\n    }\n}\n";
    stream_.seekp(end_at_);
    stream_ << std::max(frames_ - 1, 0);
    stream_.flush();
    normals_.close();
    std::error_code ignored;
    std::filesystem::remove(normals_file(), ignored);
    return written();
}

Result<void> UsdText::written() const {
    if (stream_ && normals_) return {};
    return Error{ErrorCode::file_not_found, file_.string() + " cannot be written"};
}

}  // namespace weft::demo
