#include "demo/gltf/gltf_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "cloth/mesh/coordinates.h"
#include "cloth/mesh/mesh_limits.h"
#include "demo/gltf/gltf_fields.h"

namespace weft {
namespace {

constexpr std::size_t most_numbers = std::size_t{1} << 26;  // of an animation

std::string name_of(std::size_t accessor) {
    return "accessors[" + std::to_string(accessor) + "]";
}

template <class T>
double number_at(const unsigned char* at, bool normalised) {
    T value;
    std::memcpy(&value, at, sizeof value);
    const auto number = static_cast<double>(value);
    if (!normalised || std::is_floating_point_v<T>) return number;
    return std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double number_of_type(const unsigned char* at, GltfType type, bool normalised) {
    switch (type) {
        case GltfType::i8:
            return number_at<std::int8_t>(at, normalised);
        case GltfType::u8:
            return number_at<std::uint8_t>(at, normalised);
        case GltfType::i16:
            return number_at<std::int16_t>(at, normalised);
        case GltfType::u16:
            return number_at<std::uint16_t>(at, normalised);
        case GltfType::u32:
            return number_at<std::uint32_t>(at, normalised);
        case GltfType::f32:
            break;
    }
    return number_at<float>(at, normalised);
}

Vector3 three(const std::vector<double>& values, std::size_t first) {
    return {static_cast<float>(values[first]), static_cast<float>(values[first + 1]),
            static_cast<float>(values[first + 2])};
}

Eigen::Quaternionf four(const std::vector<double>& values, std::size_t first) {
    const Eigen::Quaterniond q(values[first + 3], values[first], values[first + 1], values[first + 2]);
    return q.norm() > 1e-6 ? q.normalized().cast<float>() : Eigen::Quaternionf::Identity();
}

/// Calls `take(number, i, component)` for numbers that lie in a view, in order. read_gltf_model() has checked
/// their range.
template <class Take>
void for_each_in_view(const GltfModel& model, const GltfAccessor& of, std::size_t of_view, const Take& take) {
    const GltfView& view = model.views[of_view];
    const std::size_t size = bytes_of(of.type),
                      stride = view.stride == 0 ? size * of.components : view.stride;
    const unsigned char* const first = model.buffers[view.buffer].data() + view.offset + of.offset;
    for (std::size_t i = 0; i < of.count; ++i)
        for (std::size_t c = 0; c < of.components; ++c)
            take(number_of_type(first + i * stride + c * size, of.type, of.normalised), i, c);
}

/// The elements that a sparse accessor replaces.
Result<std::vector<std::size_t>> sparse_elements(const GltfModel& model, std::size_t index) {
    const GltfSparse& sparse = *model.accessors[index].sparse;
    const auto count = static_cast<double>(model.accessors[index].count);
    std::vector<double> read;
    for_each_in_view(model, {.offset = sparse.index_offset, .count = sparse.count, .type = sparse.index_type},
                     sparse.index_view,
                     [&](double number, std::size_t, std::size_t) { read.push_back(number); });
    std::vector<std::size_t> elements;
    for (const double number : read) {
        if (!(number >= 0 && number < count))
            return gltf_error(name_of(index) + ".sparse has index " + std::to_string(number) +
                              "; there are " + std::to_string(model.accessors[index].count));
        elements.push_back(static_cast<std::size_t>(number));
    }
    return elements;
}

/// All numbers of an accessor, in order, of which none is checked.
Result<std::vector<double>> raw_numbers(const GltfModel& model, std::size_t index, std::size_t components,
                                        bool normalised) {
    GltfAccessor accessor = model.accessors[index];
    accessor.normalised = normalised;
    if (!accessor.sparse && !accessor.view)
        return gltf_error(name_of(index) + " has neither a bufferView nor sparse values");
    if (accessor.components != components)
        return gltf_error(name_of(index) + " has " + std::to_string(accessor.components) +
                          " components; it must have " + std::to_string(components));
    std::vector<double> numbers(accessor.count * components);
    if (accessor.view)
        for_each_in_view(model, accessor, *accessor.view, [&](double number, std::size_t i, std::size_t c) {
            numbers[i * components + c] = number;
        });
    if (!accessor.sparse) return numbers;
    const auto elements = sparse_elements(model, index);
    if (!elements) return elements.error();
    accessor.offset = accessor.sparse->value_offset;
    accessor.count = elements->size();
    for_each_in_view(model, accessor, accessor.sparse->value_view,
                     [&](double number, std::size_t i, std::size_t c) {
                         numbers[(*elements)[i] * components + c] = number;
                     });
    return numbers;
}

}  // namespace

Result<std::vector<double>> gltf_numbers(const GltfModel& model, std::size_t accessor,
                                         std::size_t components) {
    auto numbers = raw_numbers(model, accessor, components, model.accessors[accessor].normalised);
    if (!numbers) return numbers;
    const auto wrong = std::ranges::find_if_not(*numbers, [](double n) { return std::isfinite(n); });
    if (wrong == numbers->end()) return numbers;
    return gltf_error(name_of(accessor) + " has a number that is not finite, in element " +
                      std::to_string(static_cast<std::size_t>(wrong - numbers->begin()) / components) +
                      "; all must be finite");
}

Result<std::vector<std::uint32_t>> gltf_indices(const GltfModel& model, std::size_t accessor,
                                                std::size_t components, std::size_t size) {
    const auto numbers = raw_numbers(model, accessor, components, false);
    if (!numbers) return numbers.error();
    std::vector<std::uint32_t> indices;
    indices.reserve(numbers->size());
    for (const double number : *numbers) {
        if (!(number >= 0 && number < static_cast<double>(size)) || number != std::floor(number))
            return gltf_error(name_of(accessor) + " has index " + std::to_string(number) + ", in element " +
                              std::to_string(indices.size() / components) +
                              "; it must be a whole number from 0 to below " + std::to_string(size));
        indices.push_back(static_cast<std::uint32_t>(number));
    }
    return indices;
}

Result<std::vector<Triangle>> gltf_triangles(const GltfModel& model, const GltfPrimitive& primitive,
                                             std::size_t vertices) {
    if (!primitive.triangles) return gltf_error("it is not of triangles");
    std::vector<std::uint32_t> indices;
    if (primitive.indices) {
        auto read = gltf_indices(model, *primitive.indices, 1, vertices);
        if (!read) return gltf_error("of " + std::to_string(vertices) + " vertices: " + read.error().message);
        indices = *std::move(read);
    } else {
        for (std::size_t v = 0; v < vertices; ++v) indices.push_back(static_cast<std::uint32_t>(v));
    }
    const bool is_list = primitive.triangles == GltfTriangles::list;
    const bool is_strip = primitive.triangles == GltfTriangles::strip;
    if (is_list && indices.size() % 3 != 0)
        return gltf_error("there are " + std::to_string(indices.size()) +
                          " corners; they must be three a triangle");
    std::vector<Triangle> triangles;
    for (std::size_t i = 2; i < indices.size(); i += is_list ? 3 : 1) {
        Triangle t{indices[i - 2], indices[i - 1], indices[i]};
        if (is_strip && i % 2 == 1) std::swap(t[0], t[1]);  // every other triangle of a strip is turned over
        if (primitive.triangles == GltfTriangles::fan) t[0] = indices[0];
        if (is_list || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])) triangles.push_back(t);
    }
    return triangles;
}

