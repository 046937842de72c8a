#include <algorithm>
#include <limits>

#include "cloth/mesh/mesh_limits.h"
#include "demo/gltf/gltf_buffers.h"
#include "demo/gltf/gltf_data.h"
#include "demo/gltf/gltf_fields.h"
#include "weft/gltf.h"

namespace weft {
namespace {

using Affine = Eigen::Affine3f;

constexpr std::size_t most_sets = 4;  // of four influences each

Vector3 point_at(const std::vector<double>& numbers, std::size_t v) {
    return Eigen::Map<const Eigen::Vector3d>(numbers.data() + 3 * v).cast<float>();
}

}  // namespace

struct GltfAsset::Motion {
    GltfModel model;  // without its buffers
    GltfAnimation animation;
    std::vector<std::size_t> nodes;  // of each joint
    std::vector<Affine> from_rest;   // of each joint: from the World's axes to its own, in the rest pose
    std::vector<Vector3> rest;       // of each joint
};

class GltfAssetReader {
  public:
    explicit GltfAssetReader(GltfModel model) : model_(std::move(model)) {}

    Result<GltfAsset> read() {
        auto globals = gltf_globals(model_, gltf_places(model_));
        if (!globals) return globals.error();
        at_rest_ = *std::move(globals);
        auto animation = GltfAnimation::create(model_);
        if (!animation) return animation.error();
        list_joints();
        for (const GltfSkin& skin : model_.skins)
            if (auto read = read_skin(skin); !read) return read.error();
        for (std::size_t n = 0; n < model_.nodes.size(); ++n)
            if (auto read = read_node(n); !read) return read.error();
        if (asset_.parts_.empty() && !asset_.left_out_.empty()) return asset_.left_out_.front().fault;
        asset_.pictures_ = std::move(model_.pictures);
        motion_.animation = *std::move(animation);
        model_.buffers.clear();
        motion_.model = std::move(model_);
        asset_.motion_ = std::make_shared<const GltfAsset::Motion>(std::move(motion_));
        return std::move(asset_);
    }

  private:
    static constexpr auto no_joint = std::numeric_limits<std::uint32_t>::max();

    /// Lists the joints of all skins, parents first.
    void list_joints() {
        std::vector<bool> is_joint(model_.nodes.size());
        for (const GltfSkin& skin : model_.skins)
            for (const std::size_t node : skin.joints) is_joint[node] = true;
        std::vector<std::uint32_t> nearest(model_.nodes.size(), no_joint);  // the node itself, or an ancestor
        for (const std::size_t node : model_.parents_first) {
            const auto& parent = model_.nodes[node].parent;
            const std::uint32_t above = parent ? nearest[*parent] : no_joint;
            nearest[node] = above;
            if (!is_joint[node]) continue;
            nearest[node] = static_cast<std::uint32_t>(motion_.nodes.size());
            const Vector3 rest = at_rest_[node].translation();
            asset_.joints_.push_back({model_.nodes[node].name,
                                      above == no_joint ? -1 : static_cast<std::int32_t>(above),
                                      to_vec3(rest)});
            motion_.nodes.push_back(node);
            motion_.rest.push_back(rest);
            motion_.from_rest.push_back(at_rest_[node].inverse());
        }
        joint_of_node_ = std::move(nearest);
    }

    /// Finds, for each joint of a skin, the transform from bound vertices to the rest pose.
    Result<void> read_skin(const GltfSkin& skin) {
        std::vector<Affine>& transforms = binds_.emplace_back();
        for (const std::size_t node : skin.joints) transforms.push_back(at_rest_[node]);
        if (!skin.inverse_binds) return {};
        const auto numbers = gltf_numbers(model_, *skin.inverse_binds, 16);
        if (!numbers) return numbers.error();
        for (std::size_t j = 0; j < transforms.size(); ++j) {
            Affine inverse;
            inverse.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers->data() + 16 * j).cast<float>();
            transforms[j] = transforms[j] * inverse;
        }
        return {};
    }

