// A host in C beside one in C++.

#include <gtest/gtest.h>
#include <weft/weft.h>
#include <weft/weft_c.h>

#include <unistd.h>

#include <filesystem>
#include <string>

#include "host.h"

namespace weft::test {
namespace {

constexpr int steps = 10;

std::uint64_t hash_in_cpp() {
    World world = World::create({.wind = {.velocity = {4, 0, 1}, .gust = 0.3f}}).value();
    const Mesh mesh = make_sheet({.rows = 16, .columns = 10, .origin = {0, 1, 0}}).value();
    const ClothId cloth =
        world.add_cloth(mesh, {.fabric = Fabric::named("silk").value(), .friction = 0.5f}).value();
    EXPECT_TRUE(world.pin(cloth, 3).ok());
    EXPECT_TRUE(world.add_collider({.shape = Capsule{{0, 0.8f, 0}, {1, 0.8f, 1}, 0.1f}}).ok());
    for (int step = 0; step < steps; ++step) world.step(1.0f / 60);
    return world.state_hash();
}

std::uint64_t hash_in_c() {
    WeftWorldSettings air;
    weft_world_settings_init(&air, sizeof air);
    air.wind.velocity = {4, 0, 1};
    air.wind.gust = 0.3f;
    WeftWorld* world = nullptr;
    EXPECT_EQ(weft_world_create(&air, &world), WEFT_OK);
    WeftSheetSettings sheet;
    weft_sheet_settings_init(&sheet, sizeof sheet);
    sheet.rows = 16;
    sheet.columns = 10;
    sheet.origin = {0, 1, 0};
    WeftMesh* mesh = nullptr;
    EXPECT_EQ(weft_mesh_make_sheet(&sheet, &mesh), WEFT_OK);
    WeftClothSettings settings;
    weft_cloth_settings_init(&settings, sizeof settings);
    EXPECT_EQ(weft_fabric_named("silk", &settings.fabric), WEFT_OK);
    settings.friction = 0.5f;
    WeftClothId cloth;
    EXPECT_EQ(weft_world_add_cloth(world, mesh, &settings, &cloth), WEFT_OK);
    const std::uint32_t corner = 3;
    EXPECT_EQ(weft_world_pin(world, cloth, &corner, 1), WEFT_OK);
    WeftCollider limb;
    weft_collider_init(&limb, sizeof limb, WEFT_CAPSULE);
    limb.a = {0, 0.8f, 0};
    limb.b = {1, 0.8f, 1};
    WeftColliderId id;
    EXPECT_EQ(weft_world_add_collider(world, &limb, &id), WEFT_OK);
    for (int step = 0; step < steps; ++step) EXPECT_EQ(weft_world_step(world, 1.0f / 60), WEFT_OK);
    const std::uint64_t hash = weft_world_state_hash(world);
    weft_mesh_destroy(mesh);
    weft_world_destroy(world);
    return hash;
}

TEST(HostInC, MakesTheSameBytes) {
    EXPECT_EQ(hash_in_c(), hash_in_cpp());
}

#ifndef __wasi__  // which has no files to load meshes from
TEST(HostInC, CallsAllThatThereIs) {
    const auto folder = std::filesystem::temp_directory_path() / ("weft_c_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::uint64_t hash = hash_of_host_in_c(folder.c_str());
    EXPECT_EQ(hash_of_host_in_c(folder.c_str()), hash);
    std::filesystem::remove_all(folder);
}
#endif

}  // namespace
}  // namespace weft::test
