#pragma once
// A skinned character as glTF text, written by the format's description.

#include <array>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "demo/character/body/body.h"
#include "demo/character/garment/garment.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {

inline std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return digits;
}

/// Buffers and their descriptions, as they grow.
struct GltfText {
    std::string bytes, views, accessors;
    int count = 0;

    template <class T>
    int add(const std::vector<T>& values, const char* type, int component_type, std::size_t elements) {
        const std::string comma = count > 0 ? "," : "";
        views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(bytes.size()) + R"(,"byteLength":)" +
                 std::to_string(values.size() * sizeof(T)) + "}";
        accessors += comma + R"({"bufferView":)" + std::to_string(count) + R"(,"componentType":)" +
                     std::to_string(component_type) + R"(,"count":)" + std::to_string(elements) +
                     R"(,"type":")" + type + "\"}";
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        while (bytes.size() % 4 != 0) bytes += '\0';
        return count++;
    }
};

/// plain_skeleton() in a dress, with every node turned by a quarter about x at rest, which its child undoes.
struct GltfExample {
    Skeleton skeleton = plain_skeleton();
    Garment dress;
    GltfText data;
    std::string nodes, joints, primitives, animation;

    /// `vertices`: of the dress, about.
    explicit GltfExample(bool with_body = false, std::uint32_t vertices = 300) {
        JointAngles rest = JointAngles::at_rest(skeleton);
        rest.root = {0, 1, 0};
        Pose pose;
        place_joints(skeleton, rest, pose);
        dress = make_dress(Body::create(skeleton).value(), pose, vertices);
        const Quaternion quarter(Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vector3::UnitX()));
        for (std::size_t j = 0; j < skeleton.size(); ++j) {
            const Joint& joint = skeleton.joints[j];
            const bool root = joint.parent < 0;
            const Quaternion local = root ? quarter : Quaternion::Identity();
            const Vector3 t = root ? rest.root : Vector3(quarter.conjugate() * joint.offset);
            std::string children;
            for (std::size_t c = 0; c < skeleton.size(); ++c) {
                if (skeleton.joints[c].parent == static_cast<int>(j))
                    children += (children.empty() ? "" : ",") + std::to_string(c);
            }
            nodes += (root ? "" : ",") + std::string(R"({"name":")") + joint.name + R"(","translation":[)" +
                     text(t.x()) + "," + text(t.y()) + "," + text(t.z()) + R"(],"rotation":[)" +
                     text(local.x()) + ",0,0," + text(local.w()) + "]" +
                     (children.empty() ? "" : R"(,"children":[)" + children + "]") + "}";
            joints +=
                (root ? "" : ",") + std::to_string(skeleton.size() - 1 - j);  // in another order than nodes
        }
        nodes += R"(,{"name":"dress","mesh":0,"skin":0})";
        add_skin(pose, quarter);
        if (with_body) add_body();
        add_animation(quarter);
    }