Result<void> count_part(std::size_t vertices, std::size_t triangles, GltfSize& all) {
    if (vertices > most_vertices - all.vertices || triangles > most_triangles - all.triangles)
        return Error{ErrorCode::invalid_mesh, "there are more than " + std::to_string(most_vertices) +
                                                  " vertices or " + std::to_string(most_triangles) +
                                                  " triangles, with those that are named many times; a mesh "
                                                  "may have so many"};
    all.vertices += vertices;
    all.triangles += triangles;
    return {};
}

Result<void> check_places(std::span<const Vec3> positions) {
    for (const Vec3& p : positions)
        if (!(to_vector(p).cwiseAbs().maxCoeff() <= runaway_distance))
            return gltf_error("vertex " + std::to_string(&p - positions.data()) + " comes to stand at (" +
                              std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
                              ") m; it must be within " + std::to_string(runaway_distance) + " m");
    return {};
}

std::vector<Vec3> finite_positions(const GltfModel& model, const GltfPrimitive& primitive) {
    std::vector<Vec3> finite;
    const auto accessor = primitive.attribute("POSITION");
    if (!accessor || primitive.fault) return finite;
    const auto numbers = raw_numbers(model, *accessor, 3, model.accessors[*accessor].normalised);
    if (!numbers) return finite;
    for (std::size_t i = 0; i < numbers->size(); i += 3)
        if (const Vector3 p = three(*numbers, i); p.allFinite()) finite.push_back(to_vec3(p));
    return finite;
}

