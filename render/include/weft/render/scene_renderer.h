#pragma once
// Draws cloth and solids, with sky, ground, soft shadows and multisampling.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "weft/error.h"
#include "weft/render/camera.h"
#include "weft/types.h"

namespace weft::render {

/// The pattern of a fabric's threads. Plain: over and under in turn; twill: over two and under two, in
/// slanting ribs; knit: loops; none: no threads are drawn.
enum class Threads : std::uint8_t { plain, twill, knit, none };

/// A fabric's look. Colours are linear RGB in [0, 1].
struct FabricLook {
    Vec3 front{0.55f, 0.08f, 0.10f};
    Vec3 back{0.45f, 0.09f, 0.11f};
    float roughness = 0.75f;  ///< 0 silk, 1 felt
    float sheen = 0.5f;       ///< strength of the light rim at grazing angles
    Threads threads = Threads::plain;
    float thread_width = 0.45f;  ///< spacing of threads [mm of texture coordinate]; 0 draws none
    float shine = 0;             ///< strength of the highlight across threads; satin 1
    float shine_width = 0.25f;   ///< width of that highlight, from 0.02 (a line) to 1
    float stripe_width = 0;      ///< width of a stripe [m of texture coordinate u]; 0 draws none
    Vec3 stripe{0.9f, 0.88f, 0.82f};
    /// Below 1 what is behind shows through, and the cloth casts no shadow: for ghosts that show another
    /// state.
    float opacity = 1;
    float translucency = 0.35f;  ///< share of the sun's light that shines through; 0 leather, 0.5 chiffon
};

/// An 8-bit RGB picture, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The colours of some of a cloth's triangles, in place of those of its look.
struct ClothPart {
    Vec3 front, back;  ///< linear RGB in [0, 1]
    /// A picture in sRGB that multiplies both colours and repeats; texture coordinate (0, 0) is its lower
    /// left corner. Null: none.
    std::shared_ptr<const Image> picture{};
};

/// The parts of a cloth's mesh that do not move: uploaded once.
struct ClothSurface {
    std::span<const std::array<std::uint32_t, 3>> triangles;  ///< vertex indices
    std::span<const std::uint32_t> vertex_to_particle;        ///< one per vertex
    std::span<const Vec2> texcoords;                          ///< one per vertex [m], or empty
    FabricLook look;
    std::span<const ClothPart> parts{};                 ///< empty: all triangles have the look's colours
    std::span<const std::uint32_t> part_of_triangle{};  ///< indices into `parts`, one per triangle, or empty
};

/// The parts of a cloth's mesh that move, streamed from the simulation's own buffers. The first three spans
/// have one element of sixteen bytes per particle.
struct ClothFrame {
    std::span<const Vec4> positions;
    std::span<const Vec4> previous_positions;
    std::span<const Vec4> normals;
    /// Colours that show a quantity of the cloth, one per particle or none. xyz: linear RGB; w: weight
    /// against the fabric's own colour, 0 to 1.
    std::span<const Vec4> colours{};
};

/// A handle of a cloth in a SceneRenderer; 0 is null.
using ClothHandle = std::uint32_t;

struct DrawnSphere {
    Vec3 center;
    float radius;
    Vec3 color{0.75f, 0.72f, 0.68f};
};
struct DrawnCapsule {
    Vec3 a, b;
    float radius;
    Vec3 color{0.75f, 0.72f, 0.68f};
};
/// A capsule whose radius changes linearly from one end to the other.
struct DrawnTaperedCapsule {
    Vec3 a, b;
    float radius_a, radius_b;
    Vec3 color{0.75f, 0.72f, 0.68f};
};
struct DrawnBox {
    Vec3 center;
    Vec3 x, y, z;  ///< half axes: from the centre to the middle of a face [m]
    Vec3 color{0.75f, 0.72f, 0.68f};
};

/// A straight line, one pixel wide, hidden by nearer surfaces.
struct DrawnLine {
    Vec3 from, to;  ///< [m]
    Vec3 color;
    float opacity = 1;  ///< 0 to 1
};

/// Settings that trade a picture's quality for its cost. The defaults are full quality; a value out of
/// range is clamped.
struct Quality {
    int samples = 4;       ///< samples per pixel (multisampling), 1 to 4
    int sun_map = 2048;    ///< texels on a side of the sun's depth map, 64 to 4096
    int sky_map = 512;     ///< texels on a side of the depth map seen from above, 64 to 4096
    int blocker_taps = 8;  ///< samples that find the width of the shadow's edge, 0 to 16; 0: sharp
    int sun_taps = 16;     ///< samples of the shadow's edge, 1 to 32
    int sky_taps = 12;     ///< samples of the ambient occlusion, 0 to 32; 0: none
    bool weave = true;     ///< threads and the shine along them
    float resolution = 1;  ///< drawn pixels per shown pixel along each side, 0.25 to 1
    friend bool operator==(const Quality&, const Quality&) = default;
};

/// Durations of the parts of a picture, from OpenGL's timestamps [ms].
struct DrawTimes {
    float shadows = 0;  ///< both depth maps
    float scene = 0;    ///< solids, cloth, ground, sky and lines
    float display = 0;  ///< conversion to sRGB, into the target
    [[nodiscard]] float total() const { return shadows + scene + display; }
};

/// The description of one image.
struct View {
    OrbitCamera camera;
    float alpha = 1;  ///< blend of previous and current positions, in [0, 1]
    bool ground = true;
    float ground_height = 0;                  ///< [m]
    Vec3 sun_direction{-0.5f, 0.75f, 0.45f};  ///< towards the sun, need not be unit
    bool wireframe = false;
    Quality quality{};
    std::span<const DrawnSphere> spheres;
    std::span<const DrawnCapsule> capsules;
    std::span<const DrawnTaperedCapsule> tapered_capsules;
    std::span<const DrawnBox> boxes;
    std::span<const DrawnLine> lines;
    Vec3 wind{0, 0, 0};  ///< drawn as an arrow on the ground where not zero [m/s]
};

/// The host's OpenGL 3.3 state changes no picture, and every call restores it, except for the target of
/// draw(). Transform feedback and conditional rendering must not be active.
class SceneRenderer {
  public:
    /// Precondition: a Context is current, here and at every call. Error: a shader does not compile; the
    /// message holds the log.
    [[nodiscard]] static Result<SceneRenderer> create();
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    /// The surface's spans need not outlive the call. A cloth is drawn from its first update_cloth() on.
    ClothHandle add_cloth(const ClothSurface& surface);
    // These three ignore a handle that is null or removed.
    void remove_cloth(ClothHandle cloth);
    void update_cloth(ClothHandle cloth, const ClothFrame& frame);
    void set_look(ClothHandle cloth, const FabricLook& look);

    /// Draws into framebuffer `target` (0: the window) of the given size in pixels, and leaves it bound with
    /// its viewport set, so that panels can be drawn on top. A size of 0 (an iconified window) draws nothing.
    void draw(const View& view, int width, int height, unsigned target = 0);
    /// Draws into an image of its own and reads it back. `overlay` draws on top of the scene first.
    /// Precondition: width and height are from 1 to 16384.
    [[nodiscard]] Image capture(const View& view, int width, int height,
                                const std::function<void()>& overlay = nullptr);
    /// True if a processor draws, and not a graphics card.
    [[nodiscard]] bool drawn_by_processor() const;
    /// Waits until the driver has finished all drawing.
    void wait() const;
    /// Times of a picture some frames ago: the driver works asynchronously and is not waited for. Zeros until
    /// the first result.
    [[nodiscard]] DrawTimes draw_times() const;

  private:
    struct Impl;
    explicit SceneRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Error: the file cannot be written; the message names it.
[[nodiscard]] Result<void> save_png(const Image& image, const char* file);

}  // namespace weft::render
