#include "demo/character/garment/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "demo/character/garment/painted_maps.h"
#include "weft/gltf.h"

namespace weft::demo {

namespace {

constexpr double frame_rate = 60, longest_animation = 600;  // [Hz], [s]
/// Limit on frames times nodes and on frames times tracks: half a gigabyte of poses, made in a second or two.
constexpr std::size_t most_poses = std::size_t{1} << 25;

/// Decoded pictures and materials of parts, one SurfaceParts' part each.
class SurfaceReader {
  public:
    /// `notes` gets what cannot be shown. Both must outlive this.
    SurfaceReader(const GltfAsset& asset, std::vector<std::string>& notes)
        : asset_(asset), notes_(notes), pictures_(asset.pictures().size()) {}

    void append(const GltfPart& part, const Vec3& default_colour, SurfaceParts& to) {
        const auto picture = part.picture ? picture_of(*part.picture) : nullptr;
        const auto number = static_cast<std::uint32_t>(to.parts.size());
        to.parts.push_back(part_of(part.colour, default_colour, picture));
        to.of_triangle.insert(to.of_triangle.end(), part.mesh.triangles.size(), number);
    }

  private:
    using Shown = std::shared_ptr<const render::Image>;
    Shown picture_of(std::size_t index) {
        if (pictures_[index]) return *pictures_[index];
        const GltfPicture& from = asset_.pictures()[index];
        auto decoded = decode_picture(from.bytes, "picture " + std::to_string(index) + " " + from.name);
        if (!decoded) notes_.push_back(decoded.error().message);
        pictures_[index] = decoded ? *std::move(decoded) : Shown();
        return *pictures_[index];
    }

    const GltfAsset& asset_;
    std::vector<std::string>& notes_;
    std::vector<std::optional<Shown>> pictures_;  // none: not decoded yet
};

/// glTF's texture coordinates run downwards.
void turn_up(std::vector<Vec2>& texcoords) {
    for (Vec2& each : texcoords) each.y = 1 - each.y;
}

class GltfReader {
  public:
    GltfReader(GltfAsset asset, bool with_body) : asset_(std::move(asset)), with_body_(with_body) {}

    Result<SkinnedCharacter> read() {
        if (asset_.joints().empty())
            return Error{ErrorCode::malformed_file, "there is no skin with joints; a character needs one"};
        make_skeleton();
        if (auto motion = read_motion(); !motion) return motion.error();
        if (auto mesh = read_meshes(); !mesh) return mesh.error();
        turn_up(character_.worn.mesh.texcoords);
        character_.garment.mesh = character_.worn.mesh;
        return std::move(character_);
    }

  private:
    static Quaternion rotation_of(const GltfMatrix& columns) {
        Matrix3 axes = Eigen::Map<const Eigen::Matrix4f>(columns.data()).block<3, 3>(0, 0);
        for (int i = 0; i < 3; ++i) axes.col(i).stableNormalize();
        return Quaternion(axes).normalized();
    }

    /// Makes joints of the file's, parents first; what hangs on none hangs on the first. All rotations are
    /// the identity at rest.
    void make_skeleton() {
        Skeleton& skeleton = character_.recording.skeleton;
        for (const GltfJoint& joint : asset_.joints()) {
            const bool is_root = skeleton.joints.empty();
            const int parent = is_root ? -1 : std::max(joint.parent, 0);
            const Vector3 offset =
                to_vector(joint.rest) -
                to_vector(asset_.joints()[static_cast<std::size_t>(std::max(parent, 0))].rest);
            skeleton.joints.push_back({joint.name, parent, is_root ? Vector3(Vector3::Zero()) : offset});
        }
        character_.rest = JointAngles::at_rest(skeleton);
        character_.rest.root = to_vector(asset_.joints().front().rest);
    }

