#include "demo/study/machine.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <set>
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

// The charts' own folder does not count: a table that is written there differs from its first row on.
std::string commit_name() {
    static const std::string name =
        first_line_of("cd '" WEFT_SOURCE_FOLDER
                      "' && printf %s%s \"$(git describe --always --exclude '*' 2> /dev/null)\" "
                      "\"$(git diff --quiet HEAD -- . ':(exclude)demo/charts' 2> /dev/null || echo +)\"");
    return name.empty() || name == "+" ? "unknown" : name;
}

std::string origin_of(const CsvTable& table, const std::string& command) {
    std::set<std::string> origins;
    for (const CsvRow& row : table.rows)
        origins.insert("commit " + row.at("commit") + " on " + row.at("machine"));
    std::string text = "weft_study " + command;
    for (const std::string& origin : origins) text += "; " + origin;
    return text;
}

void StudyProgress::begin(const std::string& what) {
    begun_ = Clock::now();
    ++item_;
    std::fprintf(stderr, "[%zu/%zu] %s", item_, items_, what.c_str());
    if (const std::optional<double> seconds = seconds_left())
        std::fprintf(stderr, *seconds < 120 ? ", %.0f s left" : ", %.0f min left",
                     *seconds < 120 ? *seconds : *seconds / 60);
    std::fputc('\n', stderr);
}

// The remaining cost may round to less than 0: costs of rounds do not add up to the total to the last bit.
std::optional<double> StudyProgress::seconds_left() const {
    if (!(cost_measured_ > 0)) return std::nullopt;
    return seconds_measured_ / cost_measured_ * std::max(cost_left_, 0.0);
}

void StudyProgress::end(double cost, bool measured) {
    cost_left_ -= cost;
    if (!measured) return;
    cost_measured_ += cost;
    seconds_measured_ += std::chrono::duration<double>(Clock::now() - begun_).count();
}

void StudyProgress::skip(double cost) {
    ++item_;
    cost_left_ -= cost;
}

}  // namespace weft::study
