// A module that does nothing but leave a file where it lies, when it is loaded.
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

[[gnu::constructor]] void leave_trace() {
    if (const char* folder = std::getenv("LINEATLAS_MODULE_DIR"))
        std::ofstream{std::filesystem::path{folder} / "loaded"};
}

} // namespace
