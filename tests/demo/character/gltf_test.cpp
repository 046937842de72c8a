// A skinned character from a glTF file, which the test writes by the format's description.

#include "demo/character/garment/gltf_file.h"

#include <cstring>
#include <numbers>
#include <set>

#include "demo/character/character.h"
#include "demo/character/garment/gltf_mesh.h"
#include "demo/character/motion/generated_walk.h"
#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

std::string text(double value) {
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
struct Model {
    Skeleton skeleton = plain_skeleton();
    Garment dress;
    GltfText data;
    std::string nodes, joints, primitives, animation;

    explicit Model(bool with_body = false) {
        JointAngles rest = JointAngles::at_rest(skeleton);
        rest.root = {0, 1, 0};
        Pose pose;
        place_joints(skeleton, rest, pose);
        dress = make_dress(Body::create(skeleton).value(), pose, 300);
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

TEST(Gltf, HasSkeletonMotionAndGarment) {
    const Model model;
    const TemporaryFile buffer("model.bin", model.data.bytes);
    const TemporaryFile file("model.gltf", model.json(buffer.path().filename().string()));
    const auto read = read_gltf(file.path());
    ASSERT_TRUE(read.ok()) << read.error().message;
    const Skeleton& skeleton = read->recording.skeleton;
    ASSERT_EQ(skeleton.size(), model.skeleton.size());
    const auto names = find_body_joints(skeleton);
    ASSERT_TRUE(names.ok()) << names.error().message;
    for (const Joint& joint : model.skeleton.joints) {
        if (joint.name.empty() || joint.parent < 0) continue;
        const auto found = skeleton.find(joint.name);
        ASSERT_TRUE(found.has_value()) << joint.name;
        EXPECT_LT((skeleton.joints[*found].offset - joint.offset).norm(), 1e-5f) << joint.name;
    }
    const std::size_t vertices = model.dress.mesh.positions.size();
    EXPECT_EQ(read->garment.mesh.triangles.size(), model.dress.mesh.triangles.size());
    ASSERT_EQ(read->garment.mesh.positions.size(), 2 * vertices);
    EXPECT_EQ(read->garment.fixed.size(), vertices);
    for (std::size_t v = 0; v < vertices; ++v)
        EXPECT_LT(
            (to_vector(read->garment.mesh.positions[v]) - to_vector(model.dress.mesh.positions[v])).norm(),
            1e-5f);
    EXPECT_FLOAT_EQ(read->garment.colour.y, 0.5f);

    ASSERT_EQ(read->recording.frames.size(), 61u);
    Pose pose;
    place_joints(skeleton, read->recording.frames[30], pose);
    const Vector3 thigh =
        pose.positions[(*names)[Part::left_shin]] - pose.positions[(*names)[Part::left_thigh]];
    EXPECT_LT((thigh.normalized() - Vector3(0, -std::cos(std::numbers::pi_v<float> / 6), 0.5f)).norm(),
              1e-3f);
}

TEST(Gltf, DressesSomebody) {
    const Model model;
    const TemporaryFile buffer("dressed.bin", model.data.bytes);
    const TemporaryFile file("dressed.gltf", model.json(buffer.path().filename().string()));
    CharacterSettings settings;
    settings.garment = file.path();
    auto character = Character::create(settings);
    ASSERT_TRUE(character.ok()) << character.error().message;
    auto world = World::create({.threads = 1});
    ASSERT_TRUE(character->enter(*world).ok());
    for (int step = 0; step < 90; ++step) {
        character->before_step(*world, step / 60.0, 1.0f / 60);
        world->step(1.0f / 60);
    }
    const ClothView& view = *world->cloth(character->cloth());
    EXPECT_LT(world->cloth_info(character->cloth())->particles, model.dress.mesh.positions.size() + 200);
    EXPECT_GT(view.bounds.lower.y, 0.3f) << "it hangs from the bodice";
    for (const std::uint32_t vertex : character->garment().fixed)
        EXPECT_EQ(view.positions[view.vertex_to_particle[vertex]].w, 0);

    settings.motion = "some.bvh";
    const auto both = Character::create(settings);
    ASSERT_FALSE(both.ok());
    EXPECT_NE(both.error().message.find("some.bvh"), std::string::npos) << both.error().message;
}

TEST(Gltf, ItsOwnBodyIsMetAsItsSkin) {
    for (const bool with_body : {true, false}) {
        const Model model(with_body);
        const TemporaryFile buffer("skinned.bin", model.data.bytes);
        const TemporaryFile file("skinned.gltf", model.json(buffer.path().filename().string()));
        EXPECT_TRUE(read_gltf(file.path()).value().body.mesh.positions.empty()) << "nobody asked for it";
        CharacterSettings settings;
        settings.garment = file.path();
        settings.surface = BodySurface::skin;
        auto character = Character::create(settings);
        EXPECT_EQ(character.ok(), with_body);
        if (!character) {
            EXPECT_NE(character.error().message.find("no triangles but the garment's"), std::string::npos);
            EXPECT_NE(character.error().message.find("skinned.gltf"), std::string::npos);
            continue;
        }
        EXPECT_EQ(character->skin().size(), 16u);
        EXPECT_EQ(character->garment().mesh.positions.size(),
                  read_gltf(file.path())->garment.mesh.positions.size());
        auto world = World::create({.threads = 1});
        const auto entered = character->enter(*world);
        ASSERT_TRUE(entered.ok()) << entered.error().message;
        const float before = (*character->skin_places())[0].y;
        for (int step = 0; step < 60; ++step) {
            character->before_step(*world, step / 60.0, 1.0f / 60);
            world->step(1.0f / 60);
        }
        EXPECT_NEAR((*character->skin_places())[0].y, before, 0.05f);
        for (const Vec4& p : world->cloth(character->cloth())->positions)
            EXPECT_FALSE(p.w > 0 && std::abs(p.x) < 0.06f && p.y > 0.8f && p.y < 1 && std::abs(p.z) < 0.05f);
    }
}

/// Two triangles that share no vertices, as exporters leave them at seams.
std::string plain_mesh(const GltfText& data, const TemporaryFile& buffer, const std::string& nodes) {
    return R"({"asset":{"version":"2.0"},"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":)" +
           std::to_string(data.bytes.size()) + R"(,"uri":")" + buffer.path().filename().string() +
           R"("}],"bufferViews":[)" + data.views + R"(],"accessors":[)" + data.accessors + "]}";
}

