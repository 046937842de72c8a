#pragma once
// Bullet's btSoftBody in the scenes of peers.cpp: a sheet of 1 m and 0.2 kg, hung by two corners or falling
// on a sphere.

#include <cstdint>
#include <memory>

namespace weft::bench {

class BulletSheet {
  public:
    /// Warmed up for as long as Scene.
    BulletSheet(std::uint32_t side, bool on_sphere);
    ~BulletSheet();
    void frame();

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace weft::bench
