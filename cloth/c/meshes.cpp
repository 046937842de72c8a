// Meshes and cooked cloths for C.

#include "cloth/c/handles.h"
#include "cloth/c/inputs.h"

namespace weft::c {

// The first version of the struct ended before crossing_faces.
template <>
inline constexpr std::size_t first_size<WeftObjReport> = offsetof(WeftObjReport, crossing_faces);

namespace {

template <class T>
[[nodiscard]] Result<void> copy(const char* name, const WeftInput& input, std::vector<T>& to) {
    std::vector<T> room;
    const auto lying = items(name, input, room);
    if (!lying) return lying.error();
    to.assign(lying->begin(), lying->end());
    return {};
}

[[nodiscard]] Result<Mesh> mesh_of(const WeftMeshView* given) {
    const Result<WeftMeshView> view = taken("mesh", given, WeftMeshView{});
    if (!view) return view.error();
    Mesh mesh;
    if (auto done = copy("positions", view->positions, mesh.positions); !done) return done.error();
    if (auto done = copy("triangles", view->triangles, mesh.triangles); !done) return done.error();
    if (auto done = copy("pattern", view->pattern, mesh.pattern); !done) return done.error();
    if (auto done = copy("texcoords", view->texcoords, mesh.texcoords); !done) return done.error();
    if (auto done = copy("welds", view->welds, mesh.welds); !done) return done.error();
    mesh.rows = view->rows;
    mesh.columns = view->columns;
    return mesh;
}

template <class T>
[[nodiscard]] WeftInput input_of(const std::vector<T>& list) {
    return {list.data(), list.size(), sizeof(T)};
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_mesh_create(const WeftMeshView* of, WeftMesh** mesh) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{of, "of"}, {mesh, "mesh"}}); !there) return there;
        return put_handle(mesh_of(of), mesh);
    });
}

WeftResult weft_mesh_make_sheet(const WeftSheetSettings* settings, WeftMesh** mesh) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}}); !there) return there;
        const auto of = take<weft::SheetSettings>("settings", settings);
        if (!of) return of.error();
        return put_handle(weft::make_sheet(*of), mesh);
    });
}

WeftResult weft_mesh_load_obj(const char* file, WeftBool texcoords_are_pattern, WeftObjReport* report,
                              WeftMesh** mesh) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{file, "file"}, {mesh, "mesh"}}); !there) return there;
        if (report != nullptr)
            if (auto valid = check_size<WeftObjReport>("report", report->struct_size); !valid) return valid;
        weft::ObjReport noticed;
        auto loaded =
            weft::load_obj(path_of(file), {.texcoords_are_pattern = texcoords_are_pattern != 0}, &noticed);
        if (!loaded) return loaded.error();
        if (auto done = put_handle(std::move(loaded), mesh); !done) return done;
        if (report == nullptr) return {};
        return fill("report",
                    WeftObjReport{0, noticed.ignored_lines, noticed.triangulated_faces,
                                  noticed.crossing_faces, noticed.touching_faces},
                    report);
    });
}

WeftResult weft_mesh_make_proxy(const WeftMesh* fine, const WeftProxySettings* settings,
                                WeftProxyReport* report, WeftMesh** mesh) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{fine, "fine"}, {mesh, "mesh"}}); !there) return there;
        if (report != nullptr)
            if (auto valid = check_size<WeftProxyReport>("report", report->struct_size); !valid) return valid;
        const auto of = take<weft::ProxySettings>("settings", settings);
        if (!of) return of.error();
        weft::ProxyReport made;
        if (auto done = put_handle(weft::make_proxy(fine->mesh, *of, &made), mesh); !done) return done;
        if (report == nullptr) return {};
        return fill(
            "report",
            WeftProxyReport{0, made.cell, made.shortest_edge, made.longest_edge, made.parts,
                            made.left_out_parts, made.left_out_triangles, made.closed_holes, made.reach},
            report);
    });
}

WeftResult weft_mesh_save_obj(const WeftMesh* mesh, const char* file) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}, {file, "file"}}); !there) return there;
        return weft::save_obj(path_of(file), mesh->mesh);
    });
}

