#pragma once
// Layout of a recording: a mark and a version, then records, each a head and the arguments of a call.
// Little-endian, without padding. A list is its length in 64 bits and its items; a variant is the number of
// its alternative in 32 bits and the value.

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "cloth/budget/ladder.h"
#include "cloth/record/call.h"
#include "cloth/settings/fields.h"
#include "engine/state_hash.h"
#include "weft/cloth_id.h"
#include "weft/maps.h"
#include "weft/mesh.h"
#include "weft/seam.h"

namespace weft {

static_assert(std::endian::native == std::endian::little, "recordings are copied as they lie in memory");

/// Raised with each change of the format below, fields.h included.
inline constexpr std::uint32_t recording_version = 10;
inline constexpr std::array<char, 8> recording_mark = {'W', 'E', 'F', 'T', 'R', 'E', 'C', 'D'};

struct RecordingHead {
    std::array<char, 8> mark = recording_mark;
    std::uint32_t version = recording_version;
    std::uint32_t unused = 0;
};
static_assert(std::has_unique_object_representations_v<RecordingHead>);

struct RecordHead {
    std::uint32_t call = 0;
    std::uint32_t number = 0;    ///< of the record, from 0 without gaps
    std::uint64_t bytes = 0;     ///< of the arguments, which follow
    std::uint64_t hash = 0;      ///< of the arguments
    std::uint64_t own_hash = 0;  ///< of all fields above

    [[nodiscard]] std::uint64_t hash_of_head(StateHash& hasher) const {
        hasher.reset();
        hasher.add(call);
        hasher.add(number);
        hasher.add(bytes);
        hasher.add(hash);
        return hasher.value();
    }
};
static_assert(std::has_unique_object_representations_v<RecordHead>);

/// Hash of a cloth's state after a step.
struct HashOfCloth {
    ClothId cloth;
    std::uint64_t hash = 0;
};
static_assert(std::has_unique_object_representations_v<HashOfCloth>);

static_assert(std::has_unique_object_representations_v<RungOfCloth>);

/// Types that are copied as they lie in memory.
template <class T>
concept Plain = std::same_as<T, Vec2> || std::same_as<T, Vec3> || std::same_as<T, Rotation> ||
                std::same_as<T, Triangle> || std::same_as<T, HashOfCloth> || std::same_as<T, RungOfCloth> ||
                std::same_as<T, std::byte> ||(std::is_arithmetic_v<T> && !std::same_as<T, bool>) ||
                std::is_enum_v<T>;

/// Ids, which a replay translates, since they differ between Worlds.
template <class T>
concept IdOfWorld = std::same_as<T, ClothId> || std::same_as<T, ShapeId> || std::same_as<T, ColliderId> ||
    std::same_as<T, BodyId> || std::same_as<T, SeamId>;

/// Writes values one behind the other.
class RecordWriter {
  public:
    void put(bool value) { put(static_cast<std::uint32_t>(value)); }
    template <class T>
    requires Plain<T> || IdOfWorld<T>
    void put(const T& value) {
        const auto bytes = std::as_bytes(std::span(&value, 1));
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    template <class T, std::size_t extent>
    requires Plain<std::remove_const_t<T>>
    void put(std::span<T, extent> list) {
        put(static_cast<std::uint64_t>(list.size()));
        const auto bytes = std::as_bytes(list);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    template <HasFields T, std::size_t count>
    void put(const std::array<T, count>& values) {
        for (const T& each : values) put(each);
    }
    template <HasFields T>
    void put(const T& value) {
        for_each_field(value, [&](const char*, const auto& field) { put(field); });
    }
    template <class... Kinds>
    void put(const std::variant<Kinds...>& value) {
        put(static_cast<std::uint32_t>(value.index()));
        std::visit([&](const auto& kind) { put(kind); }, value);
    }
    void put(const Mesh& mesh) {
        put(std::span(mesh.positions));
        put(std::span(mesh.triangles));
        put(std::span(mesh.pattern));
        put(std::span(mesh.texcoords));
        put(mesh.rows);
        put(mesh.columns);
        put(std::span(mesh.welds));
    }
    void put(const TriangleMesh& mesh) {
        put(mesh.vertices);
        put(mesh.triangles);
        put(mesh.closed);
    }
    void put(const ConvexHull& hull) { put(hull.points); }
    void put(const HeightField& field) {
        put(field.rows);
        put(field.columns);
        put(field.spacing);
        put(field.heights);
    }
    void put(const DistanceField& field) {
        put(field.mesh);
        put(field.cell);
    }

    /// Begins a record, with room for its head.
    void begin() { bytes_.assign(sizeof(RecordHead), std::byte{}); }
    /// Ends the record: returns its head and all that was put since begin().
    [[nodiscard]] std::span<const std::byte> end(Call call, std::uint32_t number, StateHash& hasher) {
        const std::span<const std::byte> given = std::span(bytes_).subspan(sizeof(RecordHead));
        hasher.reset();
        hasher.add(given);
        RecordHead head{static_cast<std::uint32_t>(call), number, given.size(), hasher.value()};
        head.own_hash = head.hash_of_head(hasher);
        std::memcpy(bytes_.data(), &head, sizeof head);
        return bytes_;
    }

  private:
    std::vector<std::byte> bytes_;
};

}  // namespace weft
