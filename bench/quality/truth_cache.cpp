#include "truth_cache.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>

#include <fmt/core.h>
#include <unistd.h>

namespace lineatlas::bench {
namespace {

/// The version of the truth's definition. Increase it with every change of results.
constexpr std::uint32_t definition = 3;

/// A hash of 128 bits over all added words: two 64-bit hashes with different seeds.
class ContentHash {
  public:
    template <class T>
    void add(std::span<const T> values) {
        const auto bytes = std::as_bytes(values);
        add_word(bytes.size());
        for (std::size_t i = 0; i < bytes.size(); i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
            add_word(word);
        }
    }
    template <class T>
    void add(const T& value) {
        add(std::span<const T>{&value, 1});
    }

    std::string name() const { return fmt::format("{:016x}{:016x}", state_[0], state_[1]); }

  private:
    void add_word(std::uint64_t word) {
        constexpr std::array<std::uint64_t, 2> factors{0x9E3779B97F4A7C15ULL,
                                                       0xD6E8FEB86659FD93ULL};
        for (std::size_t i = 0; i < 2; ++i) {
            state_[i] = (state_[i] ^ word) * factors[i];
            state_[i] ^= state_[i] >> 32U;
        }
    }

    std::array<std::uint64_t, 2> state_{1, 2};
};

std::string key(const RayScene& scene, const ClippedLines& clipped, const Camera& camera,
                const TruthOptions& options) {
    const LineSet& lines = scene.lines();
    ContentHash hash;
    hash.add(definition);
    hash.add(std::span{lines.vertices});
    hash.add(std::span{lines.triangles});
    hash.add(scene.patches());
    hash.add(camera.view);
    hash.add(camera.projection);
    hash.add(camera.size);
    hash.add(options.rays);
    hash.add(options.width);
    hash.add(options.rule.contact);
    hash.add(options.rule.patch_pixels);
    hash.add(std::span{clipped.offsets});
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        if (clipped.samples(i) == 0) continue;
        hash.add(std::array{lines.segments[i].p, lines.segments[i].q});
        hash.add(std::array{clipped.clipped[i].t0, clipped.clipped[i].t1});
    }
    return hash.name();
}

} // namespace

std::filesystem::path truth_cache_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != '\0') return std::filesystem::path{cache} / "lineatlas-truth";
    const char* home = std::getenv("HOME");
    return std::filesystem::path{home != nullptr ? home : "/tmp"} / ".cache" / "lineatlas-truth";
}

std::vector<float> cached_visibility(const Oracle& oracle, const ClippedLines& lines,
                                     const Camera& camera, const TruthOptions& options,
                                     const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / key(oracle.scene(), lines, camera, options);
    // Stores floats without rounding, because shares of exactly one half decide between right and
    // wrong.
    std::vector<float> result(lines.offsets.back());
    const auto bytes = static_cast<std::streamsize>(result.size() * sizeof(result[0]));
    std::error_code error;
    if (std::filesystem::file_size(path, error) == static_cast<std::uintmax_t>(bytes) && !error) {
        std::ifstream file{path, std::ios::binary};
        if (file.read(reinterpret_cast<char*>(result.data()), bytes)) return result;
    }
    result = oracle.visibility(lines, camera, options);
    // The file appears whole or not at all, even if two programs write it at the same time.
    const std::filesystem::path unfinished = path.string() + "." + std::to_string(getpid());
    std::filesystem::create_directories(folder, error);
    bool written = false;
    {
        std::ofstream file{unfinished, std::ios::binary};
        written =
            static_cast<bool>(file.write(reinterpret_cast<const char*>(result.data()), bytes));
    }
    if (written) std::filesystem::rename(unfinished, path, error);
    if (!written || error) std::filesystem::remove(unfinished, error);
    return result;
}

} // namespace lineatlas::bench
