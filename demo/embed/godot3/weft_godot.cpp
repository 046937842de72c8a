// A sheet of Weft's as a class of Godot 3, by GDNative: WeftSheet, which main.gd steps and draws.

#include <weft/weft.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <span>

#include "gdnative.h"

namespace {

using gdnative::Variant;

std::optional<gdnative::Functions> godot;
const gdnative::NativeScript* nativescript = nullptr;

constexpr std::uint32_t side = 32;

/// A sheet of 1 m by 1 m that hangs by its upper edge in a wind. Godot's coordinates are Weft's.
struct Sheet {
    weft::World world;
    weft::ClothId cloth;
};

std::unique_ptr<Sheet> make_sheet() {
    weft::WorldSettings settings;
    settings.wind = {.velocity = {2, 0, 1}, .gust = 0.3f};
    auto world = weft::World::create(settings);
    const auto mesh = weft::make_sheet(
        {.rows = side, .columns = side, .origin = {-0.5f, 0, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}});
    if (!world || !mesh) return nullptr;
    const auto cloth = world->add_cloth(*mesh);
    if (!cloth) return nullptr;
    for (std::uint32_t column = 0; column < side; ++column)
        if (!world->pin(*cloth, column)) return nullptr;
    return std::unique_ptr<Sheet>(new Sheet{std::move(*world), *cloth});
}

/// An array of Godot's of so many items, which `fill` gets as bytes.
template <class Fill>
Variant array(const gdnative::ArrayFunctions& of, std::size_t count, std::size_t size, const Fill& fill) {
    gdnative::Array array;
    of.make(&array);
    of.resize(&array, static_cast<int>(count));
    gdnative::WriteAccess* const access = of.write(&array);
    fill(std::span(static_cast<std::byte*>(of.data(access)), count * size));
    of.end_write(access);
    Variant variant;
    of.variant(&variant, &array);
    of.destroy(&array);
    return variant;
}

/// The vertices' places, or their normals, of three floats each.
template <weft::VertexStream weft::VertexStreams::*stream>
Variant vertices(gdnative::Object*, void*, void* instance, int, Variant**) {
    const Sheet& sheet = *static_cast<Sheet*>(instance);
    return array(godot->vectors, side * side, sizeof(weft::Vec3), [&](std::span<std::byte> bytes) {
        weft::VertexStreams streams;
        (streams.*stream).bytes = bytes;
        if (const auto written = sheet.world.write_vertices(sheet.cloth, streams); !written)
            std::fprintf(stderr, "Weft: %s\n", written.error().message.c_str());
    });
}

/// Corners of triangles, clockwise seen from the front as Godot has them.
Variant triangles(gdnative::Object*, void*, void* instance, int, Variant**) {
    const Sheet& sheet = *static_cast<Sheet*>(instance);
    const auto corners = sheet.world.cloth(sheet.cloth)->vertex_triangles;
    return array(godot->ints, 3 * corners.size(), sizeof(std::int32_t), [&](std::span<std::byte> bytes) {
        auto* to = reinterpret_cast<std::int32_t*>(bytes.data());
        for (const weft::Triangle& t : corners)
            for (const std::size_t k : {0, 2, 1}) *to++ = static_cast<std::int32_t>(t[k]);
    });
}

Variant step(gdnative::Object*, void*, void* instance, int count, Variant** arguments) {
    if (count == 1)
        static_cast<Sheet*>(instance)->world.step(static_cast<float>(godot->as_real(arguments[0])));
    Variant nil;
    godot->new_nil(&nil);
    return nil;
}

void* create(gdnative::Object*, void*) {
    return make_sheet().release();
}
void destroy(gdnative::Object*, void*, void* instance) {
    delete static_cast<Sheet*>(instance);
}

}  // namespace

extern "C" {

void godot_gdnative_init(gdnative::InitOptions* options) {
    const gdnative::Core& core = *options->core;
    godot.emplace(core);
    for (unsigned k = 0; k < core.extension_count; ++k)
        if (core.extensions[k]->type == gdnative::type_of_nativescript)
            nativescript = reinterpret_cast<const gdnative::NativeScript*>(core.extensions[k]);
}

void godot_gdnative_terminate(void*) {
    godot.reset();
    nativescript = nullptr;
}

void godot_nativescript_init(void* handle) {
    const auto method = [&](const char* name, auto* call) {
        nativescript->register_method(handle, "WeftSheet", name, {}, {call, nullptr, nullptr});
    };
    nativescript->register_class(handle, "WeftSheet", "Reference", {create, nullptr, nullptr},
                                 {destroy, nullptr, nullptr});
    method("step", step);
    method("positions", vertices<&weft::VertexStreams::positions>);
    method("normals", vertices<&weft::VertexStreams::normals>);
    method("triangles", triangles);
}
}
