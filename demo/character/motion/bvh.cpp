#include "demo/character/motion/motion.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <utility>

#include "cloth/mesh/coordinates.h"
#include "demo/must.h"

namespace weft::demo {
namespace {

constexpr std::size_t most_joints = 1024, most_frames = 1'000'000;
/// Limit on frames times joints: half a gigabyte, which a short file of few channels could exceed.
constexpr std::size_t most_rotations = std::size_t{1} << 25;
constexpr float tallest = 10;  // [m]

/// The meaning of a number of a frame. Kind 0 to 2: the joint's position along x, y, z; 3 to 5: its rotation
/// about them.
struct Channel {
    std::size_t joint;
    int kind;
};

constexpr std::array<const char*, 6> channel_names{"Xposition", "Yposition", "Zposition",
                                                   "Xrotation", "Yrotation", "Zrotation"};

class BvhWords {
  public:
    BvhWords(std::ifstream& stream, std::string file) : stream_(stream), file_(std::move(file)) {}

    /// The next word; empty at the end of the file.
    const std::string& next() {
        word_.clear();
        int c = stream_.get();
        for (; c != EOF && std::isspace(c) != 0; c = stream_.get()) line_ += c == '\n';
        for (; c != EOF && std::isspace(c) == 0; c = stream_.get()) word_ += static_cast<char>(c);
        if (c != EOF) stream_.unget();
        return word_;
    }
    [[noreturn]] void refuse(const std::string& wanted) const {
        const std::string found = word_.empty() ? "the file ends" : "\"" + word_.substr(0, 40) + "\" stands";
        throw Refusal({ErrorCode::malformed_file, file_ + ":" + std::to_string(line_) + ": " + found +
                                                      " where " + wanted + " must stand"});
    }
    [[noreturn]] void refuse_length(const std::string& length) const {
        throw Refusal({ErrorCode::malformed_file, file_ + ": " + length + "; it must be at most " +
                                                      std::to_string(runaway_distance) + " m"});
    }
    void expect(const char* word) {
        if (next() != word) refuse(std::string("\"") + word + "\"");
    }
    [[nodiscard]] double number(const std::string& what) {
        next();
        double value = 0;
        const char* const end = word_.data() + word_.size();
        const auto [read, code] = std::from_chars(word_.data(), end, value);
        if (code != std::errc{} || read != end || !(std::abs(value) <= 1e9))
            refuse(what + ", a finite number,");
        return value;
    }
    [[nodiscard]] std::size_t count(const char* what, std::size_t least, std::size_t most) {
        const double value = number(what);
        if (value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
            value == std::floor(value))
            return static_cast<std::size_t>(value);
        refuse(std::string(what) + ", a whole number from " + std::to_string(least) + " to " +
               std::to_string(most) + ",");
    }
    [[nodiscard]] const std::string& word() const { return word_; }

  private:
    std::ifstream& stream_;
    std::string file_, word_;
    int line_ = 1;
};

Quaternion about_axis(int axis, double degrees) {
    const double half = degrees * std::numbers::pi / 360;
    Quaternion q(static_cast<float>(std::cos(half)), 0, 0, 0);
    q.vec()[axis] = static_cast<float>(std::sin(half));
    return q;
}

class BvhParser {
  public:
    explicit BvhParser(BvhWords words) : words_(std::move(words)) {}

    /// Throws Refusal.
    Recording parse() {
        words_.expect("HIERARCHY");
        words_.expect("ROOT");
        read_joint(-1, false);
        read_motion();
        shrink_from_centimetres();
        check_places();
        return std::move(recording_);
    }

  private:
    /// Reads a joint and its children, from the joint's name to its closing brace.
    void read_joint(int parent, bool is_end) {
        std::vector<Joint>& joints = recording_.skeleton.joints;
        if (joints.size() == most_joints)
            words_.refuse("the last of " + std::to_string(most_joints) + " joints");
        const auto self = static_cast<int>(joints.size());
        if (words_.next().empty()) words_.refuse("the joint's name");
        joints.push_back({is_end ? std::string() : words_.word(), parent, Vector3::Zero()});
        words_.expect("{");
        words_.expect("OFFSET");
        for (int axis = 0; axis < 3; ++axis) {
            joints.back().offset[axis] = static_cast<float>(words_.number("an offset"));
        }
        if (!is_end) {
            read_channels(static_cast<std::size_t>(self));
        }
        for (;;) {
            const std::string word = words_.next();
            if (word == "}") return;
            if (is_end || (word != "JOINT" && word != "End")) words_.refuse("\"JOINT\", \"End\" or \"}\"");
            read_joint(self, word == "End");
        }
    }

