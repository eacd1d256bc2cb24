// A module that does nothing but make the file "loaded" beside it executable, when it is loaded: a
// process that loads modules can make no file any more.
#include <cstdlib>
#include <filesystem>

namespace {

[[gnu::constructor]] void leave_trace() {
    if (const char* folder = std::getenv("LINEATLAS_MODULE_DIR"))
        std::filesystem::permissions(std::filesystem::path{folder} / "loaded",
                                     std::filesystem::perms::owner_all);
}

} // namespace
