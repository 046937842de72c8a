// The table of methods: complete, and all in it can be had.

#include "demo/options/method_table.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <set>

#include "demo/panels/panels.h"
#include "small_world.h"

namespace weft::demo {
namespace {

TEST(Methods, AreFoundByNameAndByWhatTheyHold) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < all_methods().size(); ++i) {
        const NamedMethod& each = all_methods()[i];
        EXPECT_EQ(each.method.index(), i) << each.name;
        EXPECT_EQ(find_method(each.name), &each);
        EXPECT_EQ(&entry_of(each.method), &each);
        names.insert(each.name);
    }
    EXPECT_EQ(names.size(), std::variant_size_v<Method>);
    EXPECT_EQ(find_method("magic"), nullptr);
    EXPECT_EQ(find_method(""), nullptr);
}

TEST(Methods, TakeIterationsWhereTheyIterate) {
    for (const NamedMethod& each : all_methods()) {
        Method method = each.method;
        set_iterations(method, 123);
        EXPECT_EQ(method.index(), each.method.index());
        EXPECT_EQ(iterations_of(method).value_or(123), 123);
        EXPECT_EQ(iterations_of(method).has_value(), !std::holds_alternative<SymplecticEuler>(method));
    }
}

TEST(Methods, AllCanBeTakenByAClothThatMoves) {
    for (const NamedMethod& each : all_methods()) {
        SmallWorld scene;
        const ClothId id = scene.cloths.front().id;
        ASSERT_TRUE(scene.world.pin(id, 0).ok());
        ClothSettings settings = *scene.world.cloth_settings(id);
        settings.method = each.method;
        settings.substeps = 20;  // enough for the explicit one
        const Result<void> set = scene.world.set_cloth_settings(id, settings);
        ASSERT_TRUE(set.ok()) << each.name << ": " << set.error().message;
        for (int k = 0; k < 30; ++k) scene.world.step(1.0f / 60);
        EXPECT_EQ(scene.world.report().flags, StepFlags::none) << each.name;
        EXPECT_LT(scene.position(SmallWorld::vertex(10, 10)).y, -0.2f) << each.name << " falls";
    }
}

/// Dear ImGui without a window.
class MethodPanel : public testing::Test {
  protected:
    MethodPanel() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {800, 600};
        io.IniFilename = nullptr;
        io.Fonts->Build();
    }
    ~MethodPanel() override { ImGui::DestroyContext(); }
};

TEST_F(MethodPanel, ShowsEveryMethodAndChangesNothingByItself) {
    for (const NamedMethod& each : all_methods()) {
        ClothSettings settings;
        settings.method = each.method;
        settings.tethers.enabled = true;
        ImGui::NewFrame();
        ImGui::Begin("test");
        EXPECT_FALSE(method_controls(settings)) << each.name;
        ImGui::End();
        ImGui::EndFrame();
        EXPECT_EQ(settings.method.index(), each.method.index());
        EXPECT_EQ(iterations_of(settings.method), iterations_of(each.method));
    }
}

}  // namespace
}  // namespace weft::demo
