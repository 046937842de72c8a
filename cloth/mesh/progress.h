#pragma once
// How far cooking is, for the host to see.

#include "engine/without_exceptions.h"
#include "weft/cooked_cloth.h"

namespace weft {

/// Stages of cooking end at these parts of it, which are rough.
class Progress {
  public:
    static constexpr float welded = 0.1f, ordered = 0.2f, joined = 0.3f, stored = 0.4f, modelled = 0.5f,
                           solvable = 0.8f, limited = 0.9f, done = 1;

    Progress() = default;
    explicit Progress(const CookProgress& host) : host_(host) {}

    /// Throws a Refusal where the host cancels.
    void reach(float part) const {
        if (host_.report == nullptr || host_.report(host_.user, part) || part >= done) return;
        throw Refusal{{ErrorCode::cancelled, "cooking was cancelled by CookProgress::report"}};
    }

  private:
    CookProgress host_;
};

}  // namespace weft
