#include "demo/study/machine.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <thread>

namespace weft::study {

namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

/// The first line that a shell command prints.
std::string first_line_of(const char* command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command, "r"), pclose);
    char line[256] = "";
    if (!pipe || std::fgets(line, sizeof line, pipe.get()) == nullptr) return {};
    std::string text = line;
    std::erase(text, '\n');
    return text;
}

}  // namespace

std::string machine_name() {
    std::string name = processor() + "; " + std::to_string(std::thread::hardware_concurrency()) + " threads";
    std::ranges::replace(name, ',', ' ');
    return name;
}

std::string commit_name() {
    const std::string name = first_line_of("git -C '" WEFT_SOURCE_FOLDER
                                           "' describe --always --dirty=+ --exclude '*' 2> /dev/null");
    return name.empty() ? "unknown" : name;
}

}  // namespace weft::study