    void read_channels(std::size_t joint) {
        words_.expect("CHANNELS");
        const auto count = words_.count("the number of channels", 0, 6);
        for (std::size_t c = 0; c < count; ++c) {
            words_.next();
            int kind = 0;
            while (kind < 6 && words_.word() != channel_names[static_cast<std::size_t>(kind)]) ++kind;
            if (kind == 6) words_.refuse("a channel, Xposition to Zrotation,");
            channels_.push_back({joint, kind});
        }
    }

    void read_motion() {
        words_.expect("MOTION");
        words_.expect("Frames:");
        const auto frames = words_.count("the number of frames", 1, most_frames);
        if (const std::size_t joints = recording_.skeleton.size(); joints > most_rotations / frames)
            words_.refuse("at most " + std::to_string(most_rotations / joints) + " frames, for " +
                          std::to_string(joints) + " joints,");
        words_.expect("Frame");
        words_.expect("Time:");
        const auto time = words_.number("the time of a frame");
        if (!(time >= 1e-4 && time <= 10)) words_.refuse("the time of a frame, 0.0001 to 10 s,");
        recording_.frame_time = time;
        for (std::size_t frame = 0; frame < frames; ++frame) {
            read_frame(frame);
        }
    }

    void read_frame(std::size_t frame) {
        JointAngles angles = JointAngles::at_rest(recording_.skeleton);
        angles.root = recording_.skeleton.joints.front().offset;
        for (const Channel& channel : channels_) {
            const std::string& name = recording_.skeleton.joints[channel.joint].name;
            const auto value = words_.number("frame " + std::to_string(frame + 1) + "'s " +
                                             channel_names[static_cast<std::size_t>(channel.kind)] + " of " +
                                             name.substr(0, 40));
            if (channel.kind >= 3) {
                Quaternion& q = angles.rotations[channel.joint];
                q = (q * about_axis(channel.kind - 3, value)).normalized();
            } else if (channel.joint == 0) {
                angles.root[channel.kind] = static_cast<float>(value);
            }
        }
        recording_.frames.push_back(std::move(angles));
    }

    void shrink_from_centimetres() {
        Pose pose;
        place_joints(recording_.skeleton, JointAngles::at_rest(recording_.skeleton), pose);
        Vector3 lower = pose.positions[0], upper = lower;
        for (const Vector3& p : pose.positions) {
            lower = lower.cwiseMin(p);
            upper = upper.cwiseMax(p);
        }
        if ((upper - lower).maxCoeff() <= tallest) return;
        for (Joint& joint : recording_.skeleton.joints) joint.offset *= 0.01f;
        for (JointAngles& frame : recording_.frames) frame.root *= 0.01f;
    }

    /// No bone and no place of the root may be farther out than cloth may be.
    void check_places() const {
        const auto far = [](const Vector3& v) { return !(v.cwiseAbs().maxCoeff() <= runaway_distance); };
        for (const Joint& joint : recording_.skeleton.joints)
            if (far(joint.offset))
                words_.refuse_length("the offset of joint " + joint.name.substr(0, 40) + " is " +
                                     std::to_string(joint.offset.norm()) + " m");
        for (const JointAngles& frame : recording_.frames)
            if (far(frame.root))
                words_.refuse_length("a frame puts the root " + std::to_string(frame.root.norm()) +
                                     " m from the origin");
    }

    BvhWords words_;
    std::vector<Channel> channels_;
    Recording recording_;
};

}  // namespace

Result<Recording> read_bvh(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        return Error{ErrorCode::file_not_found, file.string() + ": cannot be read; name a BVH file"};
    return caught([&] { return BvhParser(BvhWords(stream, file.string())).parse(); });
}

}  // namespace weft::demo
