// glTF files as hosts read them: forms of triangles, sparse and compressed data, skins and their motion.

#include "weft/gltf.h"

#include <array>
#include <cstring>
#include <random>

#include "tests/demo/character/gltf_example.h"
#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

/// A file of one node with one primitive, whose accessors are `data`'s.
Result<GltfAsset> load_plain(const GltfText& data, const std::string& primitive,
                             const std::string& more = "") {
    const TemporaryFile buffer("plain.bin", data.bytes);
    const TemporaryFile file(
        "plain.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)" +
                          primitive + R"(]}],"buffers":[{"byteLength":)" + std::to_string(data.bytes.size()) +
                          R"(,"uri":")" + buffer.path().filename().string() + R"("}],"bufferViews":[)" +
                          data.views + R"(],"accessors":[)" + data.accessors + "]" + more + "}");
    return GltfAsset::load(file.path());
}

/// A strip of five vertices in a plane, with its front towards +Z.
GltfText strip() {
    GltfText data;
    data.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3", 5126, 5);
    return data;
}

float front(const Mesh& mesh, const Triangle& t) {
    const auto at = [&](int k) { return to_vector(mesh.positions[t[static_cast<std::size_t>(k)]]); };
    return (at(1) - at(0)).cross(at(2) - at(0)).z();
}

TEST(GltfAsset, StripsAndFansFaceOneWay) {
    GltfText data = strip();
    data.add(std::vector<std::uint8_t>{0, 1, 2, 3, 3, 4}, "SCALAR", 5121, 6);
    data.add(std::vector<std::uint8_t>{0, 1, 3, 4}, "SCALAR", 5121, 4);
    for (const auto& [primitive, triangles] :
         {std::pair(R"({"attributes":{"POSITION":0},"mode":5})", 3u),
          {R"({"attributes":{"POSITION":0},"indices":1,"mode":5})", 2u},  // the doubled corner only joins
          {R"({"attributes":{"POSITION":0},"indices":2,"mode":6})", 2u},
          {R"({"attributes":{"POSITION":0},"mode":1})", 0u}}) {
        const auto asset = load_plain(data, primitive);
        ASSERT_TRUE(asset.ok()) << asset.error().message;
        const Mesh mesh = asset->mesh();
        EXPECT_EQ(mesh.triangles.size(), triangles) << primitive;
        for (const Triangle& t : mesh.triangles) EXPECT_GT(front(mesh, t), 0.5f) << primitive;
    }
}

TEST(GltfAsset, AFaultyPrimitiveIsLeftOutOfTheAnswerAndSaidToBe) {
    GltfText data = strip();
    data.add(std::vector<std::uint8_t>{0, 1, 5}, "SCALAR", 5121, 3);
    const std::string sound = R"({"attributes":{"POSITION":0},"mode":5})",
                      faulty = R"({"attributes":{"POSITION":0},"indices":1})";
    const auto asset = load_plain(data, faulty + "," + sound);
    ASSERT_TRUE(asset.ok()) << asset.error().message;
    ASSERT_EQ(asset->parts().size(), 1u);
    EXPECT_EQ(asset->mesh().triangles.size(), 3u);
    ASSERT_EQ(asset->left_out().size(), 1u);
    const GltfLeftOut& left_out = asset->left_out().front();
    EXPECT_EQ(left_out.primitive, 0u);
    EXPECT_EQ(left_out.positions.size(), 5u);
    EXPECT_EQ(left_out.fault.code, ErrorCode::malformed_file);
    EXPECT_NE(left_out.fault.message.find("meshes[0].primitives[0] at nodes[0]: of 5 vertices: accessors[1] "
                                          "has index 5.000000, in element 2; it must be a whole number"),
              std::string::npos)
        << left_out.fault.message;
    EXPECT_TRUE(load_plain(data, sound + "," + sound)->left_out().empty());
    const auto none = load_plain(data, faulty);
    ASSERT_FALSE(none.ok()) << "nothing is left";
    EXPECT_NE(none.error().message.find("has index 5"), std::string::npos) << none.error().message;
}

TEST(GltfAsset, SparseElementsReplaceThoseOfTheView) {
    GltfText data = strip();
    data.add(std::vector<std::uint8_t>{1, 4}, "SCALAR", 5121, 2);
    data.add(std::vector<float>{3, 0, 0, 0, 7, 0}, "VEC3", 5126, 2);
    const auto sparse = [&](const std::string& view, const std::string& count, const std::string& of) {
        GltfText changed = data;
        changed.accessors +=
            R"(,{)" + view + R"("componentType":5126,"count":)" + of +
            R"(,"type":"VEC3","sparse":{"count":)" + count +
            R"(,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}})";
        return load_plain(changed, R"({"attributes":{"POSITION":3},"mode":5})");
    };
    const auto mesh = sparse(R"("bufferView":0,)", "2", "5").value().mesh();
    EXPECT_EQ(to_vector(mesh.positions[1]), Vector3(3, 0, 0));
    EXPECT_EQ(to_vector(mesh.positions[3]), Vector3(1, 1, 0));
    EXPECT_EQ(to_vector(mesh.positions[4]), Vector3(0, 7, 0));
    const auto zeros = sparse("", "1", "5").value().mesh();
    EXPECT_EQ(to_vector(zeros.positions[1]), Vector3(3, 0, 0));
    EXPECT_EQ(to_vector(zeros.positions[4]), Vector3(0, 0, 0));
    for (const auto& [view, count, of, named] :
         {std::array<std::string, 4>{"", "3", "5", "accessors[3].sparse.indices has 3 elements"},
          {"", "9", "5", "accessors[3].sparse.count is 9"},
          {"", "2", "3", "accessors[3].sparse has index 4"},
          {"", "2", "1000000000", "there may be 1048576"}}) {
        const auto refused = sparse(view, count, of);
        ASSERT_FALSE(refused.ok()) << named;
        EXPECT_NE(refused.error().message.find(named), std::string::npos) << refused.error().message;
    }
}

