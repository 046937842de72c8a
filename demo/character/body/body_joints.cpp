#include "demo/character/body/body_joints.h"

#include <cmath>
#include <span>

namespace weft::demo {
namespace {

using Names = std::array<const char*, 5>;  // the likeliest first; null: no more

constexpr std::array<Names, 11> names_of_parts{{
    {"hips", "pelvis", "hip", "root"},
    {"thorax", "chest", "spine2", "spine1", "spine"},
    {"lowerneck", "neck", "neck1"},
    {"head"},
    {"humerus", "arm", "shoulder", "upperarm"},
    {"radius", "forearm", "elbow", "lowerarm"},
    {"wrist", "hand"},
    {"femur", "upleg", "thigh", "hip", "upperleg"},
    {"tibia", "leg", "shin", "knee", "lowerleg"},
    {"foot", "ankle"},
    {"toes", "toebase", "toe"},
}};
constexpr std::size_t middle_parts = 4;

std::vector<std::string> names_of(Part part) {
    auto index = static_cast<std::size_t>(part);
    const std::size_t side_parts = names_of_parts.size() - middle_parts;
    std::string side;
    if (index >= middle_parts) {
        side = index < names_of_parts.size() ? "left" : "right";
        if (index >= names_of_parts.size()) index -= side_parts;
    }
    std::vector<std::string> names;
    for (const char* name : names_of_parts[index]) {
        if (name == nullptr) continue;
        if (!side.empty()) names.push_back(side.substr(0, 1) + name);
        names.push_back(side + name);
    }
    return names;
}

/// The ancestor of the chest, up to the hips, whose place at rest is nearest to half way between them.
std::size_t find_spine(const Skeleton& skeleton, const Pose& rest, std::size_t hips, std::size_t chest) {
    const Vector3 middle = 0.5f * (rest.positions[hips] + rest.positions[chest]);
    std::size_t nearest = chest;
    for (auto j = static_cast<int>(chest); j >= 0 && static_cast<std::size_t>(j) != hips;
         j = skeleton.joints[static_cast<std::size_t>(j)].parent) {
        const auto joint = static_cast<std::size_t>(j);
        if ((rest.positions[joint] - middle).norm() < (rest.positions[nearest] - middle).norm())
            nearest = joint;
    }
    return nearest;
}

}  // namespace

Result<BodyJoints> find_body_joints(const Skeleton& skeleton) {
    BodyJoints joints;
    std::string missing;
    for (std::size_t part = 0; part < joints.of_part.size(); ++part) {
        const std::vector<std::string> names = names_of(static_cast<Part>(part));
        bool found = false;
        for (const std::string& name : names) {
            const auto joint = skeleton.find(name);
            if (!joint) continue;
            joints.of_part[part] = *joint;
            found = true;
            break;
        }
        const bool is_toes = part == static_cast<std::size_t>(Part::left_toes) ||
                             part == static_cast<std::size_t>(Part::right_toes);
        if (is_toes && !found) joints.of_part[part] = joints.of_part[part - 1];  // the foot
        if (is_toes || found) continue;
        missing += missing.empty() ? "" : "; ";
        for (const std::string& name : names) missing += (&name == &names.front() ? "" : " or ") + name;
    }
    if (!missing.empty())
        return Error{ErrorCode::malformed_file, "the skeleton has no joint named " + missing};
    Pose rest;
    place_joints(skeleton, JointAngles::at_rest(skeleton), rest);
    joints.spine = find_spine(skeleton, rest, joints[Part::hips], joints[Part::chest]);
    return joints;
}

}  // namespace weft::demo
