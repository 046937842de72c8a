#pragma once
// Live motion: joints as lines of text from a pipe, as a tracker behind a camera writes them.
//
//     Hips 0.01 0.93 0.20          a joint of plain_skeleton() by name, and where it is: x y z [m], +Y up
//     LeftArm 0.18 1.31 0.19       LeftArm is the shoulder's joint, LeftUpLeg the hip's
//     ...                          as many as are seen, in any order
//     frame                        ends a frame: from here on its joints count
//
// Joints that are not seen keep their rotations. A line of another form, or with a malformed number, is
// ignored. Bones keep their lengths, so that the tracked person may be of any size.

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "demo/character/body/body_joints.h"
#include "demo/character/motion/motion.h"
#include "weft/error.h"

namespace weft::demo {

class LiveMotion final : public Motion {
  public:
    /// Opens a pipe (a FIFO); reading never waits. Error: it cannot be opened.
    [[nodiscard]] static Result<std::unique_ptr<LiveMotion>> open(const std::filesystem::path& pipe);
    /// A motion without a pipe, for text from take() only.
    LiveMotion();
    ~LiveMotion() override;
    LiveMotion(const LiveMotion&) = delete;
    LiveMotion& operator=(const LiveMotion&) = delete;

    [[nodiscard]] const Skeleton& skeleton() const override { return skeleton_; }
    /// Reads the text that has arrived and approaches the last whole frame, with a time constant of 50 ms.
    void evaluate(double time, JointAngles& angles) override;

    /// Parses text as it arrives; lines may be cut anywhere.
    void take(std::string_view text);
    [[nodiscard]] std::size_t frames() const { return frames_; }    ///< whole ones so far
    [[nodiscard]] std::size_t refused() const { return refused_; }  ///< ignored lines
    [[nodiscard]] const std::string& last_refused() const { return last_refused_; }

  private:
    void take_line(std::string_view line);
    void end_frame();
    [[nodiscard]] bool seen(std::size_t joint) const { return seen_.contains(joint); }
    void turn_trunk(std::size_t joint, std::size_t left, std::size_t right, const Pose& rest);
    void turn_limbs();

    Skeleton skeleton_;
    BodyJoints joints_;
    int pipe_ = -1;
    std::string unfinished_;               // a line that has not ended
    std::map<std::size_t, Vector3> seen_;  // joints of the frame that has not ended [m]
    JointAngles newest_, shown_;
    double shown_at_ = 0;
    float scale_ = 0;  // own thigh's length over the tracked one's; 0: not known yet
    std::size_t frames_ = 0, refused_ = 0;
    std::string last_refused_;
};

}  // namespace weft::demo
