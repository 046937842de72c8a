#pragma once
// Writes a World's calls down as they are made.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "cloth/frame/record/call.h"
#include "cloth/frame/record/record_format.h"
#include "weft/error.h"
#include "weft/recording.h"
#include "weft/settings.h"

namespace weft {

struct Simulation;

/// What cannot be written ends the recording, never the call: stop() says so.
class Recorder {
  public:
    /// Errors: the file cannot be written; the first of the recording cannot.
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
        try {
            writer_.begin();
            (writer_.put(arguments), ...);
            write(call);
        } catch (...) {
            fail(ErrorCode::out_of_memory, "out of memory");
        }
    }
    void note_step(float dt, const Simulation& simulation) noexcept;
    /// That something is done which no record can say.
    void fail(ErrorCode code, const char* why) noexcept;

    /// Writes the end. Error: what could not be written.
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
    std::uint32_t number_ = 0;
    std::optional<ErrorCode> failed_;
    const char* why_ = "";  // a string literal
};

}  // namespace weft