    Result<void> read_node(std::size_t n) {
        const GltfNode& node = model_.nodes[n];
        if (!node.mesh) return {};
        const std::vector<GltfPrimitive>& primitives = model_.meshes[*node.mesh];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            if (!primitives[p].triangles) continue;  // lines and points are no cloth
            auto part = read_part(primitives[p], n);
            // Faulty primitives count as well: a small file may name one a million times.
            const auto counted =
                part ? count_part(part->mesh.positions.size(), part->mesh.triangles.size(), size_)
                     : count_part(1 + longest_accessor(primitives[p]), 0, size_);
            if (!counted) return at_primitive(n, p, counted.error());
            if (part)
                asset_.parts_.push_back(*std::move(part));
            else
                leave_out(n, p, part.error());
        }
        return {};
    }

    void leave_out(std::size_t n, std::size_t p, const Error& fault) {
        const std::size_t mesh = *model_.nodes[n].mesh;
        const GltfPrimitive& primitive = model_.meshes[mesh][p];
        asset_.left_out_.push_back({.mesh = mesh,
                                    .primitive = p,
                                    .node = n,
                                    .material = material_of(primitive),
                                    .fault = at_primitive(n, p, fault),
                                    .positions = finite_positions(model_, primitive)});
    }

    [[nodiscard]] Error at_primitive(std::size_t n, std::size_t p, const Error& error) const {
        const std::size_t mesh = *model_.nodes[n].mesh;
        const std::string material = material_of(model_.meshes[mesh][p]);
        return {error.code, "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(p) +
                                "] at nodes[" + std::to_string(n) + "]" +
                                (material.empty() ? "" : ", of material " + material) + ": " + error.message};
    }

    [[nodiscard]] std::string material_of(const GltfPrimitive& primitive) const {
        return primitive.material ? model_.materials[*primitive.material].name : std::string();
    }

    [[nodiscard]] std::size_t longest_accessor(const GltfPrimitive& primitive) const {
        std::size_t longest = primitive.indices ? model_.accessors[*primitive.indices].count : 0;
        for (const auto& [name, accessor] : primitive.attributes)
            longest = std::max(longest, model_.accessors[accessor].count);
        return longest;
    }

    [[nodiscard]] Result<GltfPart> read_part(const GltfPrimitive& primitive, std::size_t n) const {
        if (primitive.fault) return *primitive.fault;
        GltfPart part;
        part.material = material_of(primitive);
        if (primitive.material) {
            part.colour = model_.materials[*primitive.material].colour;
            part.picture = model_.materials[*primitive.material].picture;
        }
        const auto of_positions = needed(primitive, "POSITION");
        if (!of_positions) return of_positions.error();
        const auto bound = gltf_numbers(model_, *of_positions, 3);
        if (!bound) return bound.error();
        const std::size_t vertices = bound->size() / 3;
        const auto triangles = gltf_triangles(model_, primitive, vertices);
        if (!triangles) return triangles.error();
        part.mesh.triangles = *triangles;
        std::vector<Vec3>& positions = part.mesh.positions;
        positions.resize(vertices);
        const auto& skin = model_.nodes[n].skin;
        if (skin) {
            if (auto read = read_influences(primitive, *skin, vertices, part); !read) return read.error();
            if (auto put = pose_by_skin(*bound, *skin, part, positions); !put) return put.error();
        } else {
            for (std::size_t v = 0; v < vertices; ++v)
                positions[v] = to_vec3(at_rest_[n] * point_at(*bound, v));
        }
        if (auto checked = check_places(positions); !checked) return checked.error();
        if (auto read = read_colours(primitive, vertices, part); !read) return read.error();
        if (auto read = read_texcoords(primitive, vertices, part.mesh); !read) return read.error();
        for (std::uint32_t& joint : part.joints) joint = joint_of_node_[model_.skins[*skin].joints[joint]];
        return part;
    }

    static Result<std::size_t> needed(const GltfPrimitive& primitive, const std::string& name) {
        if (const auto found = primitive.attribute(name)) return *found;
        return gltf_error("it has no " + name + "; it needs one");
    }

    /// Reads JOINTS_0 and WEIGHTS_0, and further sets of four as far as there are any.
    Result<void> read_influences(const GltfPrimitive& primitive, std::size_t skin, std::size_t vertices,
                                 GltfPart& part) const {
        std::size_t sets = 1;
        while (sets < most_sets && primitive.attribute("JOINTS_" + std::to_string(sets))) ++sets;
        part.influences = 4 * sets;
        for (std::size_t set = 0; set < sets; ++set) {
            const auto of_joints = needed(primitive, "JOINTS_" + std::to_string(set));
            if (!of_joints) return of_joints.error();
            const auto of_weights = needed(primitive, "WEIGHTS_" + std::to_string(set));
            if (!of_weights) return of_weights.error();
            const auto joints = gltf_indices(model_, *of_joints, 4, model_.skins[skin].joints.size());
            if (!joints) return Error{joints.error().code, "joints of the skin: " + joints.error().message};
            const auto weights = gltf_numbers(model_, *of_weights, 4);
            if (!weights) return weights.error();
            if (joints->size() != 4 * vertices || weights->size() != 4 * vertices)
                return gltf_error("it has " + std::to_string(weights->size() / 4) + " weights and " +
                                  std::to_string(joints->size() / 4) + " joints for " +
                                  std::to_string(vertices) + " positions; it needs as many");
            part.joints.resize(part.influences * vertices);
            part.weights.resize(part.joints.size());
            for (std::size_t i = 0; i < joints->size(); ++i) {
                const std::size_t to = i / 4 * part.influences + 4 * set + i % 4;
                part.joints[to] = (*joints)[i];
                part.weights[to] = static_cast<float>((*weights)[i]);
            }
        }
        return {};
    }

    /// Writes skinned positions of vertices in the rest pose, and makes each vertex's weights sum to 1.
    Result<void> pose_by_skin(const std::vector<double>& bound, std::size_t skin, GltfPart& part,
                              std::span<Vec3> positions) const {
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const Vector3 from = point_at(bound, v);
            const std::size_t first = part.influences * v;
            part.bound.push_back(to_vec3(from));
            Vector3 place = Vector3::Zero();
            float sum = 0;
            for (std::size_t k = first; k < first + part.influences; ++k) {
                const float weight = part.weights[k];
                if (!(weight >= 0 && weight <= 1e6f))
                    return gltf_error("vertex " + std::to_string(v) + " has a weight of " +
                                      std::to_string(weight) + "; it must be from 0 to 1");
                if (weight > 0) place += weight * (binds_[skin][part.joints[k]] * from);
                sum += weight;
            }
            positions[v] = to_vec3(sum > 0 ? Vector3(place / sum) : from);
            for (std::size_t k = first; sum > 0 && k < first + part.influences; ++k) part.weights[k] /= sum;
        }
        return {};
    }

    Result<void> read_colours(const GltfPrimitive& primitive, std::size_t vertices, GltfPart& part) const {
        const auto found = primitive.attribute("COLOR_0");
        if (!found) return {};
        const std::size_t each = model_.accessors[*found].components == 3 ? 3 : 4;
        const auto numbers = gltf_numbers(model_, *found, each);
        if (!numbers) return numbers.error();
        if (numbers->size() != each * vertices)
            return gltf_error("it has " + std::to_string(numbers->size() / each) + " colours for " +
                              std::to_string(vertices) + " positions; it needs as many or none");
        for (std::size_t i = 0; i < numbers->size(); i += each)
            part.colours.push_back({static_cast<float>((*numbers)[i]), static_cast<float>((*numbers)[i + 1]),
                                    static_cast<float>((*numbers)[i + 2])});
        return {};
    }

    Result<void> read_texcoords(const GltfPrimitive& primitive, std::size_t vertices, Mesh& mesh) const {
        const std::size_t set = primitive.material ? model_.materials[*primitive.material].texcoords : 0;
        const auto found = primitive.attribute("TEXCOORD_" + std::to_string(set));
        if (!found) return {};
        const auto numbers = gltf_numbers(model_, *found, 2);
        if (!numbers) return numbers.error();
        if (numbers->size() != 2 * vertices)
            return gltf_error("it has " + std::to_string(numbers->size() / 2) + " texture coordinates for " +
                              std::to_string(vertices) + " positions; it needs as many or none");
        for (std::size_t i = 0; i < numbers->size(); i += 2)
            mesh.texcoords.push_back(
                {static_cast<float>((*numbers)[i]), static_cast<float>((*numbers)[i + 1])});
        return {};
    }

    GltfModel model_;
    GltfAsset asset_;
    GltfAsset::Motion motion_;
    std::vector<Affine> at_rest_;               // of each node
    std::vector<std::uint32_t> joint_of_node_;  // or of its nearest ancestor that is a joint
    std::vector<std::vector<Affine>> binds_;    // of each skin's joints
    GltfSize size_;                             // of all parts, and of what was left out
};

