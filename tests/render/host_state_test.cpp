// A host with OpenGL state of its own: the renderer draws the same picture in it, and leaves it as it was.
#include <glad/gl.h>
#include <imgui.h>

#include <array>
#include <cstring>
#include <map>
#include <string>

#include "drawing.h"
#include "weft/render/imgui_layer.h"

namespace weft::render {
namespace {

constexpr int host_width = 160, host_height = 100;

/// Objects of a host, bound wherever OpenGL has a place for them.
class HostObjects {
  public:
    HostObjects() {
        glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        for (const GLuint buffer : buffers_) {
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            glBufferData(GL_ARRAY_BUFFER, 256, nullptr, GL_STATIC_DRAW);
        }
        glBindBuffer(GL_UNIFORM_BUFFER, buffers_[1]);
        glBindBufferRange(GL_UNIFORM_BUFFER, 0, buffers_[1], 0, 64);
        glBindBuffer(GL_UNIFORM_BUFFER, buffers_[2]);
        glGenVertexArrays(1, &vertex_array_);
        glBindVertexArray(vertex_array_);

        glGenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
        glGenSamplers(static_cast<GLsizei>(samplers_.size()), samplers_.data());
        for (GLuint unit = 0; unit < textures_.size(); ++unit) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, textures_[unit]);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            glSamplerParameteri(samplers_[unit], GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
            glSamplerParameteri(samplers_[unit], GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
            glSamplerParameterf(samplers_[unit], GL_TEXTURE_MIN_LOD, 3);
            glBindSampler(unit, samplers_[unit]);
        }
        glActiveTexture(GL_TEXTURE3);

        glGenRenderbuffers(1, &renderbuffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
        glGenFramebuffers(2, framebuffers_.data());
        for (const GLuint framebuffer : framebuffers_) {
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
        }
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
        glViewport(1, 2, 3, 4);
        program_ = glCreateProgram();
        attach(GL_VERTEX_SHADER, "#version 330 core\nvoid main() { gl_Position = vec4(0); }");
        attach(GL_FRAGMENT_SHADER, "#version 330 core\nvoid main() {}");
        glLinkProgram(program_);
        glUseProgram(program_);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers_[3]);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers_[4]);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    }
    HostObjects(const HostObjects&) = delete;
    HostObjects& operator=(const HostObjects&) = delete;
    ~HostObjects() {
        glDeleteProgram(program_);
        glDeleteFramebuffers(2, framebuffers_.data());
        glDeleteRenderbuffers(1, &renderbuffer_);
        glDeleteSamplers(static_cast<GLsizei>(samplers_.size()), samplers_.data());
        glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
        glDeleteVertexArrays(1, &vertex_array_);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }

  private:
    void attach(GLenum stage, const char* text) const {
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }

    std::array<GLuint, 5> buffers_{};
    std::array<GLuint, 16> textures_{}, samplers_{};
    std::array<GLuint, 2> framebuffers_{};
    GLuint vertex_array_ = 0, renderbuffer_ = 0, program_ = 0;
};

void store_pixels_oddly() {
    for (const GLenum name :
         {GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT})
        glPixelStorei(name, 4096);
    for (const GLenum name : {GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_IMAGES,
                              GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(name, 5);
    for (const GLenum name :
         {GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_UNPACK_LSB_FIRST})
        glPixelStorei(name, GL_TRUE);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
}

void blend_and_mask_oddly() {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_INVERT);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glDisable(GL_DITHER);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glClearColor(0.5f, 0.25f, 0.125f, 1);
}

void test_fragments_oddly() {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 10, 10);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 1, 0xff);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_NEVER);
    glDepthRange(0.8, 0.1);
    glClearDepth(0.25);
    glEnable(GL_DEPTH_CLAMP);
    glDisable(GL_MULTISAMPLE);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.25f, GL_TRUE);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 1);
}