    void add_skin(const Pose& pose, const Quaternion& quarter) {
        std::vector<float> inverse;
        for (std::size_t j = skeleton.size(); j-- > 0;) {
            const Eigen::Affine3f global = Eigen::Translation3f(pose.positions[j]) * quarter;
            const Eigen::Matrix4f matrix = global.inverse().matrix();
            inverse.insert(inverse.end(), matrix.data(), matrix.data() + 16);
        }
        data.add(inverse, "MAT4", 5126, skeleton.size());
        const std::set<std::uint32_t> fixed(dress.fixed.begin(), dress.fixed.end());
        std::vector<float> positions;
        for (const Vec3& p : dress.mesh.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
        // Half of the hips, half of the chest: joints 0 and 2, counted from the end.
        std::vector<std::uint8_t> bones;
        std::vector<float> weights;
        for (std::size_t v = 0; v < dress.mesh.positions.size(); ++v) {
            const auto last = static_cast<std::uint8_t>(skeleton.size() - 1);
            bones.insert(bones.end(), {last, static_cast<std::uint8_t>(last - 2), 0, 0});
            weights.insert(weights.end(), {0.5f, 0.5f, 0, 0});
        }
        const std::size_t count = dress.mesh.positions.size();
        const int p = data.add(positions, "VEC3", 5126, count), b = data.add(bones, "VEC4", 5121, count);
        const int w = data.add(weights, "VEC4", 5126, count);
        for (const bool free : {false, true}) {
            std::vector<std::uint16_t> indices;
            for (const Triangle& t : dress.mesh.triangles) {
                const bool is_fixed = fixed.contains(t[0]) && fixed.contains(t[1]) && fixed.contains(t[2]);
                if (is_fixed == free) continue;
                for (const std::uint32_t v : t) indices.push_back(static_cast<std::uint16_t>(v));
            }
            const int i = data.add(indices, "SCALAR", 5123, indices.size());
            primitives += (free ? "," : "") + std::string(R"({"attributes":{"POSITION":)") +
                          std::to_string(p) + R"(,"JOINTS_0":)" + std::to_string(b) + R"(,"WEIGHTS_0":)" +
                          std::to_string(w) + R"(},"indices":)" + std::to_string(i) + R"(,"material":)" +
                          (free ? "1" : "0") + "}";
        }
    }

    /// A box round the hips that goes with them, each vertex twice, as at seams.
    void add_body() {
        std::vector<float> positions, weights;
        std::vector<std::uint8_t> bones;
        std::vector<std::uint16_t> indices;
        const auto last = static_cast<std::uint8_t>(skeleton.size() - 1);
        for (int v = 0; v < 16; ++v) {
            positions.insert(positions.end(), {(v & 1) != 0 ? 0.07f : -0.07f, (v & 2) != 0 ? 1.05f : 0.75f,
                                               (v & 4) != 0 ? 0.06f : -0.06f});
            bones.insert(bones.end(), {last, 0, 0, 0});
            weights.insert(weights.end(), {1, 0, 0, 0});
        }
        for (const auto& [a, b, c, d] : std::array<std::array<int, 4>, 6>{
                 {{0, 4, 6, 2}, {1, 3, 7, 5}, {8, 9, 13, 12}, {10, 14, 15, 11}, {0, 2, 3, 1}, {4, 5, 7, 6}}})
            for (const int v : {a, b, c, a, c, d}) indices.push_back(static_cast<std::uint16_t>(v));
        const int p = data.add(positions, "VEC3", 5126, 16), b = data.add(bones, "VEC4", 5121, 16);
        const int w = data.add(weights, "VEC4", 5126, 16), i = data.add(indices, "SCALAR", 5123, 36);
        primitives += R"(,{"attributes":{"POSITION":)" + std::to_string(p) + R"(,"JOINTS_0":)" +
                      std::to_string(b) + R"(,"WEIGHTS_0":)" + std::to_string(w) + R"(},"indices":)" +
                      std::to_string(i) + R"(,"material":2})";
    }

    /// The left thigh goes from where it is forward by 60 degrees in a second.
    void add_animation(const Quaternion& quarter) {
        const Quaternion forward(Eigen::AngleAxisf(-std::numbers::pi_v<float> / 3, Vector3::UnitX()));
        const Quaternion local = quarter.conjugate() * forward * quarter;
        const int times = data.add(std::vector<float>{0, 1}, "SCALAR", 5126, 2);
        const int values = data.add(
            std::vector<float>{0, 0, 0, 1, local.x(), local.y(), local.z(), local.w()}, "VEC4", 5126, 2);
        animation = R"({"channels":[{"sampler":0,"target":{"node":)" +
                    std::to_string(*skeleton.find("LeftUpLeg")) +
                    R"(,"path":"rotation"}}],"samplers":[{"input":)" + std::to_string(times) +
                    R"(,"output":)" + std::to_string(values) + "}]}";
    }

    [[nodiscard]] std::string json(const std::string& buffer) const {
        return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + buffer + R"(","byteLength":)" +
               std::to_string(data.bytes.size()) + R"(}],"bufferViews":[)" + data.views +
               R"(],"accessors":[)" + data.accessors + R"(],"nodes":[)" + nodes +
               R"(],"skins":[{"joints":[)" + joints +
               R"(],"inverseBindMatrices":0}],"materials":[{"name":"GarmentTop"},{"name":"SkirtFree","pbrMetallicRoughness":{"baseColorFactor":[0.1,0.5,0.2,1]}},{"name":"Skin"}],"meshes":[{"primitives":[)" +
               primitives + R"(]}],"animations":[)" + animation + "]}";
    }
};

}  // namespace weft::demo
