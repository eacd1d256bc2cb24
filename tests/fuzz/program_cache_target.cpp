#include <algorithm>
#include <string_view>
#include <vector>

#include "compute/opencl/program_cache.hpp"
#include "fuzz.hpp"

namespace {

using namespace lineatlas;
using Bytes = std::vector<unsigned char>;

constexpr std::string_view key = "a key";
const Bytes program{'a', ' ', 'p', 'r', 'o', 'g', 'r', 'a', 'm', 0, 1, 2, 3, 0xFF};

/// Tries the bytes as a file of the cache. Expects the stored program or nothing.
void try_as_entry(const compute::ProgramCache& cache, std::span<const std::uint8_t> bytes) {
    fuzz::write_file(cache.file_of(key), bytes);
    const std::optional<Bytes> found = cache.find(key);
    fuzz::expect(!found || *found == program, "a program that was not stored");
}

/// Tries the bytes as a key and a program. Expects that the stored program is found until a byte of
/// its entry changes.
void try_as_program(const compute::ProgramCache& cache, std::span<const std::uint8_t> bytes) {
    const std::size_t place = bytes[0];
    const std::size_t length = std::min<std::size_t>(bytes[1], bytes.size() - 2);
    const std::string_view own_key{reinterpret_cast<const char*>(bytes.data()) + 2, length};
    const Bytes own(bytes.begin() + 2 + static_cast<std::ptrdiff_t>(length), bytes.end());
    cache.store(own_key, own);
    fuzz::expect(cache.find(own_key) == own, "a program that is not found again");

    const std::filesystem::path entry = cache.file_of(own_key);
    Bytes damaged = fuzz::read_file(entry);
    damaged[place % damaged.size()] ^= 1U;
    fuzz::write_file(entry, damaged);
    fuzz::expect(!cache.find(own_key), "a damaged program that is found");
    std::filesystem::remove(entry);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const compute::ProgramCache cache{fuzz::put_file(".entry", {}).parent_path() / "cache"};
    cache.store(key, program);
    const std::span<const std::uint8_t> bytes{data, size};
    try_as_entry(cache, bytes);
    if (size >= 2) try_as_program(cache, bytes);
    return 0;
}
