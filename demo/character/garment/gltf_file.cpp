#include "demo/character/garment/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "demo/character/garment/gltf_data.h"
#include "demo/character/garment/painted_maps.h"

namespace weft::demo {
namespace {

constexpr double frame_rate = 60, longest_animation = 600;  // [Hz], [s]

class GltfReader {
  public:
    GltfReader(tinygltf::Model model, bool with_body) : model_(std::move(model)), with_body_(with_body) {}

    Result<SkinnedCharacter> read() {
        if (model_.skins.empty() || model_.skins.front().joints.empty())
            return Error{ErrorCode::malformed_file, "there is no skin with joints; a character needs one"};
        if (auto sound = check_nodes(); !sound) return sound.error();
        place_nodes();
        make_skeleton();
        if (auto motion = read_motion(); !motion) return motion.error();
        if (auto mesh = read_meshes(); !mesh) return mesh.error();
        character_.garment.mesh = garment_.mesh;
        character_.joints = garment_.joints;
        character_.weights = garment_.weights;
        return std::move(character_);
    }
    [[nodiscard]] const std::vector<Vec3>& colours() const { return garment_.colours; }

  private:
    using Affine = Eigen::Affine3f;

    Result<void> check_nodes() {
        auto parents = gltf_parents(model_);
        if (!parents) return parents.error();
        parents_ = std::move(*parents);
        for (const int joint : skin().joints) {
            if (joint < 0 || static_cast<std::size_t>(joint) >= parents_.size())
                return Error{ErrorCode::malformed_file,
                             "the skin has joint " + std::to_string(joint) + "; there is no such node"};
        }
        return {};
    }

    void place_nodes() {
        places_ = gltf_places(model_);
        at_rest_ = gltf_globals(places_, parents_);
    }

    [[nodiscard]] const tinygltf::Skin& skin() const { return model_.skins.front(); }
    [[nodiscard]] std::size_t depth(int node) const {
        std::size_t found = 0;
        for (; node >= 0; node = parents_[static_cast<std::size_t>(node)]) ++found;
        return found;
    }
    static Quaternion rotation_of(const Affine& global) {
        Matrix3 axes = global.linear();
        for (int i = 0; i < 3; ++i) axes.col(i).normalize();
        return Quaternion(axes).normalized();
    }

    /// Parents first; turned so that nothing is turned at rest.
    void make_skeleton() {
        nodes_ = skin().joints;
        std::ranges::stable_sort(nodes_, {}, [&](int node) { return depth(node); });
        for (std::size_t j = 0; j < nodes_.size(); ++j) joint_of_node_[nodes_[j]] = j;
        Skeleton& skeleton = character_.recording.skeleton;
        for (std::size_t j = 0; j < nodes_.size(); ++j) {
            int parent = parents_[static_cast<std::size_t>(nodes_[j])];
            while (parent >= 0 && !joint_of_node_.contains(parent))
                parent = parents_[static_cast<std::size_t>(parent)];
            const std::size_t above = parent < 0 ? 0 : joint_of_node_[parent];
            const Vector3 place = at_rest_[static_cast<std::size_t>(nodes_[j])].translation();
            const Vector3 from = at_rest_[static_cast<std::size_t>(nodes_[above])].translation();
            skeleton.joints.push_back({model_.nodes[static_cast<std::size_t>(nodes_[j])].name,
                                       j == 0 ? -1 : static_cast<int>(above),
                                       j == 0 ? Vector3(Vector3::Zero()) : Vector3(place - from)});
        }
        character_.rest = JointAngles::at_rest(skeleton);
        character_.rest.root = at_rest_[static_cast<std::size_t>(nodes_.front())].translation();
    }

    Result<void> read_motion() {
        const auto animation = GltfAnimation::create(model_);
        if (!animation) return animation.error();
        Recording& recording = character_.recording;
        recording.frame_time = 1 / frame_rate;
        const auto frames = static_cast<std::size_t>(
                                std::floor(std::min(animation->duration(), longest_animation) * frame_rate)) +
                            1;
        for (std::size_t f = 0; f < frames; ++f) {
            std::vector<NodePlace> places = places_;
            animation->pose(static_cast<double>(f) / frame_rate, places);
            recording.frames.push_back(angles_of(gltf_globals(places, parents_)));
        }
        return {};
    }

