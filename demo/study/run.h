#pragma once
// The study's scenes, and one cloth stepped by one method, and timed.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "demo/study/method_list.h"
#include "weft/mesh.h"

namespace weft::study {

/// A simulation without its method: made once, so that every method starts from the same floats.
struct StudyScene {
    std::string name;            ///< "hanging"
    std::uint32_t per_side = 0;  ///< 0: not a sheet
    Mesh mesh;
    ClothSettings cloth;  ///< fabric and air; the method is the point's
    WorldSettings world;
    std::vector<std::uint32_t> pins;     ///< vertices of the mesh
    std::vector<Vec4> start_positions;   ///< of the particles [m]; empty: the mesh's own
    std::vector<Vec4> start_velocities;  ///< [m/s]; empty: at rest
    float frame = 1.0f / 60;             ///< [s]
};

class Run {
  public:
    /// Throws std::runtime_error if the mesh cannot be cooked, std::logic_error if the method is not there.
    Run(const StudyScene& scene, const MethodPoint& point, int threads);

    /// Returns to the start of a scene of the same mesh and pins.
    void restart(const StudyScene& scene);
    /// One frame. Returns its milliseconds: of one thread by the processor, of several by the clock.
    double step();

    [[nodiscard]] const Cloth& cloth() const { return *cloth_; }
    [[nodiscard]] const StepReport& report() const { return simulation_.report; }
    /// Frames after which the state had to be restored, since it was no longer finite.
    [[nodiscard]] int restored_frames() const { return restored_; }

  private:
    float frame_;
    Simulation simulation_;
    Cloth* cloth_ = nullptr;
    int restored_ = 0;
};

/// Positions of all particles [m].
using Positions = std::vector<Eigen::Vector3d>;
[[nodiscard]] Positions positions_of(const Cloth& cloth);

/// kappa = stiffness frame^2 / mean mass of a particle: how hard one step of the frame's length is.
[[nodiscard]] double kappa(const Cloth& cloth, double frame);

/// A sheet of 1 m and 0.2 kg/m^2 hung by two corners of one side, horizontal but for a bump of 0.1 mm that
/// has no symmetry, so that the scene and not rounding decides how the sheet buckles. `wind`: in a steady
/// breeze; otherwise in still air that takes 0.2 of the velocity per second.
[[nodiscard]] StudyScene hung_sheet(std::uint32_t per_side, bool wind);

/// A garment of a file, hung by its highest opening in still air.
[[nodiscard]] StudyScene hung_garment(const std::filesystem::path& obj, const std::string& name);

}  // namespace weft::study
