// Memory runs out while a World is recorded: its calls do not notice, and stop_recording() says so.

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "tests/guarantees/allocation_count.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

/// Takes all without memory of its own.
struct Page {
    std::array<std::byte, 1 << 14> bytes;
    std::size_t used = 0;

    RecordingSink sink() {
        return {[](void* to, std::span<const std::byte> more) {
                    Page& page = *static_cast<Page*>(to);
                    if (more.size() > page.bytes.size() - page.used) return false;
                    std::memcpy(page.bytes.data() + page.used, more.data(), more.size());
                    page.used += more.size();
                    return true;
                },
                this};
    }
};

TEST(RecordingOutOfMemory, IsSaidWhenItEndsAndHarmsNoCall) {
    const Mesh mesh = make_sheet({.rows = 4, .columns = 4}).value();
    std::uint64_t expected = 0;
    for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
        bool ran_out = true;
        for (std::uint64_t allowed = 0; ran_out && allowed < 1000; ++allowed) {
            Page page;
            World world = World::create({.threads = 1}).value();
            bool started = false;
            std::optional<ClothId> cloth;
            {
                const MemoryRunsOut memory(allowed, how_long);
                started = world.start_recording(page.sink()).ok();
                ran_out = memory.happened();
            }
            if (!started) {
                EXPECT_TRUE(ran_out);
                continue;
            }
            cloth = world.add_cloth(mesh).value();
            ASSERT_TRUE(world.pin(*cloth, 0));
            world.step(1.0f / 60);
            bool stopped = false;
            {
                const MemoryRunsOut memory(allowed, how_long);
                EXPECT_TRUE(world.move_pin(*cloth, 0, {0, 0.1f, 0}));
                for (int k = 0; k < 3; ++k) world.step(1.0f / 60);
                stopped = world.stop_recording().ok();
                ran_out |= memory.happened();
            }
            const auto replayed = replay(std::span(page.bytes).first(page.used), {.threads = 1});
            ASSERT_TRUE(replayed) << replayed.error().message;
            EXPECT_FALSE(replayed->difference);
            EXPECT_TRUE(!stopped || replayed->is_whole);
            if (expected == 0) expected = world.state_hash();
            EXPECT_EQ(world.state_hash(), expected);
        }
        EXPECT_FALSE(ran_out) << "it never ends";
    }
}

}  // namespace
}  // namespace weft::test
