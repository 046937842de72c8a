#pragma once
// Reads the arguments of a recorded call.

#include <cstdint>
#include <cstring>
#include <deque>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "cloth/record/record_format.h"

namespace weft {

/// Map from recorded ids to ids in the World that replays.
class ReplayedIds {
  public:
    template <class Id>
    void add(Id recorded, Id here) {
        std::get<Of<Id>>(all_)[key(recorded)] = here;
    }
    /// The id in the World that replays; null: there is none.
    template <class Id>
    [[nodiscard]] Id find(Id recorded) const {
        const auto& ids = std::get<Of<Id>>(all_);
        const auto found = ids.find(key(recorded));
        return found == ids.end() ? Id{} : found->second;
    }

  private:
    template <class Id>
    using Of = std::unordered_map<std::uint64_t, Id>;
    // The maps differ in their value type, by which std::get finds them.
    std::tuple<Of<ClothId>, Of<ShapeId>, Of<ColliderId>, Of<BodyId>, Of<SeamId>> all_;

    template <class Id>
    [[nodiscard]] static std::uint64_t key(Id id) {
        return std::uint64_t{id.index} << 32 | id.generation;
    }
};

/// Reads values one behind the other. Past the end values are those by default, and ok() is false from then
/// on. Lists live as long as the reader.
class RecordReader {
  public:
    RecordReader(std::span<const std::byte> bytes, const ReplayedIds& ids) : left_(bytes), ids_(ids) {}

    [[nodiscard]] bool ok() const { return ok_; }
    /// Whether all bytes were read, without error.
    [[nodiscard]] bool is_done() const { return ok_ && left_.empty(); }

    void get(bool& value) { value = get_plain<std::uint32_t>() != 0; }
    template <Plain T>
    void get(T& value) {
        value = get_plain<T>();
    }
    template <IdOfWorld Id>
    void get(Id& id) {
        id = {get_plain<std::uint32_t>(), get_plain<std::uint32_t>()};
        if (id == Id{}) return;
        id = ids_.find(id);
        if (id == Id{}) ok_ = false;
    }
    template <class T>
    void get(std::span<const T>& list) {
        list = keep(get_list<T>());
    }
    template <HasFields T, std::size_t count>
    void get(std::array<T, count>& values) {
        for (T& each : values) get(each);
    }
    template <HasFields T>
    void get(T& value) {
        for_each_field(value, [&](const char*, auto& field) { get(field); });
    }
    template <class... Kinds>
    void get(std::variant<Kinds...>& value) {
        const auto index = get_plain<std::uint32_t>();
        std::uint32_t number = 0;
        const bool is_one = ((number++ == index && (get(value.template emplace<Kinds>()), true)) || ...);
        ok_ = ok_ && is_one;
    }
    void get(Mesh& mesh) {
        mesh.positions = get_list<Vec3>();
        mesh.triangles = get_list<Triangle>();
        mesh.pattern = get_list<Vec2>();
        mesh.texcoords = get_list<Vec2>();
        get(mesh.rows);
        get(mesh.columns);
        mesh.welds = get_list<std::uint32_t>();
    }
    void get(TriangleMesh& mesh) {
        get(mesh.vertices);
        get(mesh.triangles);
        get(mesh.closed);
    }
    void get(ConvexHull& hull) { get(hull.points); }
    void get(HeightField& field) {
        get(field.rows);
        get(field.columns);
        get(field.spacing);
        get(field.heights);
    }
    void get(DistanceField& field) {
        get(field.mesh);
        get(field.cell);
    }

    template <class T>
    [[nodiscard]] T get() {
        T value{};
        get(value);
        return value;
    }
    /// An id as it was recorded, not translated.
    template <IdOfWorld Id>
    [[nodiscard]] Id get_recorded() {
        const auto index = get_plain<std::uint32_t>();
        return {index, get_plain<std::uint32_t>()};
    }

  private:
    template <class T>
    T get_plain() {
        T value{};
        if (left_.size() < sizeof value) {
            ok_ = false;
            left_ = {};
            return value;
        }
        std::memcpy(&value, left_.data(), sizeof value);
        left_ = left_.subspan(sizeof value);
        return value;
    }
    template <class T>
    std::vector<T> get_list() {
        const auto count = get_plain<std::uint64_t>();
        if (count > left_.size() / sizeof(T)) {
            ok_ = false;
            return {};
        }
        std::vector<T> list(count);
        if (count > 0) std::memcpy(list.data(), left_.data(), count * sizeof(T));
        left_ = left_.subspan(count * sizeof(T));
        return list;
    }
    template <class T>
    std::span<const T> keep(std::vector<T>&& list) {
        return std::get<std::deque<std::vector<T>>>(kept_).emplace_back(std::move(list));
    }

    template <class... T>
    using Lists = std::tuple<std::deque<std::vector<T>>...>;

    std::span<const std::byte> left_;
    const ReplayedIds& ids_;
    Lists<std::uint32_t, float, std::byte, Vec3, Triangle, HashOfCloth, RungOfCloth> kept_;
    bool ok_ = true;
};

}  // namespace weft
