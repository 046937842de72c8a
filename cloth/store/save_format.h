#pragma once
// How a save is laid out: a head, the World's own part, then a head and a part for each shape and for each
// cloth, in the order of their ids. Little-endian, without padding; the parts are as for_each_part() visits
// them.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "cloth/state/state.h"
#include "collision/shapes/held_shape.h"

namespace weft {

static_assert(std::endian::native == std::endian::little, "saves are copied as they lie in memory");

/// Raised with each change of the format behind the head.
inline constexpr std::uint32_t save_version = 13;
inline constexpr std::array<char, 8> save_mark = {'W', 'E', 'F', 'T', 'S', 'A', 'V', 'E'};
/// Mark of a save of one cloth: a head, and the cloth's head and part.
inline constexpr std::array<char, 8> cloth_mark = {'W', 'E', 'F', 'T', 'C', 'L', 'T', 'H'};

struct SaveHead {
    std::array<char, 8> mark = save_mark;
    std::uint32_t version = save_version;
    std::uint32_t cloths = 0;
    std::uint32_t colliders = 0;
    std::uint32_t bodies = 0;
    std::uint32_t attached = 0;  ///< number of attached colliders and vertices, see attached_of()
    std::uint32_t kinds = 0;     ///< hash of the kinds of the colliders' shapes, see kinds_of()
    std::uint32_t shapes = 0;
    std::uint32_t deformable = 0;  ///< vertices of all shapes
    std::uint32_t seams = 0;
    std::uint32_t sewn = 0;           ///< hash of what the seams join, see sewn_of()
    std::uint64_t garments = 0;       ///< of several meshes
    std::uint64_t before_cloths = 0;  ///< bytes between this head and that of the first cloth
    std::uint64_t bytes = 0;          ///< of the whole save
    std::uint64_t hash = 0;           ///< of all behind the head
};
static_assert(std::has_unique_object_representations_v<SaveHead>);

/// Sizes of a shape's deformation: 0, or all of its vertices.
struct ShapeHead {
    std::uint32_t vertices = 0, displacements = 0;

    ShapeHead() = default;
    explicit ShapeHead(const HeldShape& shape) {
        const HeldShape::Deformation deformation = shape.deformation();
        vertices = static_cast<std::uint32_t>(deformation.vertices.size());
        displacements = static_cast<std::uint32_t>(deformation.displacements.size());
    }
};
static_assert(std::has_unique_object_representations_v<ShapeHead>);

/// A visitor that counts the bytes of spans.
class SaveSize {
  public:
    template <class T, std::size_t extent>
    void operator()(std::span<T, extent> part) const {
        bytes_ += part.size_bytes();
    }
    template <class Head>
    void head(const Head& head) const {
        bytes_ += sizeof head;
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    mutable std::size_t bytes_ = 0;
};

/// Sizes of a cloth's state, in items. Pins and frame may differ from the cloth here; the rest may not.
struct ClothHead {
    std::uint32_t pins = 0;
    std::uint32_t particles = 0;
    std::uint32_t record = 0;   ///< particles in BDF2's record
    std::uint32_t held = 0;     ///< particles with collider contact
    std::uint32_t tangles = 0;  ///< particles with tangle memory
    std::uint32_t rest = 0;     ///< 1: the cloth may fall asleep
    std::uint32_t skin = 0;     ///< places and normals
    std::uint32_t detail = 0;   ///< particles with a budget
    std::uint32_t frame = 0;    ///< 1: the cloth is in a reference frame
    std::uint32_t mesh = 0;     ///< ClothModel::fingerprint
    std::uint64_t key = 0;      ///< ClothSettings::key
    std::uint64_t bytes = 0;    ///< of the part that follows

    ClothHead() = default;
    ClothHead(const ClothState& state, std::uint32_t fingerprint, std::uint64_t of_host)
        : pins(static_cast<std::uint32_t>(state.pins.size())),
          particles(state.size()),
          record(static_cast<std::uint32_t>(state.record.displacements.size())),
          held(static_cast<std::uint32_t>(state.held.normals.size())),
          tangles(static_cast<std::uint32_t>(state.tangles.size())),
          rest(state.rest ? 1 : 0),
          skin(static_cast<std::uint32_t>(state.skin.places.size() + state.skin.normals.size())),
          detail(static_cast<std::uint32_t>(state.ahead.size())),
          frame(state.frame ? 1 : 0),
          mesh(fingerprint),
          key(of_host) {
        SaveSize size;
        for_each_part(state, size);
        bytes = size.bytes();
    }

    /// Offset of the pins: for_each_part() visits positions, previous positions, velocities, normals before.
    [[nodiscard]] std::size_t bytes_before_pins() const { return 4 * sizeof(Vec4) * particles; }
};
static_assert(std::has_unique_object_representations_v<ClothHead>);

/// A visitor that writes spans one behind the other.
class SaveWriter {
  public:
    explicit SaveWriter(std::byte* to) : to_(to) {}
    template <class T, std::size_t extent>
    void operator()(std::span<T, extent> part) const {
        if (part.empty()) return;
        std::memcpy(to_, part.data(), part.size_bytes());
        to_ += part.size_bytes();
    }
    template <class Head>
    void head(const Head& head) const {
        (*this)(std::span(&head, 1));
    }

  private:
    mutable std::byte* to_;
};

/// A visitor that fills spans one behind the other. Precondition: as many bytes are left.
class SaveReader {
  public:
    explicit SaveReader(std::span<const std::byte> from)
        : from_(from.data()), end_(from.data() + from.size()) {}
    template <class T, std::size_t extent>
    void operator()(std::span<T, extent> part) const {
        if (part.empty()) return;
        std::memcpy(part.data(), from_, part.size_bytes());
        from_ += part.size_bytes();
    }
    [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - from_); }
    /// A reader that begins so many bytes farther on.
    [[nodiscard]] SaveReader after(std::size_t bytes) const { return SaveReader({from_ + bytes, end_}); }
    void skip(std::size_t bytes) const { from_ += bytes; }

  private:
    mutable const std::byte* from_;
    const std::byte* end_;
};

}  // namespace weft
