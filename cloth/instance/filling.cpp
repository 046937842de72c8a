// What a cloth's filling goes by: whether its mesh is closed, and what it encloses.

#include <cmath>
#include <string>

#include "cloth/instance/cloth.h"
#include "cloth/mesh/model_totals.h"
#include "engine/error_text.h"

namespace weft {

namespace {

double rest_volume(const ClothModel& model) {
    return enclosed_volume(model.positions.span(), model.triangles.span());
}

/// The volume that Filling::volume stands for [m^3].
double own_volume(const ClothModel& model, const Filling& filling) {
    return filling.volume > 0 ? static_cast<double>(filling.volume) : rest_volume(model);
}

}  // namespace

Result<void> validate_filling(const ClothModel& model, const ClothSettings& settings) {
    const Filling& filling = settings.filling;
    if (filling.kind == FillingKind::none) return {};
    const auto refused = [](const std::string& why) -> Result<void> {
        return Error{ErrorCode::invalid_argument, "ClothSettings::filling: " + why};
    };
    if (const std::uint32_t border = model.info.border_edges; border > 0)
        return refused("the mesh has " + std::to_string(border) +
                       " open edges, of one triangle each; it must be closed, or Filling::kind none");
    if (const std::uint32_t against = model.info.misoriented_edges; against > 0)
        return refused(
            "the mesh has " + std::to_string(against) +
            " edges whose triangles are wound against each other, as on a Klein bottle; it must have "
            "an inside, or Filling::kind none");
    constexpr double flat = 1e-4;  // of a cube of the same area; a ball has 0.094
    const double volume = rest_volume(model), size = std::pow(rest_area(model), 1.5);
    if (volume < -flat * size)
        return refused("the mesh encloses " + number_text(volume) +
                       " m^3, since it is wound inwards; turn its triangles, counter-clockwise from outside");
    if (filling.kind != FillingKind::pressure && filling.volume == 0 && !(volume > flat * size))
        return refused(
            "Filling::volume is 0, which stands for that of the mesh, and the mesh is flat; give the "
            "volume in m^3");
    return {};
}

std::optional<FillingRow> Cloth::make_filling(const Filling& of) const {
    if (of.kind == FillingKind::none) return std::nullopt;
    return FillingRow(of, own_volume(model, of));
}

FillingInfo Cloth::filling_info() const {
    FillingInfo info{.open_edges = open_edges(model.info)};
    if (info.open_edges > 0) return info;
    const double volume = enclosed_volume(state.positions.span(), model.triangles.span());
    info.volume = static_cast<float>(volume);
    info.rest_volume = static_cast<float>(rest_volume(model));
    if (!filling) return info;
    info.pressure = filling->keeps_volume()
                        ? filling->pressure()
                        : static_cast<float>(
                              gauge_pressure(settings.filling, own_volume(model, settings.filling), volume));
    return info;
}

}  // namespace weft
