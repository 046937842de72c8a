#pragma once
// The progress of cooking, as the host receives it.

#include "engine/memory/without_exceptions.h"
#include "weft/cooked_cloth.h"

namespace weft {

/// The constants are the parts of cooking that are done when its stages end. They are rough.
class Progress {
  public:
    static constexpr float welded = 0.1f, ordered = 0.2f, joined = 0.3f, stored = 0.4f, modelled = 0.5f,
                           solvable = 0.8f, limited = 0.9f, done = 1;

    Progress() = default;
    explicit Progress(const CookProgress& host) : host_(host) {}

    [[nodiscard]] static Error cancelled() {
        return {ErrorCode::cancelled, "cooking was cancelled by CookProgress::report"};
    }

    /// Reports a part to the host; throws a Refusal if the host cancels. Without exceptions cooking goes on,
    /// and its caller drops the result.
    void reach(float part) const {
        if (host_.report == nullptr || is_cancelled_ || host_.report(host_.user, part) || part >= done)
            return;
        if constexpr (has_exceptions) refuse(cancelled());
        is_cancelled_ = true;
    }
    [[nodiscard]] bool is_cancelled() const { return is_cancelled_; }

  private:
    CookProgress host_;
    mutable bool is_cancelled_ = false;
};

}  // namespace weft
