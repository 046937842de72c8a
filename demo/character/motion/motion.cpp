#include "demo/character/motion/motion.h"

#include <utility>

namespace weft::demo {

Performance::Performance(std::unique_ptr<Motion> motion, JointAngles stance, double wait, double blend_in,
                         double speed, double ahead)
    : motion_(std::move(motion)),
      stance_(std::move(stance)),
      moved_(stance_),
      blended_(stance_),
      wait_(wait),
      blend_in_(blend_in),
      speed_(speed),
      ahead_(ahead) {}

const JointAngles& Performance::at(double time) {
    const double since = time - wait_;
    if (since <= 0) return stance_;
    motion_->evaluate(ahead_ + speed_ * since, moved_);
    if (since >= blend_in_) return moved_;
    blend(stance_, moved_, smooth_step(since / blend_in_), blended_);
    return blended_;
}

}  // namespace weft::demo