void rasterize_oddly() {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(1.5f);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_POLYGON_SMOOTH);
    for (const GLenum name : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
        glEnable(name);
    glPolygonOffset(100, 1000);
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(7);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    for (GLenum plane = 0; plane < 8; ++plane) glEnable(GL_CLIP_DISTANCE0 + plane);
    glEnable(GL_RASTERIZER_DISCARD);
    glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_FASTEST);
    glHint(GL_LINE_SMOOTH_HINT, GL_NICEST);
}

void set_all_oddly() {
    store_pixels_oddly();
    blend_and_mask_oddly();
    test_fragments_oddly();
    rasterize_oddly();
}

/// All of OpenGL 3.3's state that a host may have set, by name, as text.
class State {
  public:
    State() {
#define WEFT_READ(name) read(#name, name)
        WEFT_READ(GL_BLEND), WEFT_READ(GL_COLOR_LOGIC_OP), WEFT_READ(GL_CULL_FACE), WEFT_READ(GL_DEPTH_CLAMP);
        WEFT_READ(GL_DEPTH_TEST), WEFT_READ(GL_DITHER), WEFT_READ(GL_FRAMEBUFFER_SRGB),
            WEFT_READ(GL_LINE_SMOOTH);
        WEFT_READ(GL_MULTISAMPLE), WEFT_READ(GL_POLYGON_OFFSET_FILL), WEFT_READ(GL_POLYGON_OFFSET_LINE);
        WEFT_READ(GL_POLYGON_OFFSET_POINT), WEFT_READ(GL_POLYGON_SMOOTH), WEFT_READ(GL_PRIMITIVE_RESTART);
        WEFT_READ(GL_RASTERIZER_DISCARD), WEFT_READ(GL_SAMPLE_ALPHA_TO_COVERAGE),
            WEFT_READ(GL_SAMPLE_ALPHA_TO_ONE);
        WEFT_READ(GL_SAMPLE_COVERAGE), WEFT_READ(GL_SAMPLE_MASK), WEFT_READ(GL_SCISSOR_TEST);
        WEFT_READ(GL_STENCIL_TEST), WEFT_READ(GL_PROGRAM_POINT_SIZE), WEFT_READ(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        for (GLenum plane = 0; plane < 8; ++plane)
            read("GL_CLIP_DISTANCE" + std::to_string(plane), GL_CLIP_DISTANCE0 + plane);

        WEFT_READ(GL_BLEND_SRC_RGB), WEFT_READ(GL_BLEND_DST_RGB), WEFT_READ(GL_BLEND_SRC_ALPHA);
        WEFT_READ(GL_BLEND_DST_ALPHA), WEFT_READ(GL_BLEND_EQUATION_RGB), WEFT_READ(GL_BLEND_EQUATION_ALPHA);
        WEFT_READ(GL_BLEND_COLOR), WEFT_READ(GL_LOGIC_OP_MODE), WEFT_READ(GL_COLOR_WRITEMASK);
        WEFT_READ(GL_COLOR_CLEAR_VALUE), WEFT_READ(GL_DEPTH_CLEAR_VALUE), WEFT_READ(GL_DEPTH_FUNC);
        WEFT_READ(GL_DEPTH_WRITEMASK), WEFT_READ(GL_DEPTH_RANGE), WEFT_READ(GL_SCISSOR_BOX),
            WEFT_READ(GL_VIEWPORT);
        WEFT_READ(GL_STENCIL_FUNC), WEFT_READ(GL_SAMPLE_COVERAGE_VALUE), WEFT_READ(GL_SAMPLE_COVERAGE_INVERT);
        WEFT_READ(GL_CULL_FACE_MODE), WEFT_READ(GL_FRONT_FACE), WEFT_READ(GL_POLYGON_MODE),
            WEFT_READ(GL_LINE_WIDTH);
        WEFT_READ(GL_POLYGON_OFFSET_FACTOR), WEFT_READ(GL_POLYGON_OFFSET_UNITS);
        WEFT_READ(GL_PRIMITIVE_RESTART_INDEX), WEFT_READ(GL_PROVOKING_VERTEX);
        WEFT_READ(GL_FRAGMENT_SHADER_DERIVATIVE_HINT), WEFT_READ(GL_LINE_SMOOTH_HINT);

        WEFT_READ(GL_PACK_ROW_LENGTH), WEFT_READ(GL_PACK_IMAGE_HEIGHT), WEFT_READ(GL_PACK_SKIP_PIXELS);
        WEFT_READ(GL_PACK_SKIP_ROWS), WEFT_READ(GL_PACK_SKIP_IMAGES), WEFT_READ(GL_PACK_SWAP_BYTES);
        WEFT_READ(GL_PACK_LSB_FIRST), WEFT_READ(GL_PACK_ALIGNMENT), WEFT_READ(GL_UNPACK_ROW_LENGTH);
        WEFT_READ(GL_UNPACK_IMAGE_HEIGHT), WEFT_READ(GL_UNPACK_SKIP_PIXELS), WEFT_READ(GL_UNPACK_SKIP_ROWS);
        WEFT_READ(GL_UNPACK_SKIP_IMAGES), WEFT_READ(GL_UNPACK_SWAP_BYTES), WEFT_READ(GL_UNPACK_LSB_FIRST);
        WEFT_READ(GL_UNPACK_ALIGNMENT);

        WEFT_READ(GL_DRAW_FRAMEBUFFER_BINDING), WEFT_READ(GL_READ_FRAMEBUFFER_BINDING);
        WEFT_READ(GL_RENDERBUFFER_BINDING), WEFT_READ(GL_CURRENT_PROGRAM), WEFT_READ(GL_VERTEX_ARRAY_BINDING);
        WEFT_READ(GL_ARRAY_BUFFER_BINDING), WEFT_READ(GL_ELEMENT_ARRAY_BUFFER_BINDING);
        WEFT_READ(GL_PIXEL_PACK_BUFFER_BINDING), WEFT_READ(GL_PIXEL_UNPACK_BUFFER_BINDING);
        WEFT_READ(GL_UNIFORM_BUFFER_BINDING), WEFT_READ(GL_ACTIVE_TEXTURE);
        read_indexed();
#undef WEFT_READ
    }

    /// The names of what is not the same in `other`, with both values.
    [[nodiscard]] std::string difference(const State& other) const {
        std::string text;
        for (const auto& [name, value] : values_)
            if (value != other.values_.at(name))
                text += name + ": " + value + "is now " + other.values_.at(name) + "\n";
        return text;
    }

  private:
    void read(const std::string& name, GLenum value) {
        std::array<GLfloat, 4> numbers{};
        glGetFloatv(value, numbers.data());
        write(name, numbers);
    }
    template <class Numbers>
    void write(const std::string& name, const Numbers& numbers) {
        std::string& text = values_[name];
        for (const auto number : numbers) text += std::to_string(number) + " ";
    }
    void read_indexed() {
        GLint mask = 0, active = 0, binding = 0;
        std::array<GLint64, 2> range{};
        glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &binding);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, 0, &range[0]);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, 0, &range[1]);
        write("GL_SAMPLE_MASK_VALUE", std::array{mask});
        write("uniform block 0", std::array<GLint64, 3>{binding, range[0], range[1]});
        glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
        for (GLenum unit = 0; unit < 16; ++unit) {
            std::array<GLint, 2> bound{};
            glActiveTexture(GL_TEXTURE0 + unit);
            glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound[0]);
            glGetIntegerv(GL_SAMPLER_BINDING, &bound[1]);
            write("texture and sampler of unit " + std::to_string(unit), bound);
        }
        glActiveTexture(static_cast<GLenum>(active));
    }

    std::map<std::string, std::string> values_;
};

