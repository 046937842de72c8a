#include "engine/memory/aligned_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>

#include "weft/types.h"

namespace weft {
namespace {

TEST(AlignedBuffer, MovesItsMemoryInsteadOfCopyingIt) {
    AlignedBuffer<int> from(5);
    from[4] = 7;
    const int* const memory = from.data();
    const AlignedBuffer<int> to = std::move(from);
    EXPECT_EQ(to.data(), memory);
    EXPECT_EQ(to[4], 7);
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
