#include "cloth/solver/passes/along_seams.h"

#include <utility>

#include "cloth/equation/seam_rows.h"

namespace weft {

namespace {

/// visit(seam) for each seam of the members, once.
template <class Visit>
void for_each_seam(std::span<const PassMember> members, const Visit& visit) {
    for (const PassMember& member : members)
        for (SeamRows* seam : member.step.equation.seams)
            if (seam->is_led_by(member.step.equation.first)) visit(*seam);
}

/// visit(seam, member) for each member's seams: those of two members twice.
template <class Visit>
void for_each_side(std::span<const PassMember> members, const Visit& visit) {
    for (const PassMember& member : members)
        for (SeamRows* seam : member.step.equation.seams) visit(*seam, member);
}

}  // namespace

void linearise_seams(std::span<const PassMember> members) {
    for_each_side(members, [](SeamRows& seam, const PassMember& member) {
        seam.take(member.step.equation.first, member.step.velocities);
    });
    for_each_seam(members, [](SeamRows& seam) { seam.linearise(); });
}

double multiply_seams(std::span<const PassMember> members, ScratchArray<Vec4> PassVectors::*x,
                      ScratchArray<Vec4> PassVectors::*product) {
    for_each_side(members, [&](SeamRows& seam, const PassMember& member) {
        seam.take(member.step.equation.first, std::as_const(member.vectors.*x).span());
    });
    double sum = 0;
    for_each_seam(members, [&](SeamRows& seam) { sum += seam.multiply(); });
    if (product != nullptr)
        for_each_side(members, [&](const SeamRows& seam, const PassMember& member) {
            seam.add_products(member.step.equation.first, (member.vectors.*product).span());
        });
    return sum;
}

bool join_what_is_held(std::span<const PassMember> members) {
    bool any = false;
    for_each_seam(members, [&](const SeamRows& seam) { any = any || seam.joins_what_is_held(); });
    return any;
}

}  // namespace weft
