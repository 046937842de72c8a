#include "demo/character/garment/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "demo/character/garment/gltf_data.h"
#include "demo/character/garment/painted_maps.h"

namespace weft::demo {
namespace {

constexpr double frame_rate = 60, longest_animation = 600;  // [Hz], [s]
/// Limit on frames times nodes and on frames times tracks: half a gigabyte of poses, made in a second or two.
constexpr std::size_t most_poses = std::size_t{1} << 25;

class GltfReader {
  public:
    GltfReader(GltfModel model, bool with_body) : model_(std::move(model)), with_body_(with_body) {}

    Result<SkinnedCharacter> read() {
        if (model_.skins.empty() || model_.skins.front().joints.empty())
            return Error{ErrorCode::malformed_file, "there is no skin with joints; a character needs one"};
        if (auto placed = place_nodes(); !placed) return placed.error();
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

    Result<void> place_nodes() {
        places_ = gltf_places(model_);
        auto globals = gltf_globals(model_, places_);
        if (!globals) return globals.error();
        at_rest_ = *std::move(globals);
        return {};
    }

    [[nodiscard]] const GltfSkin& skin() const { return model_.skins.front(); }
    static Quaternion rotation_of(const Affine& global) {
        Matrix3 axes = global.linear();
        for (int i = 0; i < 3; ++i) axes.col(i).stableNormalize();
        return Quaternion(axes).normalized();
    }

    /// Makes joints of the skin's nodes, parents first. All rotations are the identity at rest.
    void make_skeleton() {
        const std::set<std::size_t> joints(skin().joints.begin(), skin().joints.end());
        std::map<std::size_t, std::size_t> nearest_joint;  // of each node: itself, or an ancestor
        Skeleton& skeleton = character_.recording.skeleton;
        for (const std::size_t node : model_.parents_first) {
            const auto parent = model_.nodes[node].parent;
            const auto above = parent ? nearest_joint.find(*parent) : nearest_joint.end();
            const std::size_t over = above == nearest_joint.end() ? 0 : above->second;
            if (joints.contains(node)) {
                const bool is_root = nodes_.empty();
                nodes_.push_back(node);
                const Vector3 offset = at_rest_[node].translation() - at_rest_[nodes_[over]].translation();
                skeleton.joints.push_back({model_.nodes[node].name, is_root ? -1 : static_cast<int>(over),
                                           is_root ? Vector3(Vector3::Zero()) : offset});
                nearest_joint[node] = joint_of_node_[node] = nodes_.size() - 1;
            } else if (above != nearest_joint.end()) {
                nearest_joint[node] = over;
            }
        }
        character_.rest = JointAngles::at_rest(skeleton);
        character_.rest.root = at_rest_[nodes_.front()].translation();
    }

    Result<void> read_motion() {
        const auto animation = GltfAnimation::create(model_);
        if (!animation) return animation.error();
        Recording& recording = character_.recording;
        recording.frame_time = 1 / frame_rate;
        const auto frames = static_cast<std::size_t>(
                                std::floor(std::min(animation->duration(), longest_animation) * frame_rate)) +
                            1;
        const std::size_t each = std::max(model_.nodes.size(), model_.animation.size());
        if (each > most_poses / frames)
            return Error{ErrorCode::malformed_file, "the animation has " + std::to_string(frames) +
                                                        " frames of " + std::to_string(each) +
                                                        " nodes or channels; their product may be at most " +
                                                        std::to_string(most_poses)};
        for (std::size_t f = 0; f < frames; ++f) {
            std::vector<NodePlace> places = places_;
            animation->pose(static_cast<double>(f) / frame_rate, places);
            const auto globals = gltf_globals(model_, places);
            if (!globals)
                return Error{globals.error().code,
                             "in frame " + std::to_string(f) + ", " + globals.error().message};
            recording.frames.push_back(angles_of(*globals));
        }
        return {};
    }

    [[nodiscard]] JointAngles angles_of(const std::vector<Affine>& globals) const {
        JointAngles angles = character_.rest;
        std::vector<Quaternion> turned;
        for (std::size_t j = 0; j < nodes_.size(); ++j) {
            const std::size_t node = nodes_[j];
            turned.push_back(rotation_of(globals[node]) * rotation_of(at_rest_[node]).conjugate());
            const int parent = character_.recording.skeleton.joints[j].parent;
            angles.rotations[j] =
                parent < 0 ? turned[j]
                           : Quaternion(turned[static_cast<std::size_t>(parent)].conjugate() * turned[j]);
        }
        angles.root = globals[nodes_.front()].translation();
        return angles;
    }

    /// A primitive of the skin. Worn: it is of the garment, not of the body.
    struct SkinPart {
        const GltfPrimitive& primitive;
        GltfMaterial material;
        bool free, worn;
        std::vector<double> places;  // of its vertices, three numbers each
    };

    [[nodiscard]] std::vector<SkinPart> skin_parts() const {
        std::vector<SkinPart> parts;
        for (const GltfNode& node : model_.nodes) {
            if (node.skin != std::size_t{0} || !node.mesh) continue;
            for (const GltfPrimitive& primitive : model_.meshes[*node.mesh]) {
                SkinPart part{primitive,
                              primitive.material ? model_.materials[*primitive.material] : GltfMaterial(),
                              false,
                              false,
                              {}};
                part.free = part.material.name.ends_with("Free");
                part.worn = part.free || part.material.name.starts_with("Garment");
                if (const auto found = primitive.attribute("POSITION"))
                    if (auto places = gltf_numbers(model_, *found, 3)) part.places = std::move(*places);
                parts.push_back(std::move(part));
            }
        }
        mark_joined(parts);
        return parts;
    }

    /// What shares a vertex's place with something worn is worn.
    static void mark_joined(std::vector<SkinPart>& parts) {
        std::set<std::array<double, 3>> seams;
        std::vector<bool> added(parts.size());
        for (bool any = true; std::exchange(any, false);)
            for (std::size_t k = 0; k < parts.size(); ++k) {
                SkinPart& part = parts[k];
                const auto place = [&](std::size_t v) {
                    return std::array{part.places[v], part.places[v + 1], part.places[v + 2]};
                };
                for (std::size_t v = 0; !part.worn && v < part.places.size(); v += 3)
                    part.worn = seams.contains(place(v));
                if (!part.worn || added[k]) continue;
                for (std::size_t v = 0; v < part.places.size(); v += 3) seams.insert(place(v));
                any = added[k] = true;
            }
    }

    Result<void> read_meshes() {
        Garment& garment = character_.garment;
        garment.stands_ready = true;
        bool any_free = false;
        for (const auto& [primitive, material, free, worn, places] : skin_parts()) {
            if (!worn && !with_body_) {
                garment.notes.push_back(
                    "material " + material.name +
                    " touches no cloth that ends in \"Free\": it is left out, as of the body");
                continue;
            }
            if (free && !any_free) garment.colour = material.colour.value_or(garment.colour);
            any_free = any_free || free;
            if (auto read = read_primitive(primitive, material.name, free, worn ? garment_ : character_.body);
                !read)
                return read;
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

    Result<std::size_t> attribute(const GltfPrimitive& primitive, const char* name,
                                  const std::string& of) const {
        if (const auto found = primitive.attribute(name)) return *found;
        return Error{ErrorCode::malformed_file, "the primitive of material " + of + " has no " + name};
    }

    Result<void> read_primitive(const GltfPrimitive& primitive, const std::string& name, bool free,
                                SkinnedMesh& to) {
        const auto of_positions = attribute(primitive, "POSITION", name);
        if (!of_positions) return of_positions.error();
        const auto of_joints = attribute(primitive, "JOINTS_0", name);
        if (!of_joints) return of_joints.error();
        const auto of_weights = attribute(primitive, "WEIGHTS_0", name);
        if (!of_weights) return of_weights.error();
        const auto bound = gltf_numbers(model_, *of_positions, 3);
        if (!bound) return bound.error();
        const auto joints = gltf_indices(model_, *of_joints, 4, skin().joints.size());
        if (!joints) return Error{joints.error().code, "joints of the skin: " + joints.error().message};
        const auto weights = gltf_numbers(model_, *of_weights, 4);
        if (!weights) return weights.error();
        const std::size_t vertices = bound->size() / 3;
        if (joints->size() != 4 * vertices || weights->size() != 4 * vertices)
            return Error{ErrorCode::malformed_file,
                         "the primitive of material " + name + " has " + std::to_string(weights->size() / 4) +
                             " weights and " + std::to_string(joints->size() / 4) + " joints for " +
                             std::to_string(vertices) + " positions"};
        const auto triangles = gltf_triangles(model_, primitive, vertices, name);
        if (!triangles) return triangles.error();
        if (auto colours = read_colours(primitive, vertices, to); !colours) return colours;
        const auto positions = rest_positions(*bound, *joints, *weights, name);
        if (!positions) return positions.error();
        const std::size_t first = to.mesh.positions.size();
        if (auto added = add_part(*positions, *triangles, to.mesh); !added)
            return Error{added.error().code,
                         "the primitive of material " + name + ": " + added.error().message};
        for (const std::uint32_t joint : *joints)
            to.joints.push_back(static_cast<std::uint32_t>(joint_of_node_[skin().joints[joint]]));
        for (const double weight : *weights) to.weights.push_back(static_cast<float>(weight));
        if (free || &to != &garment_) return {};
        for (std::size_t v = first; v < to.mesh.positions.size(); ++v)
            character_.garment.fixed.push_back(static_cast<std::uint32_t>(v));
        return {};
    }

    /// Appends a primitive's vertex colours; white where it has none and others have.
    Result<void> read_colours(const GltfPrimitive& primitive, std::size_t vertices, SkinnedMesh& to) {
        const auto found = primitive.attribute("COLOR_0");
        if (!found) {
            if (!to.colours.empty()) to.colours.resize(to.mesh.positions.size() + vertices, Vec3{1, 1, 1});
            return {};
        }
        const std::size_t each = model_.accessors[*found].components == 3 ? 3 : 4;
        const auto numbers = gltf_numbers(model_, *found, each);
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

    /// Transforms from the axes in which vertices are bound to the World's, for each joint of the skin, in
    /// the rest pose.
    Result<std::vector<Affine>> rest_transforms() const {
        std::vector<Affine> transforms;
        for (const std::size_t node : skin().joints) transforms.push_back(at_rest_[node]);
        if (!skin().inverse_binds) return transforms;
        const auto numbers = gltf_numbers(model_, *skin().inverse_binds, 16);
        if (!numbers) return numbers.error();
        for (std::size_t j = 0; j < transforms.size(); ++j) {
            Affine inverse;
            inverse.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers->data() + 16 * j).cast<float>();
            transforms[j] = transforms[j] * inverse;
        }
        return transforms;
    }

    /// Skinned positions of vertices in the rest pose.
    Result<std::vector<Vec3>> rest_positions(const std::vector<double>& bound,
                                             const std::vector<std::uint32_t>& joints,
                                             const std::vector<double>& weights,
                                             const std::string& name) const {
        const auto transforms = rest_transforms();
        if (!transforms) return transforms.error();
        std::vector<Vec3> positions;
        for (std::size_t v = 0; v < bound.size() / 3; ++v) {
            const Vector3 from = Eigen::Map<const Eigen::Vector3d>(bound.data() + 3 * v).cast<float>();
            const auto refused = [&](const std::string& what) {
                return Error{ErrorCode::malformed_file,
                             "vertex " + std::to_string(v) + " of material " + name + " " + what};
            };
            Vector3 place = Vector3::Zero();
            float sum = 0;
            for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
                const auto weight = static_cast<float>(weights[k]);
                if (!(weight >= 0 && weight <= 1e6f))
                    return refused("has a weight of " + std::to_string(weight) + "; it must be from 0 to 1");
                if (weight > 0) place += weight * ((*transforms)[joints[k]] * from);
                sum += weight;
            }
            positions.push_back(to_vec3(sum > 0 ? Vector3(place / sum) : from));
        }
        return positions;
    }

    GltfModel model_;
    bool with_body_;
    SkinnedMesh garment_;
    std::vector<std::size_t> nodes_;  // node of each joint of the skeleton
    std::map<std::size_t, std::size_t> joint_of_node_;
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
