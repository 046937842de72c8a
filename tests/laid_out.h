#pragma once
// Objects whose arrays lie in scratch, each in memory of its own.

#include <cstring>

#include "engine/memory/scratch.h"

namespace weft::test {

template <class Object>
class LaidOut : public Object {
  public:
    LaidOut() = default;
    template <class... Sizes>
    explicit LaidOut(const Sizes&... sizes) requires(sizeof...(Sizes) > 0) {
        reserve(sizes...);
    }
    LaidOut(LaidOut&&) noexcept = default;
    LaidOut& operator=(LaidOut&&) noexcept = default;

    /// Lays the object out, with what Object::lay_out() takes. Memory that was used before holds what was
    /// left there, and new memory rubbish.
    template <class... Sizes>
    void reserve(const Sizes&... sizes) {
        Scratch measure;
        Object().lay_out(measure, sizes...);
        if (measure.bytes() > memory_.bytes()) {
            memory_ = ScratchMemory(measure.bytes());
            std::memset(memory_.data(), 0xA5, memory_.bytes());
        }
        Scratch scratch(memory_.data());
        static_cast<Object&>(*this) = Object();
        Object::lay_out(scratch, sizes...);
    }

  private:
    ScratchMemory memory_;
};

}  // namespace weft::test
