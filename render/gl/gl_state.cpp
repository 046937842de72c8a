#include "render/gl/gl_state.h"

#include "render/gl/programs.h"

namespace weft::render {

namespace {

struct PixelStore {
    GLenum name;
    GLint fresh;  // value in a new context
};
constexpr std::array<PixelStore, 16> pixel_stores{{
    {GL_PACK_SWAP_BYTES, GL_FALSE},
    {GL_PACK_LSB_FIRST, GL_FALSE},
    {GL_PACK_ROW_LENGTH, 0},
    {GL_PACK_IMAGE_HEIGHT, 0},
    {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SKIP_ROWS, 0},
    {GL_PACK_SKIP_IMAGES, 0},
    {GL_PACK_ALIGNMENT, 4},
    {GL_UNPACK_SWAP_BYTES, GL_FALSE},
    {GL_UNPACK_LSB_FIRST, GL_FALSE},
    {GL_UNPACK_ROW_LENGTH, 0},
    {GL_UNPACK_IMAGE_HEIGHT, 0},
    {GL_UNPACK_SKIP_PIXELS, 0},
    {GL_UNPACK_SKIP_ROWS, 0},
    {GL_UNPACK_SKIP_IMAGES, 0},
    {GL_UNPACK_ALIGNMENT, 4},
}};

// Capabilities that are off in a new context, except dithering and multisampling. Blending is missing: like
// the colour mask, it is saved for the first colour buffer alone, since only that one is drawn to.
constexpr std::array<GLenum, 28> capabilities = {
    GL_COLOR_LOGIC_OP,
    GL_CULL_FACE,
    GL_DEPTH_CLAMP,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_FRAMEBUFFER_SRGB,
    GL_LINE_SMOOTH,
    GL_MULTISAMPLE,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_POLYGON_OFFSET_POINT,
    GL_POLYGON_SMOOTH,
    GL_PRIMITIVE_RESTART,
    GL_RASTERIZER_DISCARD,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_MASK,
    GL_SCISSOR_TEST,
    GL_STENCIL_TEST,
    GL_CLIP_DISTANCE0,
    GL_CLIP_DISTANCE1,
    GL_CLIP_DISTANCE2,
    GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE4,
    GL_CLIP_DISTANCE5,
    GL_CLIP_DISTANCE6,
    GL_CLIP_DISTANCE7,
};

void set(GLenum capability, bool on) {
    on ? glEnable(capability) : glDisable(capability);
}

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLuint name_of(GLint bound) {
    return static_cast<GLuint>(bound);
}

}  // namespace

SavedTarget::SavedTarget()
    : draw_(integer(GL_DRAW_FRAMEBUFFER_BINDING)), read_(integer(GL_READ_FRAMEBUFFER_BINDING)) {
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
}

SavedTarget::~SavedTarget() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name_of(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name_of(read_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

SavedBindings::SavedBindings()
    : array_buffer_(integer(GL_ARRAY_BUFFER_BINDING)),
      uniform_buffer_(integer(GL_UNIFORM_BUFFER_BINDING)),
      pack_buffer_(integer(GL_PIXEL_PACK_BUFFER_BINDING)),
      unpack_buffer_(integer(GL_PIXEL_UNPACK_BUFFER_BINDING)),
      renderbuffer_(integer(GL_RENDERBUFFER_BINDING)),
      vertex_array_(integer(GL_VERTEX_ARRAY_BINDING)),
      program_(integer(GL_CURRENT_PROGRAM)),
      active_unit_(integer(GL_ACTIVE_TEXTURE)),
      texture_(integer(GL_TEXTURE_BINDING_2D)) {
    for (std::size_t i = 0; i < pixel_stores.size(); ++i) {
        pixel_store_[i] = integer(pixel_stores[i].name);
        glPixelStorei(pixel_stores[i].name, pixel_stores[i].fresh);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

SavedBindings::~SavedBindings() {
    for (std::size_t i = 0; i < pixel_stores.size(); ++i)
        glPixelStorei(pixel_stores[i].name, pixel_store_[i]);
    glBindBuffer(GL_ARRAY_BUFFER, name_of(array_buffer_));
    glBindBuffer(GL_UNIFORM_BUFFER, name_of(uniform_buffer_));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name_of(pack_buffer_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, name_of(unpack_buffer_));
    glBindRenderbuffer(GL_RENDERBUFFER, name_of(renderbuffer_));
    glBindVertexArray(name_of(vertex_array_));
    glUseProgram(name_of(program_));
    glActiveTexture(static_cast<GLenum>(active_unit_));
    glBindTexture(GL_TEXTURE_2D, name_of(texture_));
}

SavedUnits::SavedUnits() {
    static_assert(units == unit::print + 1);
    const GLint active = integer(GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < units; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        textures_[i] = integer(GL_TEXTURE_BINDING_2D);
        samplers_[i] = integer(GL_SAMPLER_BINDING);
        glBindSampler(static_cast<GLuint>(i), 0);
    }
    glActiveTexture(static_cast<GLenum>(active));
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, frame_binding, &block_buffer_);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, frame_binding, &block_start_);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, frame_binding, &block_size_);
}

SavedUnits::~SavedUnits() {
    const GLint active = integer(GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < units; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, name_of(textures_[i]));
        glBindSampler(static_cast<GLuint>(i), name_of(samplers_[i]));
    }
    glActiveTexture(static_cast<GLenum>(active));
    // A buffer that is bound as a whole has size 0.
    if (block_size_ == 0) {
        glBindBufferBase(GL_UNIFORM_BUFFER, frame_binding, name_of(block_buffer_));
    } else {
        glBindBufferRange(GL_UNIFORM_BUFFER, frame_binding, name_of(block_buffer_),
                          static_cast<GLintptr>(block_start_), static_cast<GLsizeiptr>(block_size_));
    }
}

SavedRaster::SavedRaster()
    : blend_(glIsEnabledi(GL_BLEND, 0)),
      blending_{integer(GL_BLEND_SRC_RGB),      integer(GL_BLEND_DST_RGB),
                integer(GL_BLEND_SRC_ALPHA),    integer(GL_BLEND_DST_ALPHA),
                integer(GL_BLEND_EQUATION_RGB), integer(GL_BLEND_EQUATION_ALPHA)},
      depth_func_(integer(GL_DEPTH_FUNC)),
      cull_face_(integer(GL_CULL_FACE_MODE)),
      front_face_(integer(GL_FRONT_FACE)),
      derivative_hint_(integer(GL_FRAGMENT_SHADER_DERIVATIVE_HINT)),
      provoking_vertex_(integer(GL_PROVOKING_VERTEX)) {
    for (std::size_t i = 0; i < capabilities.size(); ++i) {
        capabilities_[i] = glIsEnabled(capabilities[i]);
        set(capabilities[i], capabilities[i] == GL_DITHER || capabilities[i] == GL_MULTISAMPLE);
    }
    glGetBooleani_v(GL_COLOR_WRITEMASK, 0, color_mask_.data());
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    glGetIntegerv(GL_POLYGON_MODE, polygon_mode_.data());
    glGetDoublev(GL_DEPTH_RANGE, depth_range_.data());
    glGetDoublev(GL_DEPTH_CLEAR_VALUE, &clear_depth_);
    glGetFloatv(GL_LINE_WIDTH, &line_width_);
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_factor_);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_units_);

    glDisablei(GL_BLEND, 0);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDepthRange(0, 1);
    glClearDepth(1);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0, 0);
    glLineWidth(1);
    glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_DONT_CARE);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);  // affects how interpolation is rounded
}

SavedRaster::~SavedRaster() {
    for (std::size_t i = 0; i < capabilities.size(); ++i) set(capabilities[i], capabilities_[i] == GL_TRUE);
    const auto code = [](GLint value) { return static_cast<GLenum>(value); };
    blend_ == GL_TRUE ? glEnablei(GL_BLEND, 0) : glDisablei(GL_BLEND, 0);
    glBlendFuncSeparate(code(blending_[0]), code(blending_[1]), code(blending_[2]), code(blending_[3]));
    glBlendEquationSeparate(code(blending_[4]), code(blending_[5]));
    glColorMaski(0, color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
    glDepthMask(depth_mask_);
    glDepthFunc(code(depth_func_));
    glDepthRange(depth_range_[0], depth_range_[1]);
    glClearDepth(clear_depth_);
    glCullFace(code(cull_face_));
    glFrontFace(code(front_face_));
    glPolygonMode(GL_FRONT_AND_BACK, code(polygon_mode_[0]));  // core OpenGL has one mode for both sides
    glPolygonOffset(offset_factor_, offset_units_);
    glLineWidth(line_width_);
    glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, code(derivative_hint_));
    glProvokingVertex(code(provoking_vertex_));
}

}  // namespace weft::render