/// A sheet by Draco 1.5.5: 3 x 3 vertices, eight triangles at z = x y / 4, 14 bits a coordinate.
constexpr auto draco_sheet =
    "RFJBQ08CAgEBAAAACQgBCAIAA3/aB/8BEf8CiEAC/wAAAAAAAQAJAwAAAgEDCQIAAQIBAQEADyt1HDkOA1UVBHX2HYz///8PgPz/AMD/"
    "AQD8/wAAAADwfwAAAAAEAAD+DwAAAIAAAMD/AQCA/wMAAAAA/z8AAAAAAAAAAAAAAAAAAAAAgD8OAQEBAA0DrSonVRUDKmJM/////w8A"
    "AOD/gAAAAAAA/w8AAAAAAAAAAAAAAACAPww=";

std::string draco_file(const std::string& base64) {
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{"mesh":0}],)"
           R"("buffers":[{"byteLength":182,"uri":"data:application/octet-stream;base64,)" +
           base64 +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":182}],"accessors":[)"
           R"({"componentType":5126,"count":9,"type":"VEC3"},{"componentType":5126,"count":9,"type":"VEC2"},)"
           R"({"componentType":5125,"count":24,"type":"SCALAR"}],"meshes":[{"primitives":[{"attributes":)"
           R"({"POSITION":0,"TEXCOORD_0":1},"indices":2,"extensions":{"KHR_draco_mesh_compression":)"
           R"({"bufferView":0,"attributes":{"POSITION":0,"TEXCOORD_0":1}}}}]}]})";
}

TEST(GltfAsset, DracoIsReadOrSaidToBeMissing) {
    const TemporaryFile file("draco.gltf", draco_file(draco_sheet));
    const auto asset = GltfAsset::load(file.path());
    ASSERT_EQ(asset.ok(), GltfAsset::reads_draco());
    if (!asset) {
        EXPECT_NE(asset.error().message.find("KHR_draco_mesh_compression"), std::string::npos);
        return;
    }
    const Mesh mesh = asset->mesh();
    ASSERT_EQ(mesh.positions.size(), 9u);
    ASSERT_EQ(mesh.texcoords.size(), 9u);
    EXPECT_EQ(mesh.triangles.size(), 8u);
    for (std::size_t v = 0; v < 9; ++v) {
        const Vec3& p = mesh.positions[v];
        EXPECT_NEAR(p.z, 0.25f * p.x * p.y, 1e-4f);
        EXPECT_NEAR(mesh.texcoords[v].x, p.x, 1e-3f);
        EXPECT_NEAR(mesh.texcoords[v].y, 1 - p.y, 1e-3f);
    }
    for (const Triangle& t : mesh.triangles) EXPECT_GT(front(mesh, t), 0.2f);
}

TEST(GltfAsset, RefusesWhatHidesTheData) {
    for (const char* name : {"EXT_meshopt_compression", "EXT_mesh_gpu_instancing"}) {
        const auto asset =
            load_plain(strip(), R"({"attributes":{"POSITION":0},"mode":5})",
                       std::string(R"(,"extensionsRequired":["KHR_materials_unlit",")") + name + "\"]");
        ASSERT_FALSE(asset.ok());
        EXPECT_NE(asset.error().message.find(name), std::string::npos) << asset.error().message;
        EXPECT_EQ(asset.error().message.find("unlit"), std::string::npos) << "materials do not matter";
    }
}

/// The example, with the joints and weights of each vertex given twice.
std::string with_eight_influences(const GltfExample& example, const std::string& buffer) {
    std::string json = example.json(buffer);
    for (std::size_t at = 0; (at = json.find("\"JOINTS_0\":", at)) != json.npos; ++at) {
        const std::size_t end = json.find('}', at);
        std::string again = json.substr(at, end - at);
        for (const char* name : {"JOINTS_0", "WEIGHTS_0"})
            again[again.find(name) + std::strlen(name) - 1] = '1';
        json.insert(end, "," + again);
    }
    return json;
}

