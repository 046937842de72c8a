#pragma once
// Draws cloth and the shapes it meets: sky, ground, soft shadow, two-sided fabric, 4x multisampling.

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

/// How threads lie: over and under each other in turn; over two and under two, in slanting ribs; loops; not
/// at all.
enum class Threads : std::uint8_t { plain, twill, knit, none };

/// A fabric's look. Colours are linear RGB in [0, 1].
struct FabricLook {
    Vec3 front{0.55f, 0.08f, 0.10f};
    Vec3 back{0.45f, 0.09f, 0.11f};
    float roughness = 0.75f;  ///< 0 silk, 1 felt
    float sheen = 0.5f;       ///< strength of the light fibre edge
    Threads threads = Threads::plain;
    float thread_width = 0.45f;  ///< from thread to thread [mm] of texture coordinate; 0 draws none
    float shine = 0;             ///< strength of the light that threads reflect across themselves: satin 1
    float shine_width = 0.25f;   ///< of it, 0.02 a line to 1
    float stripe_width = 0;      ///< [m] of texture coordinate u; 0 draws none
    Vec3 stripe{0.9f, 0.88f, 0.82f};
    float translucency = 0.35f;  ///< share of the sun's light that shines through; 0 leather, 0.5 chiffon
};

/// The parts of a cloth's mesh that do not move: uploaded once.
struct ClothSurface {
    std::span<const std::array<std::uint32_t, 3>> triangles;  ///< vertex indices
    std::span<const std::uint32_t> vertex_to_particle;        ///< one per vertex
    std::span<const Vec2> texcoords;                          ///< one per vertex [m], or empty
    FabricLook look;
};

/// The parts that move: streamed from the simulation's own buffers, one element of sixteen bytes a particle.
/// The first three have one element per particle.
struct ClothFrame {
    std::span<const Vec4> positions;
    std::span<const Vec4> previous_positions;
    std::span<const Vec4> normals;
    /// Of what somebody wants to see of the cloth: linear RGB, w how much of it in place of the fabric's own
    /// colour. One per particle, or none.
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
/// The radius goes evenly from one end to the other.
struct DrawnTaperedCapsule {
    Vec3 a, b;
    float radius_a, radius_b;
    Vec3 color{0.75f, 0.72f, 0.68f};
};
struct DrawnBox {
    Vec3 center;
    Vec3 x, y, z;  ///< from there to the middle of a face, along each of its axes
    Vec3 color{0.75f, 0.72f, 0.68f};
};

/// A straight line, one pixel wide, hidden by what is before it.
struct DrawnLine {
    Vec3 from, to;  ///< [m]
    Vec3 color;
    float opacity = 1;  ///< 0 to 1
};

/// What a picture costs and how good it is. The defaults are the best; what is out of range counts as the
/// nearest that is in it.
struct Quality {
    int samples = 4;       ///< of each pixel at edges, 1 to 4
    int sun_map = 2048;    ///< texels on a side of the sun's depth map, 64 to 4096
    int sky_map = 512;     ///< likewise of the one seen from above
    int blocker_taps = 8;  ///< with which the width of the shadow's edge is found, 0 to 16; 0: it is sharp
    int sun_taps = 16;     ///< of the shadow's edge, 1 to 32
    int sky_taps = 12;     ///< of the darkness in folds and below things, 0 to 32; 0: there is none
    bool weave = true;     ///< threads and the shine along them
    float resolution = 1;  ///< pixels drawn over those shown, along each side, 0.25 to 1
    friend bool operator==(const Quality&, const Quality&) = default;
};

/// What the parts of a picture took, on whatever draws it [ms].
struct DrawTimes {
    float shadows = 0;  ///< both depth maps
    float scene = 0;    ///< what is seen
    float display = 0;  ///< film's response and the way to the window
    [[nodiscard]] float total() const { return shadows + scene + display; }
};

/// One image.
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

/// An 8-bit RGB picture, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// What a host has set in OpenGL 3.3 changes no picture, and every call leaves it as it was, but for the
/// target of draw(). Transform feedback and conditional rendering must not be under way.
class SceneRenderer {
  public:
    /// Precondition: a Context is current, here and at every call. Error: a shader that does not compile (the
    /// log).
    [[nodiscard]] static Result<SceneRenderer> create();
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    /// The surface's spans need not outlive the call. A cloth is drawn from its first update_cloth() on.
    ClothHandle add_cloth(const ClothSurface& surface);
    // A handle that is null or removed is ignored by these three.
    void remove_cloth(ClothHandle cloth);
    void update_cloth(ClothHandle cloth, const ClothFrame& frame);
    void set_look(ClothHandle cloth, const FabricLook& look);

    /// Draws into framebuffer `target` (0: the window) of the given size in pixels, and leaves it bound with
    /// its viewport set, so that panels can be drawn on top. A size of 0 (an iconified window) draws nothing.
    void draw(const View& view, int width, int height, unsigned target = 0);
    /// Draws into an image of its own and reads it back. `overlay` draws on top of the scene before that.
    /// Precondition: width and height are from 1 to 16384.
    [[nodiscard]] Image capture(const View& view, int width, int height,
                                const std::function<void()>& overlay = nullptr);
    /// Whether a processor draws, and not a graphics card.
    [[nodiscard]] bool drawn_by_processor() const;
    /// Waits until all that was drawn is there.
    void wait() const;
    /// Of a picture some frames ago: the driver draws behind, and is not waited for. Zeros before.
    [[nodiscard]] DrawTimes draw_times() const;

  private:
    struct Impl;
    explicit SceneRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Error: the file cannot be written; the message names it.
[[nodiscard]] Result<void> save_png(const Image& image, const char* file);

}  // namespace weft::render
