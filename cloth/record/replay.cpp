// Replays recordings, record by record.

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include "cloth/record/replayer.h"
#include "engine/memory/without_exceptions.h"
#include "engine/platform.h"

namespace weft {

namespace {

/// A source of a recording's bytes.
class Source {
  public:
    virtual ~Source() = default;
    /// Fills `to` as far as there are bytes, and returns how many there were.
    virtual std::size_t read(std::span<std::byte> to) = 0;
    /// Upper bound on the bytes that are left.
    [[nodiscard]] virtual std::uint64_t left() const = 0;
};

class MemorySource final : public Source {
  public:
    explicit MemorySource(std::span<const std::byte> bytes) : left_(bytes) {}
    std::size_t read(std::span<std::byte> to) override {
        const std::size_t count = std::min(to.size(), left_.size());
        if (count > 0) std::memcpy(to.data(), left_.data(), count);
        left_ = left_.subspan(count);
        return count;
    }
    [[nodiscard]] std::uint64_t left() const override { return left_.size(); }

  private:
    std::span<const std::byte> left_;
};

class FileSource final : public Source {
  public:
    FileSource(std::FILE* file, std::uint64_t bytes) : file_(file), left_(bytes) {}
    std::size_t read(std::span<std::byte> to) override {
        const std::size_t count = std::fread(to.data(), 1, to.size(), file_);
        left_ -= std::min<std::uint64_t>(left_, count);
        return count;
    }
    [[nodiscard]] std::uint64_t left() const override { return left_; }

  private:
    std::FILE* file_;
    std::uint64_t left_;
};

Error bad(std::string why) {
    return {ErrorCode::malformed_file, "the recording " + std::move(why)};
}
Error bad_record(std::uint32_t number, Call call, const std::string& why) {
    return bad("has a record " + std::to_string(number) + ", " + name_of(call) + ", that " + why);
}

Result<void> read_head(Source& source) {
    RecordingHead head;
    const std::size_t count = source.read(std::as_writable_bytes(std::span(&head, 1)));
    if (count < sizeof head)
        return bad("has " + std::to_string(count) + " bytes; its head alone takes " +
                   std::to_string(sizeof head));
    if (head.mark != recording_mark) return bad("is none of Weft's: it does not begin with WEFTRECD");
    if (head.version != recording_version)
        return bad("has version " + std::to_string(head.version) + "; this library reads version " +
                   std::to_string(recording_version));
    if (head.unused != 0) return bad("is damaged in its head");
    return {};
}

/// Reads a recording's records, one at a time.
class Records {
  public:
    explicit Records(Source& source) : source_(source) {}

    /// Reads the next record; false: the recording breaks off before its end. Error: the record is damaged.
    Result<bool> next() {
        const std::size_t count = source_.read(std::as_writable_bytes(std::span(&head_, 1)));
        if (count < sizeof head_) return false;
        if (head_.own_hash != head_.hash_of_head(hasher_) || head_.number != number_ ||
            head_.call > static_cast<std::uint32_t>(Call::last))
            return bad("is damaged in the head of its record " + std::to_string(number_));
        if (head_.bytes > source_.left()) return false;
        bytes_.resize(head_.bytes);
        if (source_.read(bytes_) < bytes_.size()) return false;
        hasher_.reset();
        hasher_.add(std::span<const std::byte>(bytes_));
        if (hasher_.value() != head_.hash) return bad_record(number_, call(), "is damaged");
        ++number_;
        return true;
    }
    [[nodiscard]] Call call() const { return static_cast<Call>(head_.call); }
    [[nodiscard]] std::uint32_t number() const { return number_ - 1; }  ///< of the last record
    [[nodiscard]] std::span<const std::byte> given() const { return bytes_; }

  private:
    Source& source_;
    RecordHead head_;
    std::vector<std::byte> bytes_;
    StateHash hasher_;
    std::uint32_t number_ = 0;
};

Result<Replay> replay_all(Source& source, const ReplayOptions& options) {
    if (const auto head = read_head(source); !head) return head.error();
    Records records(source);
    Replayer replayer(options);
    for (;;) {
        const auto more = records.next();
        if (!more) return more.error();
        if (!*more) break;
        if (const auto made = replayer.make(records.call(), records.given()); !made) {
            if (made.error().code == ErrorCode::out_of_memory) return made.error();
            return bad_record(records.number(), records.call(), made.error().message);
        }
        if (replayer.replay().difference || replayer.replay().is_whole) break;
    }
    if (!replayer.has_world()) return bad("breaks off before its first record ends");
    if (replayer.replay().is_whole && source.left() > 0) return bad("goes on behind its end");
    return replayer.replay();
}

}  // namespace

Result<Replay> replay(std::span<const std::byte> recording, const ReplayOptions& options) {
    return without_exceptions([&] {
        MemorySource source(recording);
        return replay_all(source, options);
    });
}

#ifdef WEFT_WITHOUT_FILES
Result<Replay> replay(const std::filesystem::path& file, const ReplayOptions&) {
    return Error{ErrorCode::unsupported,
                 file.string() + " cannot be read: there are no files here; replay bytes"};
}
#else
Result<Replay> replay(const std::filesystem::path& file, const ReplayOptions& options) {
    return without_exceptions([&]() -> Result<Replay> {
        struct Close {
            void operator()(std::FILE* open) const noexcept { std::fclose(open); }
        };
        const std::unique_ptr<std::FILE, Close> open(std::fopen(file.string().c_str(), "rb"));
        std::error_code not_a_file;
        const std::uint64_t bytes = std::filesystem::file_size(file, not_a_file);
        if (!open || not_a_file)
            return Error{ErrorCode::file_not_found, file.string() + " cannot be read: " +
                                                        (open ? not_a_file.message() : std::strerror(errno))};
        FileSource source(open.get(), bytes);
        auto replayed = replay_all(source, options);
        if (!replayed) return Error{replayed.error().code, file.string() + ": " + replayed.error().message};
        return replayed;
    });
}
#endif

}  // namespace weft
