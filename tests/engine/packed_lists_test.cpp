// Lists in bytes, used where they lie.

#include "engine/memory/packed_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace weft {
namespace {

struct Lists {
    SharedBuffer<std::uint16_t> few;
    float number = 0;
    SharedBuffer<double> none;
    std::vector<std::uint64_t> many;

    template <class Self, class Visit>
    static void visit(Self& self, Visit& visit) {
        visit(self.few);
        visit.value(self.number);
        visit(self.none);
        visit(self.many);
    }
};

Lists some_lists() {
    Lists lists{.few = SharedBuffer<std::uint16_t>(3), .number = 2.5f, .none = {}, .many = {}};
    lists.few[2] = 7;
    for (std::uint64_t i = 0; i < 100; ++i) lists.many.push_back(i * i);
    return lists;
}

struct alignas(64) Line {
    std::array<std::byte, 64> bytes;
};

std::shared_ptr<std::vector<Line>> packed(const Lists& lists) {
    PackedSize size;
    Lists::visit(lists, size);
    EXPECT_EQ(size.bytes() % 64, 0u);
    auto lines = std::make_shared<std::vector<Line>>(size.bytes() / 64);
    PackedWriter writer(std::as_writable_bytes(std::span(*lines)));
    Lists::visit(lists, writer);
    return lines;
}

TEST(PackedLists, AreReadWhereTheyLie) {
    const Lists lists = some_lists();
    const auto lines = packed(lists);
    Lists read;
    PackedReader reader(std::as_bytes(std::span(*lines)), lines);
    Lists::visit(read, reader);
    ASSERT_TRUE(reader.fits());
    EXPECT_TRUE(std::ranges::equal(read.few, lists.few));
    EXPECT_EQ(read.number, lists.number);
    EXPECT_TRUE(read.none.empty());
    EXPECT_EQ(read.many, lists.many);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(read.few.data()) % 64, 0u);
    EXPECT_EQ(read.few.data()[15], 0) << "what fills the last group";
    EXPECT_EQ(read.few.bytes(), lists.few.bytes());

    const std::uint16_t* const lent = read.few.data();
    SharedBuffer<std::uint16_t> copy = read.few;
    EXPECT_EQ(copy.bytes(), 0u);
    copy.make_own();
    copy[2] = 8;
    read.few.make_own();
    EXPECT_NE(read.few.data(), lent);
    EXPECT_EQ(read.few[2], 7);
    EXPECT_EQ(lines.use_count(), 1);
}

TEST(PackedLists, ThatAreCutOffDoNotFit) {
    const auto lines = packed(some_lists());
    const auto bytes = std::as_bytes(std::span(*lines));
    for (std::size_t size = 0; size < bytes.size(); size += 8) {
        Lists read;
        PackedReader reader(bytes.first(size), lines);
        Lists::visit(read, reader);
        EXPECT_FALSE(reader.fits()) << size << " bytes";
    }
}

TEST(PackedLists, ThatAreFilledUpWithAnythingDoNotFit) {
    const auto lines = packed(some_lists());
    const auto bytes = std::as_writable_bytes(std::span(*lines));
    for (const std::size_t at : {std::size_t{8}, std::size_t{64 + 6}, bytes.size() - 1}) {
        bytes[at] = std::byte{1};
        Lists read;
        PackedReader reader(bytes, lines);
        Lists::visit(read, reader);
        EXPECT_FALSE(reader.fits()) << "byte " << at;
        bytes[at] = {};
    }
}

TEST(PackedLists, OfCountsThatOverflowDoNotFit) {
    const auto lines = packed(some_lists());
    for (const std::uint64_t count : {~std::uint64_t{0}, std::uint64_t{1} << 63, std::uint64_t{1} << 61}) {
        std::copy_n(std::as_bytes(std::span(&count, 1)).begin(), sizeof count,
                    std::as_writable_bytes(std::span(*lines)).begin());
        Lists read;
        PackedReader reader(std::as_bytes(std::span(*lines)), lines);
        Lists::visit(read, reader);
        EXPECT_FALSE(reader.fits());
    }
}

}  // namespace
}  // namespace weft
