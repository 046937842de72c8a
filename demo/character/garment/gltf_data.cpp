#include "demo/character/garment/gltf_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace weft::demo {
namespace {

Error broken(const std::string& what) {
    return {ErrorCode::malformed_file, what};
}

template <class T>
double number_at(const unsigned char* at, bool normalised) {
    T value;
    std::memcpy(&value, at, sizeof value);
    const auto number = static_cast<double>(value);
    if (!normalised || std::is_floating_point_v<T>) return number;
    return std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double number_of_type(const unsigned char* at, int type, bool normalised) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return number_at<std::int8_t>(at, normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return number_at<std::uint8_t>(at, normalised);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return number_at<std::int16_t>(at, normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return number_at<std::uint16_t>(at, normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return number_at<std::uint32_t>(at, normalised);
        default:
            return number_at<float>(at, normalised);
    }
}

template <class Container>
bool holds(const Container& container, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < container.size();
}

Vector3 three(const std::vector<double>& values, std::size_t first) {
    return {static_cast<float>(values[first]), static_cast<float>(values[first + 1]),
            static_cast<float>(values[first + 2])};
}

Eigen::Quaternionf four(const std::vector<double>& values, std::size_t first) {
    const Eigen::Quaternionf q(static_cast<float>(values[first + 3]), static_cast<float>(values[first]),
                               static_cast<float>(values[first + 1]), static_cast<float>(values[first + 2]));
    return q.norm() > 1e-6f ? q.normalized() : Eigen::Quaternionf::Identity();
}

NodePlace place_of(const tinygltf::Node& node) {
    NodePlace place;
    if (node.matrix.size() == 16) {
        Eigen::Matrix4f matrix;
        for (int i = 0; i < 16; ++i)
            matrix(i % 4, i / 4) = static_cast<float>(node.matrix[static_cast<std::size_t>(i)]);
        place.translation = matrix.block<3, 1>(0, 3);
        Matrix3 axes = matrix.block<3, 3>(0, 0);
        for (int i = 0; i < 3; ++i) place.scale[i] = std::max(axes.col(i).norm(), 1e-6f);
        for (int i = 0; i < 3; ++i) axes.col(i) /= place.scale[i];
        place.rotation = Eigen::Quaternionf(axes).normalized();
        return place;
    }
    if (node.translation.size() == 3) place.translation = three(node.translation, 0);
    if (node.rotation.size() == 4) place.rotation = four(node.rotation, 0);
    if (node.scale.size() == 3) place.scale = three(node.scale, 0);
    return place;
}

}  // namespace

Result<tinygltf::Model> load_gltf(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file))
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be read; name a glTF file"};
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    tinygltf::Model model;
    std::string errors, warnings;
    const bool binary = file.extension() == ".glb";
    const bool loaded = binary ? loader.LoadBinaryFromFile(&model, &errors, &warnings, file.string())
                               : loader.LoadASCIIFromFile(&model, &errors, &warnings, file.string());
    if (loaded) return model;
    return broken(file.string() + ": " + (errors.empty() ? "is no glTF file" : errors));
}

Result<std::vector<double>> gltf_numbers(const tinygltf::Model& model, int accessor, int components) {
    if (!holds(model.accessors, accessor)) return broken("there is no accessor " + std::to_string(accessor));
    const tinygltf::Accessor& from = model.accessors[static_cast<std::size_t>(accessor)];
    const std::string name = "accessor " + std::to_string(accessor);
    if (from.sparse.isSparse || !holds(model.bufferViews, from.bufferView))
        return broken(name + " is sparse or has no view");
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(from.bufferView)];
    if (!holds(model.buffers, view.buffer)) return broken(name + " has no buffer");
    const int has = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(from.type));
    if (has != components)
        return broken(name + " has " + std::to_string(has) + " components; it must have " +
                      std::to_string(components));
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(from.componentType));
    const int stride = from.ByteStride(view);
    if (size <= 0 || size > 4 || stride < size * components)
        return broken(name + " is of a type that cannot be read");
    const std::vector<unsigned char>& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t first = view.byteOffset + from.byteOffset,
                      element = static_cast<std::size_t>(size * components);
    const std::size_t step = static_cast<std::size_t>(stride);
    const bool fits = first <= bytes.size() && from.count <= bytes.size() &&
                      (from.count == 0 || (from.count - 1) * step + element <= bytes.size() - first);
    if (!fits) return broken(name + " goes beyond its buffer");
    std::vector<double> numbers;
    numbers.reserve(from.count * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < from.count; ++i) {
        for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
            const unsigned char* at = bytes.data() + first + i * step + c * static_cast<std::size_t>(size);
            numbers.push_back(number_of_type(at, from.componentType, from.normalized));
            if (!std::isfinite(numbers.back()))
                return broken(name + " has a number that is not finite, in element " + std::to_string(i));
        }
    }
    return numbers;
}