    [[nodiscard]] JointAngles angles_of(const std::vector<Affine>& globals) const {
        JointAngles angles = character_.rest;
        std::vector<Quaternion> turned;
        for (std::size_t j = 0; j < nodes_.size(); ++j) {
            const auto node = static_cast<std::size_t>(nodes_[j]);
            turned.push_back(rotation_of(globals[node]) * rotation_of(at_rest_[node]).conjugate());
            const int parent = character_.recording.skeleton.joints[j].parent;
            angles.rotations[j] =
                parent < 0 ? turned[j]
                           : Quaternion(turned[static_cast<std::size_t>(parent)].conjugate() * turned[j]);
        }
        angles.root = globals[static_cast<std::size_t>(nodes_.front())].translation();
        return angles;
    }

    Result<void> read_meshes() {
        Garment& garment = character_.garment;
        garment.stands_ready = true;
        bool any_free = false;
        for (const tinygltf::Node& node : model_.nodes) {
            if (node.skin != 0 || node.mesh < 0 ||
                static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
                continue;
            for (const tinygltf::Primitive& primitive :
                 model_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
                const bool has_material =
                    primitive.material >= 0 &&
                    static_cast<std::size_t>(primitive.material) < model_.materials.size();
                const tinygltf::Material material =
                    has_material ? model_.materials[static_cast<std::size_t>(primitive.material)]
                                 : tinygltf::Material();
                const bool free = material.name.ends_with("Free");
                const bool is_worn = free || material.name.starts_with("Garment");
                if (!is_worn && !with_body_) continue;
                if (free && !any_free) take_colour(material);
                any_free = any_free || free;
                if (auto read =
                        read_primitive(primitive, material.name, free, is_worn ? garment_ : character_.body);
                    !read)
                    return read;
            }
        }
        if (!any_free)
            return Error{ErrorCode::invalid_mesh,
                         "no primitive of a mesh with the first skin has a material that ends in \"Free\"; "
                         "name so what is simulated"};
        if (with_body_ && character_.body.mesh.triangles.empty())
            return Error{ErrorCode::invalid_mesh,
                         "the first skin has no triangles but the garment's; a body to be met needs some"};
        return {};
    }

    void take_colour(const tinygltf::Material& material) {
        const std::vector<double>& colour = material.pbrMetallicRoughness.baseColorFactor;
        if (colour.size() >= 3)
            character_.garment.colour = {static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                                         static_cast<float>(colour[2])};
    }

    Result<std::vector<double>> attribute(const tinygltf::Primitive& primitive, const char* name,
                                          int components, const std::string& of) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end())
            return Error{ErrorCode::malformed_file, "the primitive of material " + of + " has no " + name};
        return gltf_numbers(model_, found->second, components);
    }

    Result<void> read_primitive(const tinygltf::Primitive& primitive, const std::string& name, bool free,
                                SkinnedMesh& to) {
        const auto positions = attribute(primitive, "POSITION", 3, name);
        if (!positions) return positions.error();
        const auto joints = attribute(primitive, "JOINTS_0", 4, name);
        if (!joints) return joints.error();
        const auto weights = attribute(primitive, "WEIGHTS_0", 4, name);
        if (!weights) return weights.error();
        const std::size_t vertices = positions->size() / 3;
        if (joints->size() != 4 * vertices || weights->size() != 4 * vertices)
            return Error{ErrorCode::malformed_file,
                         "the primitive of material " + name + " has " + std::to_string(weights->size() / 4) +
                             " weights and " + std::to_string(joints->size() / 4) + " joints for " +
                             std::to_string(vertices) + " positions"};
        const auto triangles = gltf_triangles(model_, primitive, vertices, name);
        if (!triangles) return triangles.error();
        const auto first = static_cast<std::uint32_t>(to.mesh.positions.size());
        for (const auto& [a, b, c] : *triangles)
            to.mesh.triangles.push_back({first + a, first + b, first + c});
        const auto inverse_binds = skin().inverseBindMatrices < 0
                                       ? Result<std::vector<double>>(std::vector<double>())
                                       : gltf_numbers(model_, skin().inverseBindMatrices, 16);
        if (!inverse_binds) return inverse_binds.error();
        if (auto colours = read_colours(primitive, vertices, to); !colours) return colours;
        for (std::size_t v = 0; v < vertices; ++v) {
            if (!free && &to == &garment_)
                character_.garment.fixed.push_back(static_cast<std::uint32_t>(to.mesh.positions.size()));
            if (auto added = add_vertex(*positions, *joints, *weights, *inverse_binds, v, to); !added)
                return added;
        }
        return {};
    }

