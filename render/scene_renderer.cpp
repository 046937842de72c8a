#include "weft/render/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <map>
#include <string_view>

#include "render/gl/gl_state.h"
#include "render/gl/programs.h"
#include "render/gl/render_targets.h"
#include "render/meshes/cloth_mesh.h"
#include "render/meshes/solid_meshes.h"
#include "render/pass_times.h"
#include "render/view/matrices.h"

namespace weft::render {

namespace {

/// Clamps every number to its range.
Quality bounded(Quality quality) {
    quality.samples = std::clamp(quality.samples, 1, 4);
    quality.sun_map = std::clamp(quality.sun_map, 64, 4096);
    quality.sky_map = std::clamp(quality.sky_map, 64, 4096);
    quality.blocker_taps = std::clamp(quality.blocker_taps, 0, 16);
    quality.sun_taps = std::clamp(quality.sun_taps, 1, 32);
    quality.sky_taps = std::clamp(quality.sky_taps, 0, 32);
    quality.resolution = quality.resolution >= 0.25f ? std::min(quality.resolution, 1.0f) : 0.25f;
    return quality;
}

Vec4 shader_quality(const Quality& quality) {
    return {static_cast<float>(quality.blocker_taps), static_cast<float>(quality.sun_taps),
            static_cast<float>(quality.sky_taps), quality.weave ? 1.0f : 0.0f};
}

int scaled(int pixels, float resolution) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(pixels) * resolution)));
}

Vector3 unit_or_up(const Vec3& direction) {
    const Vector3 v = to_vector(direction);
    return v.norm() > 1e-6f ? Vector3(v.normalized()) : Vector3(Vector3::UnitY());
}

/// Maps clip coordinates to texture coordinates and depth, all in [0, 1].
Matrix4f map_from_clip() {
    Matrix4f m = Matrix4f::Identity();
    m.diagonal() << 0.5f, 0.5f, 0.5f, 1.0f;
    m.col(3) << 0.5f, 0.5f, 0.5f, 1.0f;
    return m;
}

Vec4 extent_of(const LightFrame& light, int texels) {
    return {light.side, light.depth, light.side / static_cast<float>(texels), 0};
}

/// Foot and vector of the wind's arrow. The foot lies upwind of the scene; the length saturates at 1 m.
Vec4 wind_arrow(const Vec3& wind, const Box& bounds) {
    const Vector3 along(wind.x, 0, wind.z);
    const float speed = along.norm();
    if (speed < 1e-3f) return {};
    const float length = 0.25f + 0.75f * speed / (speed + 6.0f);
    const Vector3 center = bounds.center();
    const float clear_of_scene = 0.5f * std::hypot(bounds.sizes().x(), bounds.sizes().z()) + 0.25f;
    const Vector3 foot = center - along / speed * (clear_of_scene + length);
    return {foot.x(), foot.z(), along.x() / speed * length, along.z() / speed * length};
}

Matrix4f clip_from_world(const OrbitCamera& camera, float aspect) {
    const Matrix4 view = camera.view(), projection = camera.projection(aspect);
    return Matrix4f(projection.data()) * Matrix4f(view.data());
}

void set_look_uniforms(const Program& program, const FabricLook& look) {
    program.set("front", look.front);
    program.set("back", look.back);
    program.set("stripe", look.stripe);
    program.set("roughness", look.roughness);
    program.set("sheen", look.sheen);
    program.set("translucency", look.translucency);
    program.set("opacity", std::clamp(look.opacity, 0.0f, 1.0f));
    const bool threads = look.threads != Threads::none && look.thread_width > 0;
    program.set("threads_per_metre", threads ? 1e3f / look.thread_width : 0.0f);
    program.set("threads", static_cast<int>(look.threads));
    program.set("shine", look.shine);
    program.set("shine_width", std::clamp(look.shine_width, 0.02f, 1.0f));
    program.set("stripe_width", look.stripe_width);
}

