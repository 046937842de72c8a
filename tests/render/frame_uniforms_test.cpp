// The uniform block of frame.glsl has the layout of the struct that is uploaded.

#include <glad/gl.h>

#include <array>
#include <cstddef>

#include "render/gl/programs.h"
#include "tests/render/drawing.h"

namespace weft::render {
namespace {

using FrameBlock = Drawing;

TEST_F(FrameBlock, IsLaidOutAsItsStruct) {
    const auto programs = Programs::build();
    ASSERT_TRUE(programs) << programs.error().message;
    programs->ground.use();
    GLint id = 0, size = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &id);
    const auto program = static_cast<GLuint>(id);
    glGetActiveUniformBlockiv(program, glGetUniformBlockIndex(program, "Frame"), GL_UNIFORM_BLOCK_DATA_SIZE,
                              &size);
    EXPECT_EQ(static_cast<std::size_t>(size), sizeof(FrameUniforms));
    const std::pair<const char*, std::size_t> members[] = {
        {"Frame.clip_from_world", offsetof(FrameUniforms, clip_from_world)},
        {"Frame.world_from_clip", offsetof(FrameUniforms, world_from_clip)},
        {"Frame.sun_from_world", offsetof(FrameUniforms, sun_from_world)},
        {"Frame.sky_from_world", offsetof(FrameUniforms, sky_from_world)},
        {"Frame.eye", offsetof(FrameUniforms, eye)},
        {"Frame.sun_direction", offsetof(FrameUniforms, sun_direction)},
        {"Frame.sun_extent", offsetof(FrameUniforms, sun_extent)},
        {"Frame.sky_extent", offsetof(FrameUniforms, sky_extent)},
        {"Frame.ground", offsetof(FrameUniforms, ground)},
        {"Frame.arrow", offsetof(FrameUniforms, arrow)},
        {"Frame.quality", offsetof(FrameUniforms, quality)}};
    for (const auto& [name, offset] : members) {
        GLuint index = GL_INVALID_INDEX;
        glGetUniformIndices(program, 1, &name, &index);
        ASSERT_NE(index, GL_INVALID_INDEX) << name;
        GLint at = -1;
        glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &at);
        EXPECT_EQ(static_cast<std::size_t>(at), offset) << name;
    }
    glUseProgram(0);
}

}  // namespace
}  // namespace weft::render