/// A picture with something of everything that is drawn.
struct Everything {
    Everything() {
        view.camera = {.target = {0, 0.4f, 0}, .distance = 3, .yaw = 0.3f, .pitch = 0.5f};
        view.capsules = {&capsule, 1};
        view.wind = {2, 0, 1};
        view.wireframe = true;
    }
    DrawnCapsule capsule{{-0.6f, 0.2f, 0.3f}, {-0.2f, 0.5f, 0.3f}, 0.15f};
    Sheet sheet = make_sheet(40, {0.3f, 0.7f, 0}, {1, 0, 0}, {0, 0.2f, -1});
    View view;
};

/// The host's objects are its own.
class HostState : public Drawing {
  protected:
    HostState() { counts_objects = false; }
};

void expect_the_same_picture_and_state(SceneRenderer& first_renderer) {
    const Everything scene;
    show(first_renderer, scene.sheet, signal_look());
    const Image expected = first_renderer.capture(scene.view, host_width, host_height);

    const HostObjects objects;
    set_all_oddly();
    const State before;
    {
        // Even what is made once is made in the host's state.
        auto renderer = SceneRenderer::create();
        ASSERT_TRUE(renderer) << renderer.error().message;
        EXPECT_EQ(before.difference({}), "") << "create()";
        const ClothHandle cloth = renderer->add_cloth(scene.sheet.surface(signal_look()));
        EXPECT_EQ(before.difference({}), "") << "add_cloth()";
        renderer->update_cloth(cloth, scene.sheet.frame());
        EXPECT_EQ(before.difference({}), "") << "update_cloth()";
        const Image image = renderer->capture(scene.view, host_width, host_height);
        EXPECT_EQ(before.difference({}), "") << "capture()";
        EXPECT_TRUE(image.rgb == expected.rgb);
        renderer->remove_cloth(cloth);
    }
    EXPECT_EQ(before.difference({}), "") << "the renderer's end";
}

