#include "fuzz.hpp"
#include "lineatlas/style_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    const std::filesystem::path path = fuzz::put_file(".toml", {data, size});
    std::string written;
    try {
        written = write_style(load_style(path.string()));
    } catch (const FileError& error) {
        fuzz::expect_good_refusal(error, path);
        return 0;
    }
    // An accepted style can be written, and is the same when it is read again.
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(written.data());
    const std::filesystem::path again = fuzz::put_file(".toml", {bytes, written.size()});
    fuzz::expect(write_style(load_style(again.string())) == written,
                 "a style that changes when it is written and loaded");
    return 0;
}