bool is_ghost(const ClothMesh& cloth) {
    return cloth.look.opacity < 1;
}

}  // namespace

struct SceneRenderer::Impl {
    explicit Impl(Programs built)
        : programs(std::move(built)), sun_map(Quality{}.sun_map), sky_map(Quality{}.sky_map) {}

    Programs programs;
    DepthMap sun_map, sky_map;
    ScenePicture picture;
    CaptureTarget capture_target;
    Buffer frame_uniforms = Buffer::make();
    VertexArray no_attributes = VertexArray::make();  // for vertices made from gl_VertexID
    CapsuleMesh capsule_mesh;
    BoxMesh box_mesh;
    LineMesh line_mesh;
    PassTimes pass_times;
    std::vector<DrawnTaperedCapsule> solids;  // spheres and capsules of the current picture
    std::vector<DrawnBox> boxes;

    std::map<ClothHandle, ClothMesh> cloths;
    ClothHandle last_handle = 0;

    void draw(const View& view, int width, int height, unsigned target);

  private:
    void gather_solids(const View& view);
    [[nodiscard]] Box scene_bounds() const;
    void upload_frame(const View& view, const Matrix4f& clip, const LightFrame& sun, const LightFrame& sky,
                      const Box& bounds) const;
    void draw_depth(const DepthMap& map, const LightFrame& light, float alpha, GLenum hidden_side) const;
    void draw_sky() const;
    void draw_ground() const;
    void draw_solids(const Program& program, const Matrix4f& clip) const;
    void draw_cloths(const Matrix4f& clip, float alpha) const;
    void draw_ghosts(const Matrix4f& clip, float alpha) const;
    void draw_cloth_lines(const Matrix4f& clip, float alpha) const;
    void draw_lines(std::span<const DrawnLine> lines);
    void draw_maps(const LightFrame& sun, const LightFrame& sky, const View& view, const Quality& quality);
    void draw_scene(const View& view, const Matrix4f& clip);
    void display(unsigned target, int width, int height) const;
};

void SceneRenderer::Impl::draw(const View& view, int width, int height, unsigned target) {
    const Quality quality = bounded(view.quality);
    gather_solids(view);
    const Box bounds = scene_bounds();
    sun_map.resize(quality.sun_map);
    sky_map.resize(quality.sky_map);
    const LightFrame sun = fit_light(unit_or_up(view.sun_direction), bounds, sun_map.texels());
    const LightFrame sky = fit_light(Vector3::UnitY(), bounds, sky_map.texels());
    const Matrix4f clip =
        clip_from_world(view.camera, static_cast<float>(width) / static_cast<float>(height));
    upload_frame(view, clip, sun, sky, bounds);
    picture.resize(scaled(width, quality.resolution), scaled(height, quality.resolution), quality.samples);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);

    pass_times.begin();
    draw_maps(sun, sky, view, quality);
    pass_times.mark();
    draw_scene(view, clip);
    const bool smooth = quality.resolution < 1;
    picture.resolve(unit::picture, smooth);
    pass_times.mark();
    display(target, width, height);
    pass_times.end();
}

/// The sun's map holds the lit sides of solids. The map from above holds their undersides, whose depth gives
/// the height above the ground.
void SceneRenderer::Impl::draw_maps(const LightFrame& sun, const LightFrame& sky, const View& view,
                                    const Quality& quality) {
    draw_depth(sun_map, sun, view.alpha, GL_BACK);
    if (quality.sky_taps > 0) draw_depth(sky_map, sky, view.alpha, GL_FRONT);
    sun_map.bind(unit::sun_depth, unit::sun_compare);
    sky_map.bind(unit::sky_depth);
}

/// Draws solids and cloth before the ground and the sky, so that hidden ground and sky are not shaded.
void SceneRenderer::Impl::draw_scene(const View& view, const Matrix4f& clip) {
    picture.begin();
    draw_solids(programs.solid, clip);
    draw_cloths(clip, view.alpha);
    if (view.ground) draw_ground();
    draw_sky();
    draw_ghosts(clip, view.alpha);
    if (view.wireframe) draw_cloth_lines(clip, view.alpha);
    draw_lines(view.lines);
}

