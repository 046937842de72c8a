#include "demo/look/recorder.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace weft::demo {
namespace {

std::filesystem::path numbered(const std::filesystem::path& folder, const char* form, int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), form, number);
    return folder / name.data();
}

/// The first unused name of weft-0001, weft-0002, and so on.
std::filesystem::path free_name(const std::filesystem::path& folder, const char* form) {
    std::error_code ignored;
    int number = 1;
    while (std::filesystem::exists(numbered(folder, form, number), ignored)) ++number;
    return numbered(folder, form, number);
}

/// Runs a program and discards its output. True if it exited with 0.
bool run(std::vector<std::string> arguments) {
    std::vector<char*> argv;
    for (std::string& each : arguments) argv.push_back(each.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t nowhere;
    posix_spawn_file_actions_init(&nowhere);
    for (const int stream : {0, 1, 2})
        posix_spawn_file_actions_addopen(&nowhere, stream, "/dev/null", stream == 0 ? 0 : 1, 0);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, argv[0], &nowhere, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&nowhere);
    int status = 0;
    return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

}  // namespace

bool program_is_there(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((std::filesystem::path(folder) / name).c_str(), X_OK) == 0) return true;
    return false;
}

Result<std::filesystem::path> Recorder::save(const render::Image& image) {
    const std::filesystem::path file = free_name(folder_, "weft-%04d.png");
    if (auto saved = render::save_png(image, file.c_str()); !saved) return saved.error();
    return file;
}

Result<void> Recorder::start() {
    const std::filesystem::path film = free_name(folder_, "weft-film-%04d");
    std::error_code cannot;
    std::filesystem::create_directories(film, cannot);
    if (cannot)
        return Error{ErrorCode::file_not_found, film.string() + " cannot be made: " + cannot.message()};
    film_ = film;
    pictures_ = 0;
    return {};
}

Result<void> Recorder::add(const render::Image& image) {
    if (!recording()) return {};
    return render::save_png(image, numbered(film_, "picture_%06d.png", ++pictures_).c_str());
}

Result<std::string> Recorder::stop() {
    const std::filesystem::path film = std::exchange(film_, {});
    if (film.empty()) return std::string();
    const std::string pictures =
        std::to_string(pictures_) + " pictures in " + film.string() + " (30 a second)";
    if (!program_is_there("ffmpeg")) return pictures + "; with ffmpeg installed they become a film, too";
    const std::string file = film.string() + ".mp4";
    const bool made = run({"ffmpeg", "-y", "-framerate", "30", "-i", (film / "picture_%06d.png").string(),
                           "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", file});
    if (!made) return Error{ErrorCode::file_not_found, "ffmpeg made no film of the " + pictures};
    return file + ", of " + pictures;
}

}  // namespace weft::demo
