// Joints that come as lines of text.

#include "demo/character/motion/live_motion.h"

#include <fcntl.h>
#include <sys/stat.h>

#include "demo/character/motion/generated_walk.h"
#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

/// A pose of the walk as a tracker would write it, of somebody `scale` times as tall.
std::string as_text(const Pose& pose, const Skeleton& skeleton, float scale = 1) {
    std::string text;
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
        if (skeleton.joints[j].name.empty()) continue;
        const Vector3 p = scale * pose.positions[j];
        text += skeleton.joints[j].name + " " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                std::to_string(p.z()) + "\n";
    }
    return text + "frame\n";
}

Pose pose_of_walk(double time, float turn = 0) {
    GeneratedWalk walk;
    JointAngles angles;
    walk.evaluate(time, angles);
    angles.rotations[0] = Quaternion(Eigen::AngleAxisf(turn, Vector3::UnitY())) * angles.rotations[0];
    Pose pose;
    place_joints(walk.skeleton(), angles, pose);
    return pose;
}

float worst_distance(LiveMotion& live, const Pose& expected) {
    JointAngles angles;
    for (double t = 0; t < 2; t += 0.1) live.evaluate(t, angles);
    Pose pose;
    place_joints(live.skeleton(), angles, pose);
    float worst = 0;
    for (std::size_t j = 0; j < pose.positions.size(); ++j) {
        if (!live.skeleton().joints[j].name.empty())
            worst = std::max(worst, (pose.positions[j] - expected.positions[j]).norm());
    }
    return worst;
}

TEST(LiveMotion, FollowsWhatIsTracked) {
    for (const double time : {0.1, 0.4, 0.8}) {
        LiveMotion live;
        const Pose tracked = pose_of_walk(time, static_cast<float>(time) * 3);
        live.take(as_text(tracked, live.skeleton()));
        EXPECT_EQ(live.frames(), 1u);
        // The spine between hips and chest is not turned, and the head only points.
        EXPECT_LT(worst_distance(live, tracked), 0.025f) << time;
    }
}

TEST(LiveMotion, TakesTextCutAnywhereAndPeopleOfAnySize) {
    const Pose tracked = pose_of_walk(0.3);
    LiveMotion whole, cut;
    const std::string text = as_text(tracked, whole.skeleton());
    whole.take(text);
    for (std::size_t at = 0; at < text.size(); at += 7) cut.take(std::string_view(text).substr(at, 7));
    JointAngles a, b;
    whole.evaluate(10, a);
    cut.evaluate(10, b);
    for (std::size_t j = 0; j < a.rotations.size(); ++j)
        EXPECT_EQ(a.rotations[j].coeffs(), b.rotations[j].coeffs());

    LiveMotion child;
    child.take(as_text(tracked, child.skeleton(), 0.6f));
    JointAngles c;
    child.evaluate(10, c);
    EXPECT_NEAR(c.root.y(), tracked.positions[0].y(), 0.01f);
    for (std::size_t j = 0; j < a.rotations.size(); ++j)
        EXPECT_LT(a.rotations[j].angularDistance(c.rotations[j]), 0.01f);
}

TEST(LiveMotion, LeavesOutLinesThatAreNone) {
    LiveMotion live;
    const Pose tracked = pose_of_walk(0.3);
    live.take(as_text(tracked, live.skeleton()));
    JointAngles before, after;
    live.evaluate(10, before);
    for (const char* line :
         {"Hips nan 1 0", "Hips 0 1", "Hips 0 1 2 3", "Wing 0 1 0", "Hips 0 1e9 0", "Hips 0 x 0"}) {
        const std::size_t refused = live.refused();
        live.take(std::string(line) + "\n");
        EXPECT_EQ(live.refused(), refused + 1) << line;
        EXPECT_EQ(live.last_refused(), line);
    }
    live.take("\n\nframe\n");
    live.evaluate(20, after);
    EXPECT_EQ(after.root, before.root);
    for (std::size_t j = 0; j < before.rotations.size(); ++j)
        EXPECT_LT(before.rotations[j].angularDistance(after.rotations[j]), 1e-3f);
}

TEST(LiveMotion, WaitsForNoFrame) {
    LiveMotion live;
    live.take("Hips 5 5 5\n");  // not ended by "frame"
    JointAngles angles;
    live.evaluate(1, angles);
    EXPECT_NEAR(angles.root.x(), 0, 1e-6f);
}

TEST(LiveMotion, ReadsAPipeWithoutWaiting) {
    const TemporaryFile place("pipe", "");
    std::filesystem::remove(place.path());
    ASSERT_EQ(mkfifo(place.path().c_str(), 0600), 0);
    auto live = LiveMotion::open(place.path());
    ASSERT_TRUE(live.ok()) << live.error().message;
    JointAngles angles;
    (*live)->evaluate(0, angles);  // nobody writes
    const int writer = ::open(place.path().c_str(), O_WRONLY | O_NONBLOCK);
    ASSERT_GE(writer, 0);
    (*live)->evaluate(0.1, angles);  // nothing is written
    const std::string text = as_text(pose_of_walk(0.3), (*live)->skeleton());
    ASSERT_EQ(write(writer, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    (*live)->evaluate(0.2, angles);
    EXPECT_EQ((*live)->frames(), 1u);
    close(writer);
    (*live)->evaluate(0.3, angles);

    const auto none = LiveMotion::open("no/such/pipe");
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().message.find("no/such/pipe"), std::string::npos);
}

}  // namespace
}  // namespace weft::demo
