// Runs inputs through a fuzz target without a fuzzer: the given files, and all files in given
// folders.
#include <algorithm>
#include <iostream>
#include <vector>

#include "fuzz.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs(const std::vector<fs::path>& places) {
    std::vector<fs::path> files;
    for (const fs::path& place : places) {
        if (!fs::is_directory(place)) {
            files.push_back(place);
            continue;
        }
        for (const fs::directory_entry& entry : fs::directory_iterator{place}) {
            if (entry.is_regular_file()) files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<fs::path> files = inputs({argv + 1, argv + argc});
    for (const fs::path& file : files) {
        std::cout << file.filename().string() << std::endl; // names the culprit if this crashes
        const std::vector<std::uint8_t> bytes = lineatlas::fuzz::read_file(file);
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::cout << files.size() << " inputs\n";
    return files.empty() ? 1 : 0; // a call without any input is a mistake
}
