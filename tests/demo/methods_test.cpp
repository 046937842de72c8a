// The table of methods: complete, and all in it can be had.

#include "demo/options/method_table.h"

#include <gtest/gtest.h>
#include <imgui.h>

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

}  // namespace
}  // namespace weft::demo
