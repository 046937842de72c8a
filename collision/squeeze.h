#pragma once
// Cloth that bodies squeeze, so that no place is free for it (Baraff, Witkin, Kass, "Untangling cloth", 2003,
// "flypapering").

#include <array>
#include <cstdint>
#include <span>

#include "collision/collider_contacts.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// Of a particle that is nearer than the thickness to the surfaces of two colliders which leave no free place
/// within the thickness of it. It stays between them: it goes with the mean of the two, without sliding, and
/// is drawn to where it is as deep in both.
struct Squeeze {
    bool is_squeezed = false;
    Vector3 normal = Vector3::Zero();    ///< from the shallower to the deeper, of unit length
    Vector3 velocity = Vector3::Zero();  ///< the mean of their surfaces' [m/s]
    float to_middle = 0;                 ///< along the normal [m]
    float depth_before = 0;  ///< in the shallower, if it was where it is when the substep began [m]
};

/// Some of all colliders: those that can matter. With more than there is room for, all.
class SomeColliders {
  public:
    void add(std::uint32_t collider) {
        if (count_ < most) indices_[count_] = collider;
        ++count_;
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Calls use(index), in ascending order.
    template <class Use>
    void for_each(std::size_t of_all, const Use& use) const {
        const auto all = static_cast<std::uint32_t>(of_all);
        for (std::uint32_t k = 0; k < (count_ <= most ? count_ : all); ++k)
            use(count_ <= most ? indices_[k] : k);
    }

  private:
    static constexpr std::uint32_t most = 64;
    std::uint32_t count_ = 0;
    std::array<std::uint32_t, most> indices_;
};

/// Particles of a block that may be squeezed, close together in memory.
struct SqueezedParticles {
    std::uint32_t count = 0;
    std::array<std::uint32_t, block_size> indices;  ///< in the block
    std::array<bool, block_size> was;               ///< squeezed before: a way out has to be half as long
    alignas(64) std::array<Vec4, block_size> points;
    std::array<Squeeze, block_size> squeezes;

    void add(std::uint32_t index, bool was_squeezed, const Vec4& point) {
        indices[count] = index;
        was[count] = was_squeezed;
        points[count++] = point;
    }
};

/// Fills the squeezes of those that were added, for where their points are in the colliders at the end of a
/// substep of h [s].
void find_squeezes(std::span<const ColliderMotion> colliders, const SomeColliders& which,
                   const ClothSide& cloth, float h, SqueezedParticles& particles);
void find_squeezes(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                   SqueezedParticles& particles);

}  // namespace weft
