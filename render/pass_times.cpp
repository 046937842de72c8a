#include "render/pass_times.h"

namespace weft::render {

PassTimes::PassTimes() {
    for (Picture& picture : pictures_)
        for (Query& query : picture.queries) query = Query::make();
}

void PassTimes::begin() {
    picture_ = (picture_ + 1) % pictures;
    read(pictures_[picture_]);
    mark_ = 0;
    mark();
}

void PassTimes::mark() {
    glQueryCounter(pictures_[picture_].queries[mark_++].id(), GL_TIMESTAMP);
}

void PassTimes::end() {
    mark();
    pictures_[picture_].asked = true;
}

/// Reads a picture's timestamps; those that are not available yet are dropped.
void PassTimes::read(Picture& picture) {
    if (!picture.asked) return;
    picture.asked = false;
    GLint there = 0;
    glGetQueryObjectiv(picture.queries.back().id(), GL_QUERY_RESULT_AVAILABLE, &there);
    if (there == 0) return;
    std::array<GLuint64, marks> at{};
    for (std::size_t i = 0; i < marks; ++i)
        glGetQueryObjectui64v(picture.queries[i].id(), GL_QUERY_RESULT, &at[i]);
    const auto milliseconds = [&](std::size_t part) {
        return at[part + 1] > at[part] ? 1e-6f * static_cast<float>(at[part + 1] - at[part]) : 0.0f;
    };
    latest_ = {.shadows = milliseconds(0), .scene = milliseconds(1), .display = milliseconds(2)};
}

}  // namespace weft::render