TEST(GltfAsset, VerticesFollowEightJointsAsTheyDoFour) {
    const GltfExample example;
    const TemporaryFile buffer("eight.bin", example.data.bytes);
    const std::string name = buffer.path().filename().string();
    const TemporaryFile four_file("four.gltf", example.json(name));
    const TemporaryFile eight_file("eight.gltf", with_eight_influences(example, name));
    const auto four = GltfAsset::load(four_file.path()), eight = GltfAsset::load(eight_file.path());
    ASSERT_TRUE(four.ok()) << four.error().message;
    ASSERT_TRUE(eight.ok()) << eight.error().message;
    const GltfPart &a = four->parts().front(), &b = eight->parts().front();
    EXPECT_EQ(a.influences, 4u);
    ASSERT_EQ(b.influences, 8u);
    ASSERT_EQ(b.weights.size(), 2 * a.weights.size());
    for (std::size_t v = 0; v < a.mesh.positions.size(); ++v) {
        EXPECT_LT((to_vector(a.mesh.positions[v]) - to_vector(b.mesh.positions[v])).norm(), 1e-6f);
        EXPECT_FLOAT_EQ(b.weights[8 * v], 0.25f) << "eight weights sum to 1";
        EXPECT_EQ(b.joints[8 * v + 4], b.joints[8 * v]);
    }
}

TEST(GltfAsset, MatricesTakeTheRestPoseToThatOfATime) {
    const GltfExample example;
    const TemporaryFile buffer("posed.bin", example.data.bytes);
    const TemporaryFile file("posed.gltf", example.json(buffer.path().filename().string()));
    const auto asset = GltfAsset::load(file.path());
    ASSERT_TRUE(asset.ok()) << asset.error().message;
    EXPECT_DOUBLE_EQ(asset->duration(), 1);
    const std::vector<GltfJoint>& joints = asset->joints();
    std::vector<GltfMatrix> at_rest(joints.size()), turned(joints.size());
    ASSERT_TRUE(asset->pose(0, at_rest).ok());
    ASSERT_TRUE(asset->pose(1, turned).ok());
    EXPECT_FALSE(asset->pose(0, std::span(at_rest).first(1)).ok());
    for (std::size_t j = 0; j < joints.size(); ++j) {
        EXPECT_LT(joints[j].parent, static_cast<int>(j)) << "parents come first";
        const auto place = [&](const std::vector<GltfMatrix>& matrices) {
            return Vector3(Eigen::Affine3f(Eigen::Map<const Eigen::Matrix4f>(matrices[j].data())) *
                           to_vector(joints[j].rest));
        };
        EXPECT_LT((place(at_rest) - to_vector(joints[j].rest)).norm(), 1e-5f) << joints[j].name;
        const bool moves = joints[j].name.starts_with("Left") && to_vector(joints[j].rest).y() < 0.85f &&
                           joints[j].name != "LeftUpLeg";
        if (joints[j].name.empty()) continue;
        EXPECT_EQ((place(turned) - to_vector(joints[j].rest)).norm() > 0.05f, moves) << joints[j].name;
    }
}

TEST(GltfAsset, DamagedFilesAreReadOrRefusedWithTheirName) {
    const GltfExample example(true, 60);
    const std::string bytes = example.data.bytes, json = with_eight_influences(example, "damaged.bin");
    std::mt19937 random(49);
    const auto below = [&](std::size_t n) { return random() % n; };
    int refused = 0;
    constexpr int files = 3000;
    for (int n = 0; n < files; ++n) {
        const bool is_draco = n % 3 == 0;
        std::string text = is_draco ? draco_file(draco_sheet) : json, data = bytes;
        constexpr std::string_view digits = "0123456789+/ABCabc";
        for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
            if (is_draco) {
                text[text.find("base64,") + 7 + below(243)] = digits[below(digits.size())];
                continue;
            }
            const std::size_t at = text.find_first_of("0123456789", below(text.size() - 100));
            if (at != text.npos && below(4) > 0) text[at] = digits[below(10)];
            data[below(data.size())] = static_cast<char>(random());
        }
        const TemporaryFile buffer("damaged.bin", data);
        if (const auto at = text.find("damaged.bin"); at != text.npos)
            text.replace(at, 11, buffer.path().filename().string());
        const TemporaryFile file("damaged.gltf", text);
        const auto asset = GltfAsset::load(file.path());
        refused += asset.ok() ? 0 : 1;
        if (!asset) {
            EXPECT_NE(asset.error().message.find("damaged."), std::string::npos) << asset.error().message;
            continue;
        }
        const Mesh mesh = asset->mesh();
        for (const Vec3& p : mesh.positions) ASSERT_TRUE(to_vector(p).allFinite());
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t) ASSERT_LT(v, mesh.positions.size());
        for (const GltfPart& part : asset->parts())
            for (const std::uint32_t joint : part.joints) ASSERT_LT(joint, asset->joints().size());
        std::vector<GltfMatrix> joints(asset->joints().size());
        (void)asset->pose(asset->duration(), joints);
    }
    EXPECT_GT(refused, files / 10) << "the damage does something";
    EXPECT_LT(refused, files) << "some of it is harmless";
}

}  // namespace
}  // namespace weft::demo