void SceneRenderer::Impl::gather_solids(const View& view) {
    solids.assign(view.tapered_capsules.begin(), view.tapered_capsules.end());
    for (const DrawnCapsule& capsule : view.capsules) solids.push_back(as_tapered(capsule));
    for (const DrawnSphere& sphere : view.spheres) solids.push_back(as_tapered(sphere));
    boxes.assign(view.boxes.begin(), view.boxes.end());
}

Box SceneRenderer::Impl::scene_bounds() const {
    Box box;
    for (const auto& [handle, cloth] : cloths) box.extend(cloth.bounds());
    for (const DrawnTaperedCapsule& solid : solids) box.extend(bounds_of(solid));
    for (const DrawnBox& solid : boxes) box.extend(bounds_of(solid));
    if (box.isEmpty()) box.extend(Vector3(0, 0, 0));
    return box;
}

void SceneRenderer::Impl::upload_frame(const View& view, const Matrix4f& clip, const LightFrame& sun,
                                       const LightFrame& sky, const Box& bounds) const {
    const Vec3& target = view.camera.target;
    const FrameUniforms frame{
        .clip_from_world = to_matrix4(clip),
        .world_from_clip = to_matrix4(clip.inverse()),
        .sun_from_world = to_matrix4(map_from_clip() * sun.clip_from_world),
        .sky_from_world = to_matrix4(map_from_clip() * sky.clip_from_world),
        .eye = to_vec4(to_vector(view.camera.eye()), 0),
        .sun_direction = to_vec4(unit_or_up(view.sun_direction), 0),
        .sun_extent = extent_of(sun, sun_map.texels()),
        .sky_extent = extent_of(sky, sky_map.texels()),
        .ground = {target.x, view.ground_height, target.z, std::max(14.0f, 2.0f * view.camera.distance)},
        .arrow = wind_arrow(view.wind, bounds),
        .quality = shader_quality(bounded(view.quality)),
    };
    glBindBuffer(GL_UNIFORM_BUFFER, frame_uniforms.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(frame), &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_uniforms.id());
}

