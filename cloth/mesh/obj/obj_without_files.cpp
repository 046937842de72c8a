// Replaces obj.cpp where the standard library has no files.

#include "weft/mesh.h"

namespace weft {

Result<Mesh> load_obj(const std::filesystem::path& file, const ObjOptions&, ObjReport*) {
    return Error{ErrorCode::unsupported,
                 file.string() + ": cannot be read: there are no files here; fill a Mesh"};
}

Result<void> save_obj(const std::filesystem::path& file, const Mesh&) {
    return Error{ErrorCode::unsupported, file.string() + ": cannot be written: there are no files here"};
}

}  // namespace weft
