#include "demo/look/settings_file.h"

#include <fstream>

namespace weft::demo {

namespace {

Error refused(const std::filesystem::path& file, const Error& error) {
    return {ErrorCode::malformed_file, file.string() + ": " + error.message};
}

}  // namespace

Result<void> save_settings(const std::filesystem::path& file, const Simulation& simulation) {
    const auto cloth = simulation.world().cloth_settings(simulation.content().cloths.front().id);
    std::ofstream stream(file);
    stream << settings_text(simulation.entry().name, {simulation.world().settings(), *cloth});
    stream.close();
    if (!stream) return Error{ErrorCode::file_not_found, file.string() + " cannot be written"};
    return {};
}

Result<void> load_settings(const std::filesystem::path& file, Simulation& simulation) {
    World& world = simulation.world();
    const WorldSettings before = world.settings();
    std::vector<ClothSettings> cloths;
    for (const SceneCloth& each : simulation.content().cloths)
        cloths.push_back(*world.cloth_settings(each.id));
    const auto undo = [&](std::size_t changed) {
        for (std::size_t i = 0; i < changed; ++i)
            (void)world.set_cloth_settings(simulation.content().cloths[i].id, cloths[i]);
        (void)world.set_settings(before);
    };
    const auto first = read_settings(file, before, cloths.front());
    if (!first) return first.error();
    if (auto set = world.set_settings(first->world); !set) return refused(file, set.error());
    for (std::size_t i = 0; i < cloths.size(); ++i) {
        const auto read = read_settings(file, before, cloths[i]);
        const auto set = read ? world.set_cloth_settings(simulation.content().cloths[i].id, read->cloth)
                              : Result<void>(read.error());
        if (set) continue;
        undo(i);
        return refused(file, set.error());
    }
    return {};
}

}  // namespace weft::demo
