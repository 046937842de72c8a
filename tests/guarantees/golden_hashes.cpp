#include "tests/guarantees/golden_hashes.h"

#include <fstream>
#include <sstream>

namespace weft::demo {

GoldenHashes GoldenHashes::read(const std::filesystem::path& file) {
    GoldenHashes hashes;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        std::string key;
        words >> key >> std::ws;
        if (key == "compiler") {
            std::getline(words, hashes.compiler);
        } else if (key == "targets") {
            for (std::string name; words >> name;) hashes.targets.push_back(name);
        } else {
            words >> hashes.of_scene[key];
        }
    }
    return hashes;
}

bool GoldenHashes::write(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << "# State hashes of the demo's scenes, for golden_hash_test.cpp, which says how to record them "
           "again.\n"
        << "compiler " << compiler << "\ntargets";
    for (const std::string& name : targets) out << ' ' << name;
    out << '\n';
    for (const auto& [scene, hash] : of_scene) out << scene << ' ' << hash << '\n';
    out.close();
    return static_cast<bool>(out);
}

}  // namespace weft::demo
