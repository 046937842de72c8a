#include "cloth/record/recorder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "cloth/record/state_hashes.h"
#include "cloth/simulation/simulation.h"

namespace weft {

namespace {

bool write_to_file(void* file, std::span<const std::byte> bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), static_cast<std::FILE*>(file)) == bytes.size();
}

constexpr const char* not_taken = "the sink, or the disk, took no more";

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::open(const std::filesystem::path& file,
                                                 const WorldSettings& settings) {
    std::unique_ptr<std::FILE, Close> opened(std::fopen(file.string().c_str(), "wb"));
    if (!opened)
        return Error{ErrorCode::file_not_found,
                     file.string() + " cannot be written: " + std::strerror(errno)};
    auto made = begin({write_to_file, opened.get()}, settings);
    if (!made) return made;
    (*made)->file_ = std::move(opened);
    return made;
}

Result<std::unique_ptr<Recorder>> Recorder::begin(const RecordingSink& sink, const WorldSettings& settings) {
    if (sink.write == nullptr)
        return Error{ErrorCode::invalid_argument, "RecordingSink::write is null; set it to a function"};
    std::unique_ptr<Recorder> made(new Recorder());
    made->sink_ = sink;
    const RecordingHead head;
    made->send(std::as_bytes(std::span(&head, 1)));
    made->note(Call::create, settings);
    if (!made->failed_) return made;
    const Error why{*made->failed_, made->why_};
    made->failed_ = ErrorCode::file_not_found;  // no more is written
    return why;
}

Recorder::~Recorder() {
    note(Call::end);
}

// A file is flushed after each step, so that a program that crashes leaves its last one.
void Recorder::note_step(float dt, const Simulation& simulation) noexcept {
    if (failed_) return;
    const bool is_written = comes_through([&] {
        hashes_.clear();
        simulation.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& cloth) {
            hashes_.push_back({id, hash_of(*cloth, hasher_)});
        });
        if (!simulation.choices.empty()) note(Call::choose, std::span<const RungOfCloth>(simulation.choices));
        note(Call::step, dt, hash_of_rest(simulation, hasher_), std::span<const HashOfCloth>(hashes_));
        if (file_ && !failed_ && std::fflush(file_.get()) != 0) fail(ErrorCode::file_not_found, not_taken);
    });
    if (!is_written) fail(ErrorCode::out_of_memory, "out of memory");
}

void Recorder::note_cooked(ClothId id, const std::shared_ptr<const void>& cooking, const CookedCloth& cooked,
                           const ClothSettings& settings, const Transform& place) noexcept {
    if (failed_) return;
    const bool is_written = comes_through([&] {
        const auto found = std::ranges::find(cookings_, cooking);
        const auto number = static_cast<std::uint32_t>(found - cookings_.begin());
        if (found == cookings_.end()) {
            std::vector<std::byte> bytes(cooked.save_size());
            if (!cooked.save(bytes)) return fail(ErrorCode::out_of_memory, "out of memory");
            cookings_.push_back(cooking);
            note(Call::cook, std::span<const std::byte>(bytes), settings);
        }
        note(Call::add_cooked_cloth, id, number, place);
    });
    if (!is_written) fail(ErrorCode::out_of_memory, "out of memory");
}

void Recorder::fail(ErrorCode code, const char* why) noexcept {
    if (failed_) return;
    failed_ = code;
    why_ = why;
}

Result<void> Recorder::stop() {
    note(Call::end);
    if (file_ && !failed_ && std::fflush(file_.get()) != 0) fail(ErrorCode::file_not_found, not_taken);
    const std::optional<ErrorCode> failed = std::exchange(failed_, ErrorCode::file_not_found);
    if (!failed) return {};
    return Error{*failed,
                 "the recording breaks off after its record " + std::to_string(number_) + ": " + why_};
}

void Recorder::write(Call call) {
    send(writer_.end(call, number_, hasher_));
    if (!failed_) ++number_;
}

void Recorder::send(std::span<const std::byte> bytes) {
    if (!sink_.write(sink_.user, bytes)) fail(ErrorCode::file_not_found, not_taken);
}

}  // namespace weft
