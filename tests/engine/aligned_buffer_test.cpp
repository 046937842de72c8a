#include "engine/aligned_buffer.h"

#include <gtest/gtest.h>

#include "weft/types.h"

namespace weft {
namespace {

TEST(AlignedBuffer, StartsOnACacheLineAndHoldsDefaultValues) {
    for (const std::size_t size : {1u, 3u, 17u, 4096u}) {
        AlignedBuffer<Vec4> buffer(size);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0u);
        ASSERT_EQ(buffer.size(), size);
        const std::size_t groups = (size + 15) / 16;
        EXPECT_EQ(buffer.bytes(), groups * 16 * sizeof(Vec4)) << "whole groups of 16 elements";
        for (const Vec4& v : buffer.span()) EXPECT_TRUE(v.x == 0 && v.y == 0 && v.z == 0 && v.w == 0);
    }
}

TEST(AlignedBuffer, OfNothingIsEmpty) {
    for (const AlignedBuffer<int>& buffer : {AlignedBuffer<int>(), AlignedBuffer<int>(0)}) {
        EXPECT_EQ(buffer.data(), nullptr);
        EXPECT_TRUE(buffer.span().empty());
    }
}

TEST(AlignedBuffer, MovesItsMemoryInsteadOfCopyingIt) {
    AlignedBuffer<int> from(5);
    from[4] = 7;
    const int* const memory = from.data();
    const AlignedBuffer<int> to = std::move(from);
    EXPECT_EQ(to.data(), memory);
    EXPECT_EQ(to[4], 7);
}

TEST(AlignedBuffer, IsEmptyOnceMovedFrom) {
    AlignedBuffer<int> from(5);
    const AlignedBuffer<int> to = std::move(from);
    EXPECT_TRUE(from.span().empty());  // NOLINT(bugprone-use-after-move): what is left is the subject
}

}  // namespace
}  // namespace weft