    Result<void> read_motion() {
        Recording& recording = character_.recording;
        recording.frame_time = 1 / frame_rate;
        const auto frames = static_cast<std::size_t>(
                                std::floor(std::min(asset_.duration(), longest_animation) * frame_rate)) +
                            1;
        if (asset_.pose_size() > most_poses / frames)
            return Error{ErrorCode::malformed_file, "the animation has " + std::to_string(frames) +
                                                        " frames of " + std::to_string(asset_.pose_size()) +
                                                        " nodes or channels; their product may be at most " +
                                                        std::to_string(most_poses)};
        std::vector<GltfMatrix> joints(asset_.joints().size());
        for (std::size_t f = 0; f < frames; ++f) {
            if (auto posed = asset_.pose(static_cast<double>(f) / frame_rate, joints); !posed)
                return Error{posed.error().code,
                             "in frame " + std::to_string(f) + ", " + posed.error().message};
            recording.frames.push_back(angles_of(joints));
        }
        return {};
    }

    [[nodiscard]] JointAngles angles_of(const std::vector<GltfMatrix>& joints) const {
        JointAngles angles = character_.rest;
        std::vector<Quaternion> turned;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            turned.push_back(rotation_of(joints[j]));
            const int parent = character_.recording.skeleton.joints[j].parent;
            angles.rotations[j] =
                parent < 0 ? turned[j]
                           : Quaternion(turned[static_cast<std::size_t>(parent)].conjugate() * turned[j]);
        }
        const Eigen::Affine3f root(Eigen::Map<const Eigen::Matrix4f>(joints.front().data()));
        angles.root = root * character_.rest.root;
        return angles;
    }

    /// A part with a skin. Worn: it is of the garment, not of the body.
    struct SkinPart {
        const GltfPart& from;
        bool free, worn;
    };

    static bool is_free(const std::string& material) { return material.ends_with("Free"); }
    static bool is_fixed(const std::string& material) { return material.starts_with("Garment"); }

    [[nodiscard]] std::vector<SkinPart> skin_parts() const {
        std::vector<SkinPart> parts;
        for (const GltfPart& part : asset_.parts()) {
            if (part.influences == 0) continue;
            const bool free = is_free(part.material);
            parts.push_back({part, free, free || is_fixed(part.material)});
        }
        mark_joined(parts);
        return parts;
    }

    /// The places of vertices, for finding what is joined.
    class Places {
      public:
        void add(std::span<const Vec3> positions) {
            for (const Vec3& p : positions) places_.insert({p.x, p.y, p.z});
        }
        [[nodiscard]] bool touch(std::span<const Vec3> positions) const {
            return std::ranges::any_of(positions, [&](const Vec3& p) {
                return places_.contains({p.x, p.y, p.z});
            });
        }

      private:
        std::set<std::array<float, 3>> places_;
    };

    /// A piece that shares a vertex's place with worn cloth is worn, too.
    static void mark_joined(std::vector<SkinPart>& parts) {
        Places seams;
        std::vector<bool> added(parts.size());
        for (bool any = true; std::exchange(any, false);)
            for (std::size_t k = 0; k < parts.size(); ++k) {
                SkinPart& part = parts[k];
                part.worn = part.worn || seams.touch(part.from.bound);
                if (!part.worn || added[k]) continue;
                seams.add(part.from.bound);
                any = added[k] = true;
            }
    }

    /// Notes faulty primitives of the body. Error: a faulty one that is worn, by its material or by a vertex
    /// that it shares, or that is of a body to be met.
    Result<void> note_left_out(const std::vector<SkinPart>& parts) {
        if (asset_.left_out().empty()) return {};
        Places seams;
        for (const SkinPart& part : parts)
            if (part.worn) seams.add(part.from.bound);
        for (const GltfLeftOut& each : asset_.left_out()) {
            const bool worn =
                is_free(each.material) || is_fixed(each.material) || seams.touch(each.positions);
            if (worn || with_body_) return each.fault;
            character_.garment.notes.push_back(each.fault.message + "; it is left out, as of the body");
        }
        return {};
    }

