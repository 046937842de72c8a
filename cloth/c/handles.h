#pragma once
// Objects behind the handles of the interface for C.

#include <bit>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "cloth/c/convert.h"
#include "weft/weft_c.h"

struct WeftWorld {
    // Members that the World calls, or that its views refer to, outlive it.
    WeftExecutor executor{};
    std::unique_ptr<WeftRecordingSink> sink;  ///< sink of the last recording
    std::string description;
    std::vector<weft::Vec3> first, second;  ///< copies of inputs that are not contiguous
    std::vector<float> values;
    std::optional<weft::World> world;
};
struct WeftMesh {
    weft::Mesh mesh;
    std::vector<std::uint32_t> from{};  ///< MeshCut::from, of a mesh that was cut
    std::uint32_t added_particles = 0;  ///< MeshCut::added_particles
};
struct WeftCutStroke {
    weft::CutStroke stroke;
    std::vector<weft::MeshEdge> edges;  ///< the last that were returned
};
struct WeftCookedCloth {
    weft::CookedCloth cooked;
};
struct WeftDrawnMesh {
    weft::DrawnMesh mesh;
};
struct WeftFixedStep {
    weft::FixedStep clock;
};

namespace weft::c {

[[nodiscard]] inline ClothId id_of(WeftClothId id) {
    return std::bit_cast<ClothId>(id);
}

/// Calls act(world), which returns a Result<void>, if neither it nor the other pointers are null.
template <class Handle, class Act>
[[nodiscard]] WeftResult on(Handle* world,
                            std::initializer_list<std::pair<const void*, const char*>> pointers,
                            const Act& act) noexcept {
    return guarded([&]() -> Result<void> {
        if (world == nullptr) return null_pointer("world");
        if (auto there = are_there(pointers); !there) return there;
        return act(*world->world);
    });
}
template <class Handle, class Act>
[[nodiscard]] WeftResult on(Handle* world, const Act& act) noexcept {
    return on(world, {}, act);
}

/// Writes an id, or another value that has the same bytes for C.
template <class C, class Of>
[[nodiscard]] Result<void> put(const Result<Of>& value, C* to) {
    if (!value) return value.error();
    *to = std::bit_cast<C>(*value);
    return {};
}

template <class Handle, class Of>
[[nodiscard]] Result<void> put_handle(Result<Of>&& made, Handle** to) {
    if (!made) return made.error();
    *to = new Handle{*std::move(made)};
    return {};
}

/// A list of Weft's as an array for C.
template <class C, class Of>
[[nodiscard]] const C* list(std::span<const Of> of, std::size_t* count) noexcept {
    static_assert(sizeof(C) == sizeof(Of) && alignof(C) <= alignof(Of));
    if (count != nullptr) *count = of.size();
    return of.empty() ? nullptr : reinterpret_cast<const C*>(of.data());
}

/// `file` is UTF-8.
[[nodiscard]] inline std::filesystem::path path_of(const char* file) {
    return reinterpret_cast<const char8_t*>(file);
}

}  // namespace weft::c