Result<std::vector<Triangle>> gltf_triangles(const tinygltf::Model& model,
                                             const tinygltf::Primitive& primitive, std::size_t vertices,
                                             const std::string& name) {
    std::vector<double> indices;
    if (primitive.indices >= 0) {
        auto read = gltf_numbers(model, primitive.indices, 1);
        if (!read) return read.error();
        indices = std::move(*read);
    } else {
        for (std::size_t v = 0; v < vertices; ++v) indices.push_back(static_cast<double>(v));
    }
    if ((primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES) || indices.size() % 3 != 0)
        return broken("the primitive of material " + name + " is not of triangles");
    std::vector<Triangle> triangles(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (!(indices[i] >= 0 && indices[i] < static_cast<double>(vertices)))
            return broken("the primitive of material " + name + " has index " + std::to_string(indices[i]) +
                          "; it has " + std::to_string(vertices) + " vertices");
        triangles[i / 3][i % 3] = static_cast<std::uint32_t>(indices[i]);
    }
    return triangles;
}

std::vector<NodePlace> gltf_places(const tinygltf::Model& model) {
    std::vector<NodePlace> places;
    for (const tinygltf::Node& node : model.nodes) places.push_back(place_of(node));
    return places;
}

Result<std::vector<int>> gltf_parents(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        for (const int child : model.nodes[n].children) {
            if (holds(parents, child)) parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
        }
    }
    for (std::size_t n = 0; n < parents.size(); ++n) {  // those that go round would have no end
        std::size_t steps = 0;
        for (auto at = static_cast<int>(n); at >= 0; at = parents[static_cast<std::size_t>(at)])
            if (++steps > parents.size()) return broken("node " + std::to_string(n) + " is its own ancestor");
    }
    return parents;
}

std::vector<Eigen::Affine3f> gltf_globals(const std::vector<NodePlace>& places,
                                          const std::vector<int>& parents) {
    std::vector<Eigen::Affine3f> globals;
    for (std::size_t n = 0; n < places.size(); ++n) {
        Eigen::Affine3f global = Eigen::Affine3f::Identity();
        for (auto at = static_cast<int>(n); at >= 0; at = parents[static_cast<std::size_t>(at)]) {
            const NodePlace& place = places[static_cast<std::size_t>(at)];
            global = Eigen::Translation3f(place.translation) * place.rotation * Eigen::Scaling(place.scale) *
                     global;
        }
        globals.push_back(global);
    }
    return globals;
}

Result<GltfAnimation> GltfAnimation::create(const tinygltf::Model& model) {
    GltfAnimation animation;
    if (model.animations.empty()) return animation;
    const tinygltf::Animation& from = model.animations.front();
    for (const tinygltf::AnimationChannel& channel : from.channels) {
        if (!holds(model.nodes, channel.target_node) || !holds(from.samplers, channel.sampler)) continue;
        if (channel.target_path != "translation" && channel.target_path != "rotation" &&
            channel.target_path != "scale")
            continue;
        const tinygltf::AnimationSampler& sampler = from.samplers[static_cast<std::size_t>(channel.sampler)];
        const int components = channel.target_path == "rotation" ? 4 : 3;
        auto times = gltf_numbers(model, sampler.input, 1);
        if (!times) return times.error();
        auto values = gltf_numbers(model, sampler.output, components);
        if (!values) return values.error();
        const bool spline = sampler.interpolation == "CUBICSPLINE";
        const std::size_t size = static_cast<std::size_t>(components), keys = times->size();
        if (keys == 0 || values->size() != keys * size * (spline ? 3 : 1) || !std::ranges::is_sorted(*times))
            return broken("an animation's sampler has " + std::to_string(keys) +
                          " times, in order or not, for " + std::to_string(values->size() / size) +
                          " values");
        if (spline) {  // before, at and after each time
            for (std::size_t k = 0; k < keys * size; ++k)
                (*values)[k] = (*values)[(3 * (k / size) + 1) * size + k % size];
            values->resize(keys * size);
        }
        animation.duration_ = std::max(animation.duration_, times->back());
        animation.tracks_.push_back({static_cast<std::size_t>(channel.target_node),
                                     channel.target_path.front(), sampler.interpolation == "STEP",
                                     std::move(*times), std::move(*values), size});
    }
    return animation;
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
        if (track.kind == 'r') {
            place.rotation = four(track.values, a).slerp(p, four(track.values, b));
            continue;
        }
        const Vector3 value = three(track.values, a) + p * (three(track.values, b) - three(track.values, a));
        (track.kind == 't' ? place.translation : place.scale) = value;
    }
}

}  // namespace weft::demo