    Result<void> read_meshes() {
        Garment& garment = character_.garment;
        garment.stands_ready = true;
        bool any_free = false;
        SurfaceReader surface(asset_, garment.notes);
        const std::vector<SkinPart> parts = skin_parts();
        if (auto noted = note_left_out(parts); !noted) return noted;
        for (const SkinPart& part : parts)
            character_.worn.influences = std::max(character_.worn.influences, part.from.influences);
        character_.body.influences = character_.worn.influences;
        for (const auto& [part, free, worn] : parts) {
            if (!worn && !with_body_) {
                garment.notes.push_back(
                    "material " + part.material +
                    " touches no cloth that ends in \"Free\": it is left out, as of the body");
                continue;
            }
            if (free && !any_free) garment.colour = part.colour.value_or(garment.colour);
            any_free = any_free || free;
            const std::size_t first = character_.worn.mesh.positions.size();
            append(part, worn ? character_.worn : character_.body);
            if (worn) surface.append(part, garment.colour, garment.surface);
            for (std::size_t v = first; !free && v < character_.worn.mesh.positions.size(); ++v)
                garment.fixed.push_back(static_cast<std::uint32_t>(v));
        }
        if (!any_free)
            return Error{ErrorCode::invalid_mesh,
                         "no primitive of a mesh with a skin has a material that ends in \"Free\"; name so "
                         "what is simulated"};
        if (with_body_ && character_.body.mesh.triangles.empty())
            return Error{ErrorCode::invalid_mesh,
                         "the skins have no triangles but the garment's; a body to be met needs some"};
        return {};
    }

    /// Appends a part. Vertices without colours are white where others have some.
    static void append(const GltfPart& part, SkinnedMesh& to) {
        const auto first = static_cast<std::uint32_t>(to.mesh.positions.size());
        const std::size_t vertices = part.mesh.positions.size();
        to.mesh.positions.insert(to.mesh.positions.end(), part.mesh.positions.begin(),
                                 part.mesh.positions.end());
        for (const auto& [a, b, c] : part.mesh.triangles)
            to.mesh.triangles.push_back({first + a, first + b, first + c});
        if (!to.mesh.texcoords.empty() || !part.mesh.texcoords.empty()) {  // 0 where others have some
            to.mesh.texcoords.resize(first);
            to.mesh.texcoords.insert(to.mesh.texcoords.end(), part.mesh.texcoords.begin(),
                                     part.mesh.texcoords.end());
            to.mesh.texcoords.resize(first + vertices);
        }
        to.joints.resize(to.influences * (first + vertices));
        to.weights.resize(to.joints.size());
        for (std::size_t i = 0; i < part.joints.size(); ++i) {
            const std::size_t at = to.influences * (first + i / part.influences) + i % part.influences;
            to.joints[at] = part.joints[i];
            to.weights[at] = part.weights[i];
        }
        if (to.colours.empty() && part.colours.empty()) return;
        to.colours.resize(first, Vec3{1, 1, 1});
        to.colours.insert(to.colours.end(), part.colours.begin(), part.colours.end());
        to.colours.resize(first + vertices, Vec3{1, 1, 1});
    }

    GltfAsset asset_;
    bool with_body_;
    SkinnedCharacter character_;
};

}  // namespace

Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file, bool with_body) {
    auto asset = GltfAsset::load(file);
    if (!asset) return asset.error();
    auto character = GltfReader(*std::move(asset), with_body).read();
    if (!character) return Error{character.error().code, file.string() + ": " + character.error().message};
    Garment& garment = character->garment;
    if (auto maps = read_maps(file, garment.mesh.positions.size(), character->worn.colours, garment); !maps)
        return maps.error();
    return character;
}

bool is_gltf(const std::filesystem::path& file) {
    return file.extension() == ".gltf" || file.extension() == ".glb";
}

bool has_skin(const std::filesystem::path& file) {
    const auto asset = GltfAsset::load(file);
    return asset && !asset->joints().empty();
}

Result<Mesh> read_gltf_mesh(const std::filesystem::path& file, GltfSurface* surface) {
    const auto asset = GltfAsset::load(file);
    if (!asset) return asset.error();
    if (!asset->left_out().empty()) {  // all of the file is the garment
        const Error& fault = asset->left_out().front().fault;
        return Error{fault.code, file.string() + ": " + fault.message};
    }
    Mesh mesh = asset->mesh();
    turn_up(mesh.texcoords);
    if (surface != nullptr) {
        SurfaceReader reader(*asset, surface->notes);
        for (const GltfPart& part : asset->parts()) reader.append(part, Garment().colour, surface->parts);
    }
    if (!mesh.triangles.empty()) return mesh;
    return Error{ErrorCode::invalid_mesh,
                 file.string() + ": no node has a mesh of triangles; cloth needs some"};
}

}  // namespace weft::demo
