// The demo's readers of files.

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "demo/character/character.h"
#include "demo/character/garment/garment_file.h"
#include "demo/character/garment/gltf_file.h"
#include "demo/character/motion/motion.h"
#include "demo/look/settings_values.h"
#include "demo/options/fabric_file.h"
#include "tests/demo/character/gltf_example.h"
#include "tests/fuzz/readers/mutation.h"
#include "tests/fuzz/readers/reader.h"

namespace weft::fuzz {

namespace {

using nlohmann::json;
using std::filesystem::path;

bool is_finite(const Vector3& v) {
    return v.allFinite();
}

void check_recording(const demo::Recording& recording) {
    must(!recording.frames.empty() && recording.frame_time > 0, "a motion without frames");
    const auto& joints = recording.skeleton.joints;
    must(!joints.empty(), "a skeleton without joints");
    for (std::size_t j = 0; j < joints.size(); ++j) {
        must(joints[j].parent < static_cast<int>(j) && (j == 0) == (joints[j].parent < 0),
             "a joint before its parent");
        must(is_finite(joints[j].offset), "an offset that is not finite");
    }
    for (const demo::JointAngles& frame : recording.frames) {
        must(frame.rotations.size() == joints.size(), "a frame of other joints");
        must(is_finite(frame.root), "a root that is not finite");
        for (const auto& q : frame.rotations) must(std::abs(q.norm() - 1) < 1e-3f, "a rotation that is none");
    }
}

void check_garment(const demo::Garment& garment) {
    check_mesh(garment.mesh, "the garment");
    const std::size_t vertices = garment.mesh.positions.size();
    for (const std::uint32_t v : garment.fixed) must(v < vertices, "a vertex is fixed that is not there");
    for (const float part : {garment.colour.x, garment.colour.y, garment.colour.z})
        must(part >= 0 && part <= 1, "a colour beyond 0 to 1");
    for (const demo::PaintedMap& map : garment.maps) {
        must(map.values.size() == vertices, "a map of other vertices");
        for (const float value : map.values) must(!std::isnan(value), "a map of what is no number");
    }
}

void check_weights(const demo::SkinnedMesh& skinned, const demo::Skeleton& skeleton) {
    const Mesh& mesh = skinned.mesh;
    must(skinned.joints.size() == skinned.influences * mesh.positions.size() &&
             skinned.weights.size() == skinned.joints.size(),
         "weights of other vertices");
    for (const std::uint32_t joint : skinned.joints)
        must(joint < skeleton.size(), "a joint that is not there");
    for (const float weight : skinned.weights)
        must(weight >= 0 && std::isfinite(weight), "a weight that is none");
}

/// Somebody dressed by the file, for a few steps: what their motion and garment come to is finite, or they
/// are refused.
void dress(const demo::CharacterSettings& settings, const std::string& file) {
    auto character = demo::Character::create(settings);
    if (!character) return check_error(character.error(), file);
    World world = World::create({.threads = 1}).value();
    if (!character->enter(world)) return;
    for (int step = 0; step < 3; ++step) {
        character->before_step(world, step / 60.0, 1.0f / 60);
        world.step(1.0f / 60);
    }
    check_finite(world.cloth(character->cloth())->positions, "somebody's garment");
}

void as_cloth(const Mesh& mesh) {
    World world = World::create({.threads = 1}).value();
    const auto cloth = world.add_cloth(mesh);
    if (!cloth) return;
    world.step(1.0f / 60);
    check_finite(world.cloth(*cloth)->positions, "the cloth");
}

std::string obj_text() {
    const Mesh mesh = tube(10, 5);
    std::string text = "mtllib worn.mtl\n";
    for (const Vec3& p : mesh.positions)
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.z) + " " + std::to_string(-p.y) +
                " 0.5 0.25 1\n";
    for (const Vec2& t : mesh.texcoords)
        text += "vt " + std::to_string(t.x) + " " + std::to_string(t.y) + "\n";
    text += "usemtl SkirtFree\n";
    for (const Triangle& t : mesh.triangles) {
        if (&t == &mesh.triangles[mesh.triangles.size() - 20]) text += "usemtl Belt\n";
        text += "f";
        for (const std::uint32_t v : t) text += " " + std::to_string(v + 1) + "/" + std::to_string(v + 1);
        text += "\n";
    }
    return text;
}

bool read_garment_files(Random& random, const path& folder) {
    static const std::array<std::string, 3> texts{
        obj_text(), "newmtl SkirtFree\nKd 0.1 0.2 0.3\nillum 2\nnewmtl Belt\nKd 1 1 1\n",
        "# maps\nleash all 0.2\nleash 2-3 0.1 # nearer\nfriction red 4\nbackstop 1-9 0.01\nmass green 2\npin "
        "41-50 1\nthickness all 1\n"};
    static constexpr std::array names{"worn.obj", "worn.mtl", "worn.maps"};
    const std::size_t damaged = random.below(5);
    for (std::size_t k = 0; k < texts.size(); ++k)
        write_file(folder / names[k],
                   std::max<std::size_t>(damaged, 2) - 2 == k ? mutated_text(random, texts[k]) : texts[k]);
    const auto garment = demo::read_garment(folder / "worn.obj");
    if (!garment) {
        check_error(garment.error(), "worn.");
        return false;
    }
    check_garment(*garment);
    if (random.chance(0.02)) {
        demo::CharacterSettings settings;
        settings.garment = folder / "worn.obj";
        dress(settings, "worn.");
    }
    return true;
}

/// A .glb file of it, now and then with lengths of chunks that are wrong.
std::string glb(Random& random, const std::string& text, const std::string& binary) {
    std::string bytes = "glTF";
    const auto put = [&](std::uint32_t word) {
        const bool is_damaged = random.chance(0.02);
        if (is_damaged) spoil_word(random, std::as_writable_bytes(std::span(&word, 1)));
        bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    const auto whole = [](const std::string& chunk) {
        return static_cast<std::uint32_t>((chunk.size() + 3) / 4 * 4);
    };
    put(2);
    put(28 + whole(text) + whole(binary));
    put(whole(text));
    put(0x4E4F534A);
    bytes += text + std::string(whole(text) - text.size(), ' ');
    put(whole(binary));
    put(0x004E4942);
    return bytes + binary + std::string(whole(binary) - binary.size(), '\0');
}

/// The file in one of its forms, with its buffer in the same file, beside it, or within its text.
path write_gltf(Random& random, const path& folder) {
    static demo::GltfExample example(true, 60);
    static const json whole = [] {
        const int places = example.data.add(std::vector<std::uint16_t>{0, 3}, "SCALAR", 5123, 2);
        const int values = example.data.add(std::vector<float>(6, 0.1f), "VEC3", 5126, 2);
        json text = json::parse(example.json("worn.bin"));
        json& primitives = text["meshes"][0]["primitives"];
        json& body = primitives[2]["attributes"];
        body["JOINTS_1"] = body["JOINTS_0"];
        body["WEIGHTS_1"] = body["WEIGHTS_0"];
        primitives[2]["mode"] = 5;
        text["accessors"][body["POSITION"].get<std::size_t>()]["sparse"] = {
            {"count", 2},
            {"indices", {{"bufferView", places}, {"componentType", 5123}}},
            {"values", {{"bufferView", values}}}};
        text["animations"][0]["samplers"][0]["interpolation"] = "LINEAR";
        text["meshes"][0]["primitives"][0]["mode"] = 4;
        text["nodes"][1]["scale"] = {1, 1, 1};
        return text;
    }();
    std::string binary = example.data.bytes;
    const std::size_t form = random.below(3);
    if (random.chance(0.3))
        for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits)
            spoil_word(random, std::as_writable_bytes(std::span(binary)));
    json text = whole;
    if (form == 1) text["buffers"][0].erase("uri");
    if (form == 2) {
        text["buffers"][0] = {{"byteLength", 6}, {"uri", "data:application/octet-stream;base64,AAECAwQF"}};
        text["accessors"] = {{{"bufferView", 0}, {"componentType", 5121}, {"count", 2}, {"type", "VEC3"}}};
        text["bufferViews"] = {{{"buffer", 0}, {"byteLength", 6}}};
        text.erase("skins");
        text.erase("animations");
        text["nodes"] = {{{"mesh", 0}, {"children", {1}}},
                         {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
        text["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"COLOR_0", 0}}}}}}}};
    }
    const bool is_damaged = random.chance(0.9);
    const std::string written = is_damaged ? mutated_json(random, text) : text.dump();
    if (form != 1) {
        write_file(folder / "worn.bin", random.chance(0.05) ? mutated_bytes(random, binary) : binary);
        write_file(folder / "worn.gltf", written);
        return folder / "worn.gltf";
    }
    std::string bytes = glb(random, written, binary);
    write_file(folder / "worn.glb", random.chance(0.1) ? mutated_bytes(random, std::move(bytes)) : bytes);
    return folder / "worn.glb";
}

bool read_gltf_files(Random& random, const path& folder) {
    std::filesystem::remove(folder / "worn.maps");
    const path file = write_gltf(random, folder);
    const bool with_body = random.chance(0.5);
    const auto character = demo::read_gltf(file, with_body);
    if (!character) check_error(character.error(), "worn.");
    if (character) {
        must(demo::has_skin(file), "somebody is read of whom it is said that they are not there");
        check_recording(character->recording);
        must(is_finite(character->rest.root), "a place at rest that is not finite");
        check_garment(character->garment);
        check_weights(character->worn, character->recording.skeleton);
        if (with_body) {
            check_mesh(character->body.mesh, "the body");
            check_weights(character->body, character->recording.skeleton);
        }
        if (random.chance(0.05)) {
            demo::CharacterSettings settings;
            settings.garment = file;
            settings.surface = with_body ? demo::BodySurface::skin : demo::BodySurface::capsules;
            dress(settings, "worn.");
        }
    }
    const auto mesh = demo::read_gltf_mesh(file);
    if (!mesh) check_error(mesh.error(), "worn.");
    if (mesh) check_mesh(*mesh, "the mesh");
    if (mesh && random.chance(0.1)) as_cloth(*mesh);
    return character.ok() || mesh.ok();
}

/// plain_skeleton() with three frames.
std::string bvh_text() {
    const demo::Skeleton skeleton = demo::plain_skeleton();
    std::string text = "HIERARCHY\n";
    std::size_t channels = 0;
    const auto write = [&](const auto& self, std::size_t j) -> void {
        const demo::Joint& joint = skeleton.joints[j];
        text += joint.parent < 0 ? "ROOT " : joint.name.empty() ? "End " : "JOINT ";
        text += (joint.name.empty() ? "Site" : joint.name) + "\n{\nOFFSET";
        for (const float part : joint.offset) text += " " + std::to_string(part);
        if (joint.parent < 0)
            text += "\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation";
        if (joint.parent >= 0 && !joint.name.empty()) text += "\nCHANNELS 3 Zrotation Xrotation Yrotation";
        channels += joint.parent < 0 ? 6 : joint.name.empty() ? 0 : 3;
        text += "\n";
        for (std::size_t c = j + 1; c < skeleton.size(); ++c)
            if (skeleton.joints[c].parent == static_cast<int>(j)) self(self, c);
        text += "}\n";
    };
    write(write, 0);
    text += "MOTION\nFrames: 3\nFrame Time: 0.02\n";
    for (int frame = 0; frame < 3; ++frame) {
        text += "0 1 " + std::to_string(0.01 * frame);
        for (std::size_t c = 3; c < channels; ++c) text += " " + std::to_string(2 * frame);
        text += "\n";
    }
    return text;
}

bool read_bvh_files(Random& random, const path& folder) {
    static const std::string whole = bvh_text();
    const path file = folder / "moved.bvh";
    write_file(file, mutated_text(random, whole));
    const auto recording = demo::read_bvh(file);
    if (!recording) {
        check_error(recording.error(), "moved.bvh");
        return false;
    }
    check_recording(*recording);
    if (random.chance(0.02)) {
        demo::CharacterSettings settings;
        settings.motion = file;
        settings.particles = 100;
        dress(settings, "moved.bvh");
    }
    return true;
}

bool read_fabric_files(Random& random, const path& folder) {
    static const std::array<json, 2> wholes{
        json{{"areal_density", 0.2},
             {"warp", 400},
             {"weft", 400},
             {"shear", 100},
             {"bending", 2e-5},
             {"damping", 2e-4},
             {"stiffening", 0},
             {"bending_ratio", 1}},
        json{{"density", 0.2},
             {"stretching",
              {{200, 1, 1000, 50},
               {200, 1, 1000, -20},
               {200, 1, 1000, 70},
               {200, 1, 1000, 60},
               {200, 1, 1000, 60},
               {200, 1, 1000, 60}}},
             {"bending", {{4e-5, 4e-5, 4e-5, 4e-5, 4e-5}, {8e-5, 8e-5, 8e-5, 8e-5, 8e-5}, {0, 0, 0, 0, 0}}}}};
    const path file = folder / "fabric.json";
    write_file(file, mutated_json(random, wholes[random.below(2)]));
    const auto fabric = demo::load_fabric(
        file, random.chance(0.3) ? demo::MeasuredStretch::stiffening : demo::MeasuredStretch::constant);
    if (!fabric) {
        check_error(fabric.error(), "fabric.json");
        return false;
    }
    ClothSettings settings;
    settings.fabric = *fabric;
    // A combination may still be refused, as a stiffening that is too much for the stiffness.
    const auto cooked = CookedCloth::create(tube(5, 3), settings);
    must(cooked.ok() || cooked.error().message.find("stiffening") != std::string::npos,
         "a fabric was read that no cloth may have: " +
             (cooked.ok() ? std::string() : cooked.error().message));
    return true;
}

bool read_settings_files(Random& random, const path& folder) {
    static const json whole = json::parse(demo::settings_text("flag", {}));
    const path file = folder / "settings.json";
    write_file(file, mutated_json(random, whole));
    const auto read = demo::read_settings(file, {}, {});
    const auto scene = demo::scene_of_settings(file);
    if (!scene) check_error(scene.error(), "settings.json");
    if (!read) {
        check_error(read.error(), "settings.json");
        return false;
    }
    World world = World::create({.threads = 1}).value();
    const auto cloth = world.add_cloth(tube(5, 3));
    const auto set = world.set_settings(read->world);
    must(set.ok(),
         "settings were read that no World may have: " + (set.ok() ? std::string() : set.error().message));
    (void)world.set_cloth_settings(*cloth, read->cloth);
    return true;
}

}  // namespace

std::vector<Reader> demo_readers() {
    return {{"garment", read_garment_files},
            {"gltf", read_gltf_files},
            {"bvh", read_bvh_files},
            {"fabric", read_fabric_files},
            {"settings", read_settings_files}};
}

}  // namespace weft::fuzz
