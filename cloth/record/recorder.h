#pragma once
// Records a World's calls as they are made.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cloth/record/call.h"
#include "cloth/record/record_format.h"
#include "engine/memory/without_exceptions.h"
#include "weft/cooked_cloth.h"
#include "weft/error.h"
#include "weft/recording.h"
#include "weft/settings.h"
#include "weft/transform.h"

namespace weft {

struct Simulation;

/// A failure to write ends the recording, never the call; stop() returns it.
class Recorder {
  public:
    /// Errors: the file cannot be opened; the first record cannot be written.
    [[nodiscard]] static Result<std::unique_ptr<Recorder>> open(const std::filesystem::path& file,
                                                                const WorldSettings& settings);
    [[nodiscard]] static Result<std::unique_ptr<Recorder>> begin(const RecordingSink& sink,
                                                                 const WorldSettings& settings);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    template <class... Arguments>
    void note(Call call, const Arguments&... arguments) noexcept {
        if (failed_) return;
        const bool is_written = comes_through([&] {
            writer_.begin();
            (writer_.put(arguments), ...);
            write(call);
        });
        if (!is_written) fail(ErrorCode::out_of_memory, "out of memory");
    }
    void note_step(float dt, const Simulation& simulation) noexcept;
    /// Records a cloth from a cooked one, whose bytes are written before its first cloth. `cooking`: identity
    /// of the cooked cloth, the same for all its copies.
    void note_cooked(ClothId id, const std::shared_ptr<const void>& cooking, const CookedCloth& cooked,
                     const ClothSettings& settings, const Transform& place) noexcept;
    /// Ends the recording with an error: nothing more is written.
    void fail(ErrorCode code, const char* why) noexcept;

    /// Writes the end. Error: the first failure to write.
    Result<void> stop();

  private:
    Recorder() = default;
    void write(Call call);
    void send(std::span<const std::byte> bytes);

    struct Close {
        void operator()(std::FILE* file) const noexcept { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    RecordingSink sink_;
    RecordWriter writer_;
    StateHash hasher_;
    std::vector<HashOfCloth> hashes_;
    std::vector<std::shared_ptr<const void>> cookings_;  // identities of those that were written
    std::uint32_t number_ = 0;
    std::optional<ErrorCode> failed_;
    const char* why_ = "";  // a string literal
};

}  // namespace weft
