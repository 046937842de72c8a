#include "demo/time/timeline.h"

#include <utility>

namespace weft::demo {

bool Timeline::make_room(std::size_t size, Moment& moment) {
    if (size > room_) return false;
    while (bytes_ + size > room_) {
        bytes_ -= moments_.front().save.size();
        moment = std::move(moments_.front());
        moments_.pop_front();
    }
    moment.save.resize(size);
    return true;
}

Result<void> Timeline::keep(const Simulation& simulation, const HandMark& mark) {
    while (moments_.size() > here_ + 1) {
        bytes_ -= moments_.back().save.size();
        moments_.pop_back();
    }
    if (std::exchange(cuts_, simulation.cuts()) != simulation.cuts()) clear();
    Moment moment;
    if (!make_room(simulation.world().save_size(), moment)) {
        clear();
        return {};
    }
    if (auto saved = simulation.world().save(moment.save); !saved) {
        clear();
        return saved;
    }
    moment.time = simulation.time();
    moment.mark = mark;
    bytes_ += moment.save.size();
    moments_.push_back(std::move(moment));
    here_ = moments_.size() - 1;
    return {};
}

Result<void> Timeline::go_to(std::size_t which, Simulation& simulation) {
    const Moment& moment = moments_[which];
    if (auto restored = simulation.world().restore(moment.save); !restored) return restored;
    simulation.set_time(moment.time);
    here_ = which;
    return {};
}

void Timeline::clear() {
    moments_.clear();
    bytes_ = here_ = 0;
}

}  // namespace weft::demo