void SceneRenderer::Impl::draw_depth(const DepthMap& map, const LightFrame& light, float alpha,
                                     GLenum hidden_side) const {
    map.begin();
    // A depth offset that grows with the slope prevents stripes of shadow on lit surfaces.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    glCullFace(hidden_side);
    glEnable(GL_CULL_FACE);
    draw_solids(programs.solid_depth, light.clip_from_world);
    glDisable(GL_CULL_FACE);
    programs.cloth_depth.use();
    programs.cloth_depth.set("clip", to_matrix4(light.clip_from_world));
    for (const auto& [handle, cloth] : cloths)
        if (!is_ghost(cloth)) cloth.draw(programs.cloth_depth, alpha);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void SceneRenderer::Impl::draw_sky() const {
    programs.sky.use();
    glBindVertexArray(no_attributes.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// The ground is culled from below, so that it never hides the scene.
void SceneRenderer::Impl::draw_ground() const {
    glCullFace(GL_BACK);
    glEnable(GL_CULL_FACE);
    programs.ground.use();
    glBindVertexArray(no_attributes.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_CULL_FACE);
}

void SceneRenderer::Impl::draw_solids(const Program& program, const Matrix4f& clip) const {
    program.use();
    program.set("clip", to_matrix4(clip));
    for (const DrawnTaperedCapsule& solid : solids) capsule_mesh.draw(program, solid);
    for (const DrawnBox& solid : boxes) box_mesh.draw(program, solid);
}

void SceneRenderer::Impl::draw_cloths(const Matrix4f& clip, float alpha) const {
    programs.cloth.use();
    programs.cloth.set("clip", to_matrix4(clip));
    for (const auto& [handle, cloth] : cloths) {
        if (is_ghost(cloth)) continue;
        set_look_uniforms(programs.cloth, cloth.look);
        cloth.draw_shaded(programs.cloth, alpha);
    }
}

/// Draws of each ghost the layer that is nearest to the eye, once. Cloth that lies in the same place hides
/// it.
void SceneRenderer::Impl::draw_ghosts(const Matrix4f& clip, float alpha) const {
    if (std::ranges::none_of(cloths, [](const auto& each) { return is_ghost(each.second); })) return;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f, 4.0f);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    programs.cloth_depth.use();
    programs.cloth_depth.set("clip", to_matrix4(clip));
    for (const auto& [handle, cloth] : cloths)
        if (is_ghost(cloth)) cloth.draw(programs.cloth_depth, alpha);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    programs.cloth.use();
    for (const auto& [handle, cloth] : cloths) {
        if (!is_ghost(cloth)) continue;
        set_look_uniforms(programs.cloth, cloth.look);
        cloth.draw_shaded(programs.cloth, alpha);
    }
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void SceneRenderer::Impl::draw_cloth_lines(const Matrix4f& clip, float alpha) const {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glPolygonOffset(-1.0f, -4.0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    programs.cloth_lines.use();
    programs.cloth_lines.set("clip", to_matrix4(clip));
    for (const auto& [handle, cloth] : cloths)
        if (!is_ghost(cloth)) cloth.draw(programs.cloth_lines, alpha);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_LINE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void SceneRenderer::Impl::draw_lines(std::span<const DrawnLine> lines) {
    if (lines.empty()) return;
    programs.lines.use();
    line_mesh.draw(lines);
}

void SceneRenderer::Impl::display(unsigned target, int width, int height) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    programs.display.use();
    programs.display.set("size", Vec2{static_cast<float>(width), static_cast<float>(height)});
    glBindVertexArray(no_attributes.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

SceneRenderer::SceneRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<SceneRenderer> SceneRenderer::create() {
    const SavedTarget target;
    const SavedBindings bindings;
    auto programs = Programs::build();
    if (!programs) return programs.error();
    return SceneRenderer(std::make_unique<Impl>(std::move(*programs)));
}

ClothHandle SceneRenderer::add_cloth(const ClothSurface& surface) {
    const SavedBindings bindings;
    impl_->cloths.try_emplace(++impl_->last_handle, surface);
    return impl_->last_handle;
}

void SceneRenderer::remove_cloth(ClothHandle cloth) {
    impl_->cloths.erase(cloth);
}

void SceneRenderer::update_cloth(ClothHandle cloth, const ClothFrame& frame) {
    const SavedBindings bindings;
    if (const auto found = impl_->cloths.find(cloth); found != impl_->cloths.end())
        found->second.stream(frame);
}

void SceneRenderer::set_look(ClothHandle cloth, const FabricLook& look) {
    if (const auto found = impl_->cloths.find(cloth); found != impl_->cloths.end()) found->second.look = look;
}

void SceneRenderer::draw(const View& view, int width, int height, unsigned target) {
    if (width <= 0 || height <= 0) return;
    {
        const SavedDrawing host;
        impl_->draw(view, width, height, target);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width, height);
}

Image SceneRenderer::capture(const View& view, int width, int height, const std::function<void()>& overlay) {
    const SavedTarget host_target;
    CaptureTarget& target = impl_->capture_target;
    {
        const SavedBindings bindings;
        target.resize(width, height);
    }
    draw(view, width, height, target.framebuffer());
    if (overlay) overlay();
    const SavedBindings bindings;  // saved again, since the overlay may have changed them
    return target.read();
}

bool SceneRenderer::drawn_by_processor() const {
    const std::string_view name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos ||
           name.find("SwiftShader") != name.npos || name.find("swrast") != name.npos;
}

void SceneRenderer::wait() const {
    glFinish();
}

DrawTimes SceneRenderer::draw_times() const {
    return impl_->pass_times.latest();
}

}  // namespace weft::render
