// lineatlas-reader: reads models for programs that embed the library (load_mesh()), so that a crash
// of the reader does not end them. It is installed beside the modules that it loads.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include "io/isolated.hpp"

int main(int argc, char** argv) {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    ::setenv("LINEATLAS_MODULE_DIR", program.parent_path().c_str(), 0);
    if (const std::optional<int> code = lineatlas::serve_as_reader(argc, argv)) return *code;
    std::fputs("lineatlas-reader: programs start it to read models; `lineatlas` is for people\n",
               stderr);
    return 2;
}