TEST(Gltf, AMeshWithNobodyInItIsClothWhereItsNodesPutIt) {
    GltfText data;
    data.add(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 5126, 6);
    const TemporaryFile buffer("plain.bin", data.bytes);
    const std::string moved = R"([{"translation":[0,2,0],"children":[1]},{"mesh":0,"scale":[3,1,1]}])";
    const TemporaryFile plain("plain.gltf", plain_mesh(data, buffer, moved));
    EXPECT_FALSE(has_skin(plain.path()));
    const auto mesh = read_gltf_mesh(plain.path());
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    ASSERT_EQ(mesh->triangles.size(), 2u);
    EXPECT_EQ(mesh->triangles[1], (Triangle{3, 4, 5}));
    EXPECT_EQ(to_vector(mesh->positions[4]), Vector3(3, 3, 0));
    const TemporaryFile unread("model.bin", Model().data.bytes);
    const TemporaryFile skinned("skinned.gltf", Model().json(unread.path().filename().string()));
    EXPECT_TRUE(has_skin(skinned.path()));
    for (const auto& [nodes, named] :
         {std::pair("[{}]", "no node has a mesh"), {R"([{"mesh":0,"children":[0]}])", "its own ancestor"}}) {
        const TemporaryFile wrong("wrong.gltf", plain_mesh(data, buffer, nodes));
        const auto refused = read_gltf_mesh(wrong.path());
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().message.find(named), std::string::npos) << refused.error().message;
        EXPECT_NE(refused.error().message.find("wrong.gltf"), std::string::npos) << refused.error().message;
    }
}

TEST(Gltf, ErrorsNameTheFileAndWhatItLacks) {
    const Model model;
    const TemporaryFile buffer("faulty.bin", model.data.bytes);
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string json = model.json(buffer.path().filename().string());
        EXPECT_NE(json.find(from), std::string::npos) << from;
        json.replace(json.find(from), from.size(), to);
        const TemporaryFile file("faulty.gltf", json);
        const auto read = read_gltf(file.path());
        if (read.ok()) return std::string();
        EXPECT_NE(read.error().message.find("faulty.gltf"), std::string::npos) << read.error().message;
        return read.error().message;
    };
    EXPECT_NE(refusal("SkirtFree", "Skirt").find("\"Free\""), std::string::npos);
    EXPECT_NE(refusal("\"WEIGHTS_0\"", "\"WEIGHTS_9\"").find("GarmentTop has no WEIGHTS_0"),
              std::string::npos);
    EXPECT_NE(refusal("\"joints\":[", "\"joints\":[999,").find("joint 999"), std::string::npos);
    EXPECT_NE(refusal("\"type\":\"MAT4\"", "\"type\":\"VEC4\"").find("must have 16"), std::string::npos);
    EXPECT_NE(refusal("\"componentType\":5126,\"count\":26", "\"componentType\":5126,\"count\":999999"), "");
    EXPECT_NE(refusal("\"asset\"", "\"asset"), "");
    const auto missing = read_gltf("no/such.glb");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
}

}  // namespace
}  // namespace weft::demo