Result<GltfAsset> GltfAsset::load(const std::filesystem::path& file) {
    auto model = read_gltf_model(file);
    if (!model) return model.error();
    auto asset = GltfAssetReader(*std::move(model)).read();
    if (!asset) return Error{asset.error().code, file.string() + ": " + asset.error().message};
    return asset;
}

bool GltfAsset::reads_draco() {
    return has_draco;
}

Mesh GltfAsset::mesh() const {
    Mesh all;
    const bool textured =
        std::ranges::none_of(parts_, [](const GltfPart& part) { return part.mesh.texcoords.empty(); });
    for (const GltfPart& part : parts_) {
        const Mesh& mesh = part.mesh;
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        if (textured) all.texcoords.insert(all.texcoords.end(), mesh.texcoords.begin(), mesh.texcoords.end());
        for (const auto& [a, b, c] : mesh.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

double GltfAsset::duration() const {
    return motion_ ? motion_->animation.duration() : 0;
}

std::size_t GltfAsset::pose_size() const {
    return motion_ ? std::max(motion_->model.nodes.size(), motion_->model.animation.size()) : 0;
}

Result<void> GltfAsset::pose(double time, std::span<GltfMatrix> joints) const {
    if (joints.size() != joints_.size())
        return Error{ErrorCode::invalid_argument, "there are " + std::to_string(joints.size()) +
                                                      " matrices; there must be one for each of " +
                                                      std::to_string(joints_.size()) + " joints"};
    if (joints.empty()) return {};
    std::vector<NodePlace> places = gltf_places(motion_->model);
    motion_->animation.pose(time, places);
    const auto globals = gltf_globals(motion_->model, places);
    if (!globals) return globals.error();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Affine& global = (*globals)[motion_->nodes[j]];
        Affine moved = global * motion_->from_rest[j];
        if (!moved.matrix().allFinite())  // a scale of 0 at rest has no inverse
            moved = Eigen::Translation3f(global.translation() - motion_->rest[j]);
        Eigen::Map<Eigen::Matrix4f>(joints[j].data()) = moved.matrix();
    }
    return {};
}

}  // namespace weft