    /// White, where a primitive has none and others have.
    Result<void> read_colours(const tinygltf::Primitive& primitive, std::size_t vertices, SkinnedMesh& to) {
        const auto found = primitive.attributes.find("COLOR_0");
        if (found == primitive.attributes.end()) {
            if (!to.colours.empty()) to.colours.resize(to.mesh.positions.size() + vertices, Vec3{1, 1, 1});
            return {};
        }
        auto numbers = gltf_numbers(model_, found->second, 3);
        const std::size_t each = numbers.ok() ? 3 : 4;
        if (!numbers) numbers = gltf_numbers(model_, found->second, 4);
        if (!numbers) return numbers.error();
        if (numbers->size() != each * vertices)
            return Error{ErrorCode::malformed_file, std::to_string(numbers->size() / each) + " colours for " +
                                                        std::to_string(vertices) + " positions"};
        to.colours.resize(to.mesh.positions.size(), Vec3{1, 1, 1});
        for (std::size_t i = 0; i < numbers->size(); i += each)
            to.colours.push_back({static_cast<float>((*numbers)[i]), static_cast<float>((*numbers)[i + 1]),
                                  static_cast<float>((*numbers)[i + 2])});
        return {};
    }

    /// Where the skin has it while the nodes are at rest.
    Result<void> add_vertex(const std::vector<double>& positions, const std::vector<double>& joints,
                            const std::vector<double>& weights, const std::vector<double>& inverse_binds,
                            std::size_t vertex, SkinnedMesh& to) {
        const Vector3 bound(static_cast<float>(positions[3 * vertex]),
                            static_cast<float>(positions[3 * vertex + 1]),
                            static_cast<float>(positions[3 * vertex + 2]));
        Vector3 place = Vector3::Zero();
        float sum = 0;
        for (std::size_t k = 4 * vertex; k < 4 * vertex + 4; ++k) {
            const auto weight = static_cast<float>(weights[k]);
            if (!(joints[k] < static_cast<double>(skin().joints.size())))
                return Error{ErrorCode::malformed_file,
                             "vertex " + std::to_string(vertex) + " hangs on joint " +
                                 std::to_string(static_cast<int>(joints[k])) + "; the skin has " +
                                 std::to_string(skin().joints.size())};
            const auto joint = static_cast<std::size_t>(joints[k]);
            const int node = skin().joints[joint];
            Eigen::Matrix4f inverse = Eigen::Matrix4f::Identity();
            for (std::size_t i = 0; i < 16 && 16 * joint + 15 < inverse_binds.size(); ++i)
                inverse(static_cast<int>(i % 4), static_cast<int>(i / 4)) =
                    static_cast<float>(inverse_binds[16 * joint + i]);
            place += weight * (at_rest_[static_cast<std::size_t>(node)] * (Affine(inverse) * bound));
            sum += weight;
            to.joints.push_back(static_cast<std::uint32_t>(joint_of_node_[node]));
            to.weights.push_back(weight);
        }
        to.mesh.positions.push_back(to_vec3(sum > 0 ? Vector3(place / sum) : bound));
        return {};
    }

    tinygltf::Model model_;
    bool with_body_;
    SkinnedMesh garment_;
    std::vector<int> parents_, nodes_;  // nodes_: of the skeleton's joints
    std::map<int, std::size_t> joint_of_node_;
    std::vector<NodePlace> places_;
    std::vector<Affine> at_rest_;
    SkinnedCharacter character_;
};

}  // namespace

Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file, bool with_body) {
    auto model = load_gltf(file);
    if (!model) return model.error();
    GltfReader reader(std::move(*model), with_body);
    auto character = reader.read();
    if (!character) return Error{character.error().code, file.string() + ": " + character.error().message};
    Garment& garment = character->garment;
    if (auto maps = read_maps(file, garment.mesh.positions.size(), reader.colours(), garment); !maps)
        return maps.error();
    return character;
}

}  // namespace weft::demo