std::vector<NodePlace> gltf_places(const GltfModel& model) {
    std::vector<NodePlace> places;
    for (const GltfNode& node : model.nodes) places.push_back(node.place);
    return places;
}

Result<std::vector<Eigen::Affine3f>> gltf_globals(const GltfModel& model,
                                                  const std::vector<NodePlace>& places) {
    std::vector<Eigen::Affine3f> globals(places.size(), Eigen::Affine3f::Identity());
    for (const std::size_t n : model.parents_first) {
        const NodePlace& place = places[n];
        const Eigen::Affine3f own =
            Eigen::Translation3f(place.translation) * place.rotation * Eigen::Scaling(place.scale);
        const auto& parent = model.nodes[n].parent;
        globals[n] = parent ? globals[*parent] * own : own;
        const Vector3 at = globals[n].translation();
        if (!globals[n].linear().allFinite() || !(at.cwiseAbs().maxCoeff() <= runaway_distance))
            return gltf_error(
                "nodes[" + std::to_string(n) + "] comes to stand at (" + std::to_string(at.x()) + ", " +
                std::to_string(at.y()) + ", " + std::to_string(at.z()) + ") m, or its scale to " +
                "more than a float holds; it must be within " + std::to_string(runaway_distance) + " m");
    }
    return globals;
}

Result<GltfAnimation> GltfAnimation::create(const GltfModel& model) {
    GltfAnimation animation;
    std::size_t numbers = 0;
    for (const GltfTrack& from : model.animation) {
        numbers += model.accessors[from.times].count + 4 * model.accessors[from.values].count;
        if (numbers > most_numbers)
            return gltf_error("the animation has more than " + std::to_string(most_numbers) + " numbers");
        auto track = read_track(model, from);
        if (!track) return track.error();
        animation.duration_ = std::max(animation.duration_, track->times.back());
        animation.tracks_.push_back(*std::move(track));
    }
    return animation;
}

Result<GltfAnimation::Track> GltfAnimation::read_track(const GltfModel& model, const GltfTrack& from) {
    const std::size_t size = from.path == GltfTrack::Path::rotation ? 4 : 3;
    auto times = gltf_numbers(model, from.times, 1);
    if (!times) return times.error();
    auto values = gltf_numbers(model, from.values, size);
    if (!values) return values.error();
    const bool spline = from.between == GltfTrack::Between::spline;
    const std::size_t keys = times->size();
    if (keys == 0 || values->size() != keys * size * (spline ? 3 : 1) || !std::ranges::is_sorted(*times))
        return gltf_error("the animation of node " + std::to_string(from.node) + " has " +
                          std::to_string(keys) + " times, in order or not, for " +
                          std::to_string(values->size() / size) + " values");
    if (spline) {  // three values a key: in-tangent, value, out-tangent
        for (std::size_t k = 0; k < keys * size; ++k)
            (*values)[k] = (*values)[(3 * (k / size) + 1) * size + k % size];
        values->resize(keys * size);
    }
    return Track{from.node,         from.path,          from.between == GltfTrack::Between::step,
                 *std::move(times), *std::move(values), size};
}

void GltfAnimation::pose(double time, std::vector<NodePlace>& places) const {
    for (const Track& track : tracks_) {
        const auto after =
            static_cast<std::size_t>(std::ranges::upper_bound(track.times, time) - track.times.begin());
        const std::size_t first = after == 0 ? 0 : after - 1,
                          second = std::min(after, track.times.size() - 1);
        const double between = track.times[second] - track.times[first];
        const double part =
            track.steps || !(between > 0) ? 0 : std::clamp((time - track.times[first]) / between, 0.0, 1.0);
        const auto p = static_cast<float>(part);
        const std::size_t a = first * track.components, b = second * track.components;
        NodePlace& place = places[track.node];
        if (track.path == GltfTrack::Path::rotation) {
            place.rotation = four(track.values, a).slerp(p, four(track.values, b));
            continue;
        }
        const Vector3 value = (1 - p) * three(track.values, a) + p * three(track.values, b);
        (track.path == GltfTrack::Path::translation ? place.translation : place.scale) = value;
    }
}

}  // namespace weft
