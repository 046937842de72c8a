// A skinned character from a glTF file, read as it was written.

#include "demo/character/garment/gltf_file.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "demo/character/character.h"
#include "tests/demo/character/gltf_example.h"
#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

TEST(Gltf, HasSkeletonMotionAndGarment) {
    const GltfExample model;
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

TEST(Gltf, FixesWhatIsJoinedToFreeClothWhateverItsName) {
    const GltfExample model(true);
    const TemporaryFile buffer("joined.bin", model.data.bytes);
    std::string json = model.json(buffer.path().filename().string());
    json.replace(json.find("GarmentTop"), 10, "Bodice");
    const TemporaryFile file("joined.gltf", json);
    const auto read = read_gltf(file.path());
    ASSERT_TRUE(read.ok()) << read.error().message;
    const std::size_t vertices = model.dress.mesh.positions.size();
    EXPECT_EQ(read->garment.mesh.positions.size(), 2 * vertices);
    EXPECT_EQ(read->garment.fixed.size(), vertices);
    ASSERT_EQ(read->garment.notes.size(), 1u);
    EXPECT_NE(read->garment.notes[0].find("Skin"), std::string::npos)
        << "the body is left out, and said to be";
}

TEST(Gltf, DressesSomebody) {
    const GltfExample model;
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
        const GltfExample model(with_body);
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

TEST(Gltf, ABodyWithAHoleIsMetAndSaidToBeOpen) {
    const GltfExample model(true);
    const TemporaryFile buffer("open.bin", model.data.bytes);
    std::string json = model.json(buffer.path().filename().string());
    const std::string corners = R"("componentType":5123,"count":36)";  // of the box round the hips
    ASSERT_NE(json.find(corners), std::string::npos);
    json.replace(json.find(corners), corners.size(), R"("componentType":5123,"count":30)");
    const TemporaryFile file("open.gltf", json);
    CharacterSettings settings;
    settings.garment = file.path();
    settings.surface = BodySurface::skin;
    auto character = Character::create(settings);
    ASSERT_TRUE(character.ok()) << character.error().message;
    auto world = World::create({.threads = 1});
    const auto entered = character->enter(*world);
    ASSERT_TRUE(entered.ok()) << entered.error().message;
    EXPECT_NE(character->garment().notes.back().find("skin is open"), std::string::npos);
    ASSERT_EQ(character->colliders().size(), 1u);
    for (int step = 0; step < 60; ++step) {
        character->before_step(*world, step / 60.0, 1.0f / 60);
        world->step(1.0f / 60);
    }
    for (const Vec4& p : world->cloth(character->cloth())->positions)
        EXPECT_FALSE(p.w > 0 && std::abs(p.x) < 0.06f && p.y > 0.8f && p.y < 1 && std::abs(p.z) < 0.05f);
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
    const TemporaryFile unread("model.bin", GltfExample().data.bytes);
    const TemporaryFile skinned("skinned.gltf", GltfExample().json(unread.path().filename().string()));
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

/// Two quads: one of a green material, one of a material with a picture, whose data follow the numbers.
TEST(Gltf, MaterialsHaveTheirColoursAndPictures) {
    GltfText data;
    data.add(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0}, "VEC3", 5126, 3);
    data.add(std::vector<float>{0, 0.25f, 1, 0.25f, 1, 1}, "VEC2", 5126, 3);
    std::string tga(18, '\0');  // one pixel, red
    tga[2] = 2, tga[12] = tga[14] = 1, tga[16] = 24;
    tga += std::string("\0\0\xff", 3);
    const std::size_t numbers = data.bytes.size();
    const TemporaryFile buffer("printed.bin", data.bytes + tga);
    const auto json = [&](const std::string& image) {
        return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[
{"attributes":{"POSITION":0,"TEXCOORD_1":1},"material":0},{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":1}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":1,"texCoord":1}}},
{"pbrMetallicRoughness":{"baseColorFactor":[0,1,0,1]}}],"textures":[{},{"source":0}],"images":[)" +
               image + R"(],"buffers":[{"byteLength":)" + std::to_string(numbers + tga.size()) +
               R"(,"uri":")" + buffer.path().filename().string() + R"("}],"bufferViews":[)" + data.views +
               R"(,{"buffer":0,"byteOffset":)" + std::to_string(numbers) + R"(,"byteLength":)" +
               std::to_string(tga.size()) + R"(}],"accessors":[)" + data.accessors + "]}";
    };
    const TemporaryFile file("printed.gltf", json(R"({"bufferView":2,"mimeType":"image/png"})"));
    GltfSurface surface;
    const auto mesh = read_gltf_mesh(file.path(), &surface);
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_TRUE(surface.notes.empty());
    ASSERT_EQ(surface.parts.of_triangle, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_NE(surface.parts.parts[0].picture, nullptr);
    EXPECT_EQ(surface.parts.parts[0].picture->rgb, (std::vector<std::uint8_t>{255, 0, 0}));
    EXPECT_FLOAT_EQ(surface.parts.parts[1].front.x, 0);
    EXPECT_EQ(surface.parts.parts[1].picture, nullptr);
    ASSERT_EQ(mesh->texcoords.size(), 6u);
    EXPECT_FLOAT_EQ(mesh->texcoords[0].y, 0.75f) << "upwards";

    const TemporaryFile lacking("lacking.gltf", json(R"({"uri":"not here.png"})"));
    ASSERT_TRUE(read_gltf_mesh(lacking.path(), &surface).ok()) << "cloth needs no picture";
    ASSERT_EQ(surface.notes.size(), 1u);
    EXPECT_NE(surface.notes[0].find("not here.png"), std::string::npos) << surface.notes[0];
    const TemporaryFile wrong("wrong.gltf", json(R"({"bufferView":9})"));
    EXPECT_FALSE(read_gltf_mesh(wrong.path()).ok());
}

TEST(Gltf, ErrorsNameTheFileAndWhatItLacks) {
    const GltfExample model;
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
    EXPECT_NE(refusal("\"WEIGHTS_0\"", "\"WEIGHTS_9\"").find("GarmentTop: it has no WEIGHTS_0"),
              std::string::npos);
    EXPECT_NE(refusal("\"joints\":[", "\"joints\":[999,").find("joints[0] is 999"), std::string::npos);
    EXPECT_NE(refusal("\"type\":\"MAT4\"", "\"type\":\"VEC4\"").find("must have 16"), std::string::npos);
    EXPECT_NE(refusal("\"componentType\":5126,\"count\":26", "\"componentType\":5126,\"count\":999999"), "");
    EXPECT_NE(refusal("\"asset\"", "\"asset"), "");
    const auto missing = read_gltf("no/such.glb");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
}

/// The example with a body, one accessor of whose primitive `number` is replaced by `accessor`.
std::string with_accessor(const GltfExample& model, const std::string& buffer, std::size_t number,
                          const std::string& key, int accessor) {
    std::string json = model.json(buffer);
    std::size_t at = json.find("\"primitives\":[");
    for (std::size_t k = 0; k <= number; ++k) at = json.find("{\"attributes\"", at + 1);
    at = json.find('"' + key + "\":", at) + key.size() + 3;
    return json.replace(at, json.find_first_of(",}", at) - at, std::to_string(accessor));
}

TEST(Gltf, AFaultyBodyIsLeftOutAndAFaultyGarmentRefused) {
    GltfExample model(true);
    constexpr std::size_t top = 0, skirt = 1, body = 2;
    const int far = model.data.add(std::vector<std::uint16_t>{0, 1, 60000}, "SCALAR", 5123, 3);
    const int short_list = model.data.add(std::vector<std::uint16_t>{0, 1, 2, 3}, "SCALAR", 5123, 4);
    std::vector<float> places(48, 0.5f);
    places[7] = std::numeric_limits<float>::quiet_NaN();
    const int unknown = model.data.add(places, "VEC3", 5126, 16);
    const int few = model.data.add(std::vector<float>(8, 0.25f), "VEC4", 5126, 2);
    const TemporaryFile buffer("left_out.bin", model.data.bytes);
    const std::string name = buffer.path().filename().string();
    const TemporaryFile whole("whole.gltf", model.json(name));
    const Mesh sound = read_gltf(whole.path()).value().garment.mesh;
    struct Case {
        std::string key;
        int accessor;
        std::string named;
    };
    for (const auto& [key, accessor, named] :
         std::vector<Case>{{"indices", far, "has index 60000.000000, in element 2; it must be"},
                           {"indices", short_list, "there are 4 corners; they must be three a triangle"},
                           {"POSITION", unknown, "not finite, in element 2; all must be finite"},
                           {"WEIGHTS_0", few, "it has 2 weights and"}}) {
        const TemporaryFile file("left_out.gltf", with_accessor(model, name, body, key, accessor));
        const auto read = read_gltf(file.path());
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(read->garment.mesh.positions.size(), sound.positions.size());
        EXPECT_EQ(read->garment.mesh.triangles, sound.triangles);
        ASSERT_EQ(read->garment.notes.size(), 1u);
        for (const std::string& said : {std::string("meshes[0].primitives[2]"), std::string("Skin"), named})
            EXPECT_NE(read->garment.notes[0].find(said), std::string::npos) << read->garment.notes[0];
        const auto met = read_gltf(file.path(), true);
        ASSERT_FALSE(met.ok()) << "the body is to be met, and is faulty";
        EXPECT_NE(met.error().message.find(named), std::string::npos) << met.error().message;
        for (const std::size_t worn : {top, skirt}) {
            const TemporaryFile torn("torn.gltf", with_accessor(model, name, worn, key, accessor));
            const auto refused = read_gltf(torn.path());
            ASSERT_FALSE(refused.ok()) << key << " of primitive " << worn;
            for (const std::string& said :
                 {std::string("torn.gltf"), "primitives[" + std::to_string(worn) + "]", named})
                EXPECT_NE(refused.error().message.find(said), std::string::npos) << refused.error().message;
        }
    }
}

TEST(Gltf, WhatIsJoinedToFreeClothIsMissedWhateverItsName) {
    GltfExample model(true);
    const int far = model.data.add(std::vector<std::uint16_t>{0, 1, 60000}, "SCALAR", 5123, 3);
    const TemporaryFile buffer("bodice.bin", model.data.bytes);
    std::string json = with_accessor(model, buffer.path().filename().string(), 0, "indices", far);
    json.replace(json.find("GarmentTop"), 10, "Bodice");
    const TemporaryFile file("bodice.gltf", json);
    const auto read = read_gltf(file.path());
    ASSERT_FALSE(read.ok()) << "a skirt without its bodice would fall";
    EXPECT_NE(read.error().message.find("of material Bodice"), std::string::npos) << read.error().message;
}

TEST(Gltf, AValueThatIsMalformedIsNamed) {
    const GltfExample model;
    const TemporaryFile buffer("named.bin", model.data.bytes);
    const std::string whole = model.json(buffer.path().filename().string());
    const std::string bytes = std::to_string(model.data.bytes.size());
    struct Case {
        std::string from, to, named;
    };
    const std::string sampler = R"("channels":[{"sampler":0)";
    for (const auto& [from, to, named] : std::vector<Case>{
             {R"("version":"2.0")", R"("version":"1.0")", "asset.version is \"1.0\""},
             {R"("byteLength":)" + bytes, R"("byteLength":-1)", "buffers[0].byteLength is -1"},
             {R"("byteLength":)" + bytes, R"("byteLength":1e18)", "buffers[0].byteLength is 1e+18"},
             {R"("byteLength":)" + bytes, R"("byteLength":12)", "bufferViews[0] has"},
             {R"("byteOffset":0)", R"("byteOffset":1e15)", "bufferViews[0] has"},
             {R"("byteOffset":0)", R"("byteOffset":0,"byteStride":4)", "one every 4"},
             {R"("buffer":0)", R"("buffer":7)", "bufferViews[0].buffer is 7"},
             {R"("bufferView":0)", R"("bufferView":-1)", "accessors[0].bufferView is -1"},
             {R"("componentType":5126)", R"("componentType":0.5)", "accessors[0].componentType is 0.5"},
             {R"("type":"MAT4")", R"("type":"MAT5")", "accessors[0].type is \"MAT5\""},
             {R"("translation":[)", R"("translation":[0,1e39,0],"was":[)",
              "nodes[0].translation is [0,1e+39,0]"},
             {R"("translation":[)", R"("translation":[0,9e9,0],"was":[)", "nodes[0] comes to stand"},
             {R"("rotation":[)", R"("rotation":[0,0,0,0],"was":[)", "nodes[0].rotation is [0,0,0,0]"},
             {R"("children":[)", R"("children":[0,)", "is its own ancestor"},
             {R"("children":[)", R"("children":["x",)", "nodes[0].children[0] is \"x\""},
             {R"("skin":0)", R"("skin":1)", "skin is 1"},
             {R"("inverseBindMatrices":0)", R"("inverseBindMatrices":9999)",
              "skins[0].inverseBindMatrices is 9999"},
             {R"("indices":)", R"("indices":0,"was":)", "must have 1"},
             {sampler, R"("channels":[{"sampler":-1)", "animations[0].channels[0].sampler is -1"},
             {R"("path":"rotation")", R"("path":"turn")", "path is \"turn\""},
             {R"("nodes":[)", R"("nodes":[[],)", "nodes[0] is []"},
             {R"("nodes":)",
              R"("nodes":)" + std::string(100'000, '[') + std::string(100'000, ']') + R"(,"was":)",
              "nested more than 64 deep"}}) {
        std::string json = whole;
        ASSERT_NE(json.find(from), std::string::npos) << from;
        json.replace(json.find(from), from.size(), to);
        const TemporaryFile file("named.gltf", json);
        const auto read = read_gltf(file.path());
        ASSERT_FALSE(read.ok()) << to.substr(0, 99);
        EXPECT_EQ(read.error().code, ErrorCode::malformed_file);
        EXPECT_NE(read.error().message.find(named), std::string::npos) << read.error().message;
        EXPECT_NE(read.error().message.find("named.gltf"), std::string::npos) << read.error().message;
    }
}

TEST(Gltf, ABinaryFileThatIsCutOffAnywhereIsRefused) {
    const GltfExample model;
    std::string json = model.json("");
    json += std::string(3 - (json.size() + 3) % 4, ' ');
    const auto word = [](std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const std::string& binary = model.data.bytes;
    const std::string whole = "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) +
                              "JSON" + json + word(binary.size()) + std::string("BIN\0", 4) + binary;
    const TemporaryFile file("whole.glb", whole);
    const auto read = read_gltf(file.path());
    ASSERT_TRUE(read.ok()) << read.error().message;
    for (std::size_t size = 0; size < whole.size(); size += 1 + size / 9) {
        const TemporaryFile cut("cut.glb", whole.substr(0, size));
        const auto refused = read_gltf(cut.path());
        ASSERT_FALSE(refused.ok()) << size;
        EXPECT_NE(refused.error().message.find("cut.glb"), std::string::npos) << refused.error().message;
    }
}

}  // namespace
}  // namespace weft::demo