TEST_F(HostState, NeitherChangesThePictureNorIsChanged) {
    expect_the_same_picture_and_state(renderer());
}

TEST_F(HostState, IsKeptByDrawButForTheTarget) {
    const Everything scene;
    show(renderer(), scene.sheet, signal_look());
    const Image expected = renderer().capture(scene.view, host_width, host_height);

    const HostObjects objects;
    set_all_oddly();
    GLuint texture = 0, framebuffer = 0;
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glActiveTexture(GL_TEXTURE9);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, host_width, host_height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, host_width, host_height);
    const State before;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(7, 7, 7, 7);
    renderer().draw(scene.view, host_width, host_height, framebuffer);
    EXPECT_EQ(before.difference({}), "")
        << "the target is bound, its viewport set, and all else is the host's";

    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SWAP_BYTES})
        glPixelStorei(name, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    std::vector<std::uint8_t> rows(expected.rgb.size());
    glReadPixels(0, 0, host_width, host_height, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
    const std::size_t row = 3 * static_cast<std::size_t>(host_width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(host_height); ++y)
        ASSERT_EQ(std::memcmp(&rows[y * row], &expected.rgb[(host_height - 1 - y) * row], row), 0)
            << "row " << y;
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

TEST_F(HostState, NeitherChangesPanelsNorIsChangedByThem) {
    const View view;
    const auto picture_with_panel = [&](ImGuiLayer& layer) {
        layer.begin(host_width, host_height, 1.0f / 60);
        ImGui::SetNextWindowPos({20, 10});
        ImGui::SetNextWindowSize({100, 60});
        ImGui::Begin("Panel");
        ImGui::TextUnformatted("text");
        ImGui::End();
        return renderer().capture(view, host_width, host_height, [&] { layer.end(); });
    };
    Image expected;
    {
        ImGuiLayer layer(context());
        expected = picture_with_panel(layer);
    }
    const HostObjects objects;
    set_all_oddly();
    const State before;
    {
        ImGuiLayer layer(context());
        const Image image = picture_with_panel(layer);
        EXPECT_EQ(before.difference({}), "");
        EXPECT_TRUE(image.rgb == expected.rgb);
    }
    EXPECT_EQ(before.difference({}), "") << "the layer's end";
}

}  // namespace
}  // namespace weft::render