WeftResult weft_mesh_view(const WeftMesh* mesh, WeftMeshView* view) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}}); !there) return there;
        const weft::Mesh& of = mesh->mesh;
        return fill("view",
                    WeftMeshView{0, input_of(of.positions), input_of(of.triangles), input_of(of.pattern),
                                 input_of(of.texcoords), of.rows, of.columns, input_of(of.welds)},
                    view);
    });
}

void weft_mesh_destroy(WeftMesh* mesh) {
    delete mesh;
}

WeftResult weft_cooked_cloth_create(const WeftMesh* mesh, const WeftClothSettings* settings,
                                    const WeftCookProgress* progress, WeftCookedCloth** cooked) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}, {cooked, "cooked"}}); !there) return there;
        const auto of = take<weft::ClothSettings>("settings", settings);
        if (!of) return of.error();
        weft::CookProgress to_host;
        if (progress != nullptr && progress->report != nullptr) {
            to_host.user = const_cast<WeftCookProgress*>(progress);
            to_host.report = [](void* user, float done) {
                const auto& host = *static_cast<const WeftCookProgress*>(user);
                return host.report(host.user, done) != 0;
            };
        }
        return put_handle(weft::CookedCloth::create(mesh->mesh, *of, to_host), cooked);
    });
}

WeftResult weft_cooked_cloth_load(const void* saved, size_t bytes, const WeftClothSettings* settings,
                                  WeftCookedCloth** cooked) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{saved, "saved"}, {cooked, "cooked"}}); !there) return there;
        const auto of = take<weft::ClothSettings>("settings", settings);
        if (!of) return of.error();
        return put_handle(weft::CookedCloth::load({static_cast<const std::byte*>(saved), bytes}, *of),
                          cooked);
    });
}

namespace {

/// Gives a lender's bytes back when it is destroyed, if the load succeeded.
struct Loan {
    WeftLender lender{};
    bool taken = false;
    Loan() = default;
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    ~Loan() {
        if (taken && lender.give_back != nullptr) lender.give_back(lender.user);
    }
};

}  // namespace

WeftResult weft_cooked_cloth_load_in_place(const void* saved, size_t bytes, const WeftLender* lender,
                                           const WeftClothSettings* settings, WeftCookedCloth** cooked) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{saved, "saved"}, {lender, "lender"}, {cooked, "cooked"}}); !there)
            return there;
        const auto of = take<weft::ClothSettings>("settings", settings);
        if (!of) return of.error();
        const auto loan = std::make_shared<Loan>();
        loan->lender = *lender;
        auto put = put_handle(
            weft::CookedCloth::load_in_place({static_cast<const std::byte*>(saved), bytes}, loan, *of),
            cooked);
        loan->taken = put.ok();
        return put;
    });
}

WeftResult weft_cooked_cloth_info(const WeftCookedCloth* cooked, WeftClothInfo* info) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{cooked, "cooked"}}); !there) return there;
        return fill("info", to_c<WeftClothInfo>(cooked->cooked.info()), info);
    });
}

WeftResult weft_cooked_cloth_report(const WeftCookedCloth* cooked, WeftCookReport* report) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{cooked, "cooked"}}); !there) return there;
        const weft::CookReport& of = cooked->cooked.report();
        WeftCookReport all{};
        all.welded = list<WeftWelded>(std::span(of.welded), &all.welded_count);
        all.dropped = list<WeftDropped>(std::span(of.dropped), &all.dropped_count);
        all.turned = list<uint32_t>(std::span(of.turned), &all.turned_count);
        all.flipped = list<uint32_t>(std::span(of.flipped), &all.flipped_count);
        all.softened = list<WeftSoftened>(std::span(of.softened), &all.softened_count);
        all.loose = list<uint32_t>(std::span(of.loose), &all.loose_count);
        return fill("report", all, report);
    });
}

size_t weft_cooked_cloth_save_size(const WeftCookedCloth* cooked) {
    return cooked == nullptr ? 0 : cooked->cooked.save_size();
}

WeftResult weft_cooked_cloth_save(const WeftCookedCloth* cooked, void* to, size_t bytes) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{cooked, "cooked"}, {to, "to"}}); !there) return there;
        return cooked->cooked.save({static_cast<std::byte*>(to), bytes});
    });
}

void weft_cooked_cloth_destroy(WeftCookedCloth* cooked) {
    delete cooked;
}
