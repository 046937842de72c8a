#include "engine/memory/aligned_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>

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

TEST(AlignedBuffer, CopiesShareNothing) {
    for (const std::size_t size : {0u, 1u, 16u, 37u}) {
        AlignedBuffer<int> from(size);
        std::iota(from.span().begin(), from.span().end(), 1);
        AlignedBuffer<int> copy = from;
        ASSERT_EQ(copy.size(), size);
        EXPECT_TRUE(std::ranges::equal(copy.span(), from.span()));
        EXPECT_EQ(copy.bytes(), from.bytes());
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % 64, 0u);
        for (int& x : copy.span()) x = -1;
        EXPECT_EQ(std::ranges::count(from.span(), -1), 0);
        EXPECT_EQ(std::count(copy.data() + size, copy.data() + copy.bytes() / sizeof(int), 0),
                  static_cast<std::ptrdiff_t>(copy.bytes() / sizeof(int) - size))
            << "what fills the last group";
    }
}

TEST(AlignedBuffer, IsAssignedAnySize) {
    for (const std::size_t before : {0u, 5u, 37u}) {
        for (const std::size_t after : {0u, 5u, 36u, 1000u}) {
            AlignedBuffer<int> from(after), to(before);
            std::iota(from.span().begin(), from.span().end(), 1);
            const int* const memory = to.data();
            to = from;
            EXPECT_TRUE(std::ranges::equal(to.span(), from.span())) << before << " to " << after;
            EXPECT_EQ(to.data() == memory, before == after) << "memory is kept where the size is";
        }
    }
}

TEST(AlignedBuffer, MayBeAssignedToItself) {
    AlignedBuffer<int> buffer(5);
    buffer[4] = 7;
    AlignedBuffer<int>& same = buffer;
    buffer = same;
    ASSERT_EQ(buffer.size(), 5u);
    EXPECT_EQ(buffer[4], 7);
    buffer = std::move(same);
    ASSERT_EQ(buffer.size(), 5u);
    EXPECT_EQ(buffer[4], 7);
}

TEST(AlignedBuffer, ThatIsUnmadeHasCopiesOfZeros) {
    const AlignedBuffer<int> later(21, unmade);
    EXPECT_EQ(later.size(), 21u);
    EXPECT_EQ(later.data(), nullptr);
    EXPECT_EQ(later.bytes(), 32 * sizeof(int));
    AlignedBuffer<int> full(21);
    full[20] = 5;
    const AlignedBuffer<int> copy = later;
    AlignedBuffer<int> assigned = full;
    assigned = later;
    for (const auto* made : {&copy, &std::as_const(assigned)}) {
        ASSERT_EQ(made->size(), 21u);
        for (std::size_t i = 0; i < 32; ++i) EXPECT_EQ(made->data()[i], 0);
    }
    AlignedBuffer<int> becomes(21, unmade);
    becomes = full;
    EXPECT_EQ(becomes[20], 5);
    EXPECT_EQ(AlignedBuffer<int>(AlignedBuffer<int>(0, unmade)).size(), 0u);
}

#ifdef __cpp_exceptions
// Sizes whose bytes, or whose whole groups, are more than a size_t holds must not become small ones.
TEST(AlignedBuffer, OfMoreThanThereCanBeIsRefused) {
    constexpr std::size_t largest = std::numeric_limits<std::size_t>::max();
    for (const std::size_t size : {largest, largest - 14, largest / 16 + 1, largest / 16 + 2, largest / 32})
        EXPECT_THROW(AlignedBuffer<Vec4>{size}, std::bad_alloc) << size;
    EXPECT_THROW(AlignedBuffer<char>{largest}, std::bad_alloc);
    EXPECT_THROW(AlignedBuffer<char>{largest - 14}, std::bad_alloc);
}
#endif

}  // namespace
}  // namespace weft
