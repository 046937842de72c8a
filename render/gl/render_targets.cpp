#include "render/gl/render_targets.h"

#include <algorithm>
#include <array>

namespace weft::render {

namespace {

Texture make_texture(GLint format, int width, int height, GLenum layout, GLenum type, GLint filter) {
    Texture texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

Framebuffer make_framebuffer(const Texture& texture, GLenum attachment) {
    Framebuffer framebuffer = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
    return framebuffer;
}

Renderbuffer attach_renderbuffer(GLenum attachment, GLenum format, int width, int height, int samples) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    Renderbuffer buffer = Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    const GLint multiple = samples > 1 ? std::min(samples, most) : 0;
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, multiple, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
    return buffer;
}

void bind_texture(int texture_unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(texture_unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

// Depth of a map's border: outside a map nothing casts a shadow.
constexpr std::array far_away = {1.0f, 1.0f, 1.0f, 1.0f};

DepthMap::DepthMap(int texels) : compare_(Sampler::make()) {
    glSamplerParameteri(compare_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(compare_.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glSamplerParameteri(compare_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(compare_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(compare_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(compare_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(compare_.id(), GL_TEXTURE_BORDER_COLOR, far_away.data());
    resize(texels);
}

void DepthMap::resize(int texels) {
    if (texels == texels_) return;
    texels_ = texels;
    texture_ = make_texture(GL_DEPTH_COMPONENT32F, texels, texels, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far_away.data());
    framebuffer_ = make_framebuffer(texture_, GL_DEPTH_ATTACHMENT);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

void DepthMap::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, texels_, texels_);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void DepthMap::bind(int plain_unit) const {
    bind_texture(plain_unit, texture_);
}

void DepthMap::bind(int plain_unit, int compare_unit) const {
    bind_texture(plain_unit, texture_);
    bind_texture(compare_unit, texture_);
    glBindSampler(static_cast<GLuint>(compare_unit), compare_.id());
}

void ScenePicture::resize(int width, int height, int samples) {
    if (width == width_ && height == height_ && samples == samples_) return;
    width_ = width;
    height_ = height;
    samples_ = samples;
    resolved_color_ = make_texture(GL_RGBA16F, width, height, GL_RGBA, GL_HALF_FLOAT, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    resolved_ = make_framebuffer(resolved_color_, GL_COLOR_ATTACHMENT0);
    drawn_ = {};
    color_ = {};
    if (samples > 1) {
        drawn_ = Framebuffer::make();
        glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
        color_ = attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height, samples);
    }
    depth_ = attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height, samples);
}

void ScenePicture::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 1 ? drawn_.id() : resolved_.id());
    glViewport(0, 0, width_, height_);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ScenePicture::resolve(int texture_unit, bool smooth) const {
    if (samples_ > 1) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    bind_texture(texture_unit, resolved_color_);
    const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

void CaptureTarget::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    color_ = make_texture(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
    framebuffer_ = make_framebuffer(color_, GL_COLOR_ATTACHMENT0);
}

}  // namespace weft::render
