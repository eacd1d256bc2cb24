// A module that only makes the file "loaded" beside it executable when it is loaded. It makes no
// file, because processes that load modules cannot.
#include <cstdlib>
#include <filesystem>

namespace {

[[gnu::constructor]] void leave_trace() {
    if (const char* folder = std::getenv("LINEATLAS_MODULE_DIR"))
        std::filesystem::permissions(std::filesystem::path{folder} / "loaded",
                                     std::filesystem::perms::owner_all);
}

} // namespace
