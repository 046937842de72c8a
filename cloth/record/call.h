#pragma once
// The calls that change a World.

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace weft {

/// Recordings store these numbers: a new call goes to the end.
enum class Call : std::uint32_t {
    create,  ///< the first record: World::create
    end,     ///< the last record
    step,
    set_settings,
    add_cloth,
    remove_cloth,
    set_cloth_settings,
    set_enabled,
    wake,
    pin,
    unpin,
    move_pins,
    move_cloth,
    set_frame,
    leave_frame,
    set_map,
    set_skin,
    shift_origin,
    add_shape,
    deform_shape,
    remove_shape,
    add_collider,
    move_collider,
    place_collider,
    remove_collider,
    add_body,
    remove_body,
    set_body_settings,
    set_body_state,
    attach_collider,
    detach_collider,
    attach,
    detach,
    restore,
    cook,  ///< CookedCloth::create, once before its first cloth is added
    add_cooked_cloth,
    set_importance,
    choose,  ///< the rungs that the next step changes by its budget
    recut_cloth,
    reset_cloth,
    stitch,
    unstitch,
    restore_cloth,
    restore_cloths,
    resume_cloth,
    add_level,
    set_level,
    last = set_level,
};

/// The call's name in the interface.
[[nodiscard]] constexpr const char* name_of(Call call) {
    constexpr const char* names[] = {"create",
                                     "the end",
                                     "step",
                                     "set_settings",
                                     "add_cloth",
                                     "remove_cloth",
                                     "set_cloth_settings",
                                     "set_enabled",
                                     "wake",
                                     "pin",
                                     "unpin",
                                     "move_pins",
                                     "move_cloth",
                                     "set_frame",
                                     "leave_frame",
                                     "set_map",
                                     "set_skin",
                                     "shift_origin",
                                     "add_shape",
                                     "deform_shape",
                                     "remove_shape",
                                     "add_collider",
                                     "move_collider",
                                     "place_collider",
                                     "remove_collider",
                                     "add_body",
                                     "remove_body",
                                     "set_body_settings",
                                     "set_body_state",
                                     "attach_collider",
                                     "detach_collider",
                                     "attach",
                                     "detach",
                                     "restore",
                                     "CookedCloth::create",
                                     "add_cloth",
                                     "set_importance",
                                     "what the budget chose",
                                     "recut_cloth",
                                     "reset_cloth",
                                     "stitch",
                                     "unstitch",
                                     "restore_cloth",
                                     "restore_cloths",
                                     "resume_cloth",
                                     "add_level",
                                     "set_level"};
    static_assert(std::size(names) == static_cast<std::size_t>(Call::last) + 1);
    return names[static_cast<std::size_t>(call)];
}

}  // namespace weft
