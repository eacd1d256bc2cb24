#include "program_cache.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "cache_file.hpp"
#include "content_hash.hpp"

namespace lineatlas::compute {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view entry_extension = ".program";
constexpr std::string_view part_extension = ".part";

/// The header of an entry, before its key and program.
struct Header {
    std::array<char, 8> magic;
    std::uint64_t key_bytes;
    std::uint64_t program_bytes;
    ContentHash hash; ///< of the key and the program
};

/// Changes with the format of the files.
constexpr std::array<char, 8> magic{'L', 'A', 'P', 'R', 'O', 'G', '0', '1'};

ContentHash hash_of(std::string_view key, std::span<const unsigned char> program) {
    return ContentHash{}.with(std::as_bytes(std::span{key})).with(std::as_bytes(program));
}

std::vector<unsigned char> pack(std::string_view key, std::span<const unsigned char> program) {
    const Header header{magic, key.size(), program.size(), hash_of(key, program)};
    std::vector<unsigned char> entry(sizeof(header));
    std::memcpy(entry.data(), &header, sizeof(header));
    entry.insert(entry.end(), key.begin(), key.end());
    entry.insert(entry.end(), program.begin(), program.end());
    return entry;
}

/// The program in `entry`, if the entry is whole and has this key.
std::optional<std::vector<unsigned char>> unpack(std::span<const unsigned char> entry,
                                                 std::string_view key) {
    Header header;
    if (entry.size() < sizeof(header)) return std::nullopt;
    std::memcpy(&header, entry.data(), sizeof(header));
    const std::span<const unsigned char> content = entry.subspan(sizeof(header));
    if (header.magic != magic || header.key_bytes != key.size() || content.size() < key.size() ||
        header.program_bytes != content.size() - key.size()) {
        return std::nullopt;
    }
    const std::span<const unsigned char> program = content.subspan(key.size());
    if (!std::equal(key.begin(), key.end(), content.begin(),
                    [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; })) {
        return std::nullopt;
    }
    if (header.hash != hash_of(key, program)) return std::nullopt;
    return std::vector<unsigned char>{program.begin(), program.end()};
}

/// Removes old temporary files of killed writers. Files of writers at work are far younger.
void remove_if_left_behind(const fs::directory_entry& file) {
    std::error_code ignored;
    const auto age = fs::file_time_type::clock::now() - file.last_write_time(ignored);
    if (!ignored && age > std::chrono::hours{1}) fs::remove(file.path(), ignored);
}

} // namespace

ProgramCache::ProgramCache(fs::path folder, std::uintmax_t limit)
    : folder_(std::move(folder)), limit_(limit) {}

std::optional<fs::path> ProgramCache::default_folder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path{value != nullptr ? value : ""};
    };
    // The XDG specification says to ignore paths that are not absolute.
    if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) {
        return cache / "lineatlas";
    }
    if (const fs::path home = variable("HOME"); home.is_absolute()) {
        return home / ".cache" / "lineatlas";
    }
    return std::nullopt;
}

fs::path ProgramCache::file_of(std::string_view key) const {
    const ContentHash hash = ContentHash{}.with(std::as_bytes(std::span{key}));
    return folder_ / (hash.text() + std::string{entry_extension});
}

std::optional<std::vector<unsigned char>> ProgramCache::find(std::string_view key) const {
    const fs::path path = file_of(key);
    const std::optional<std::vector<unsigned char>> entry = read_cache_file(path, limit_);
    if (!entry) return std::nullopt;
    std::optional<std::vector<unsigned char>> program = unpack(*entry, key);
    std::error_code ignored;
    if (program) fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return program;
}

bool ProgramCache::store(std::string_view key, std::span<const unsigned char> program) const {
    if (sizeof(Header) + key.size() + program.size() > limit_) return false;
    const bool stored = write_cache_file(file_of(key), part_extension, pack(key, program));
    tidy();
    return stored;
}

void ProgramCache::tidy() const {
    struct Entry {
        fs::path path;
        fs::file_time_type used;
        std::uintmax_t bytes;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    // Other processes may remove files meanwhile, so an error only means that a file is gone.
    std::error_code error;
    for (fs::directory_iterator file{folder_, error}, end; !error && file != end;
         file.increment(error)) {
        std::error_code gone;
        if (file->path().extension() == part_extension) remove_if_left_behind(*file);
        if (file->path().extension() != entry_extension || !file->is_regular_file(gone)) continue;
        const Entry entry{file->path(), file->last_write_time(gone), file->file_size(gone)};
        if (gone) continue;
        total += entry.bytes;
        entries.push_back(entry);
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (total <= limit_) break;
        fs::remove(entry.path, error);
        total -= entry.bytes;
    }
}

} // namespace lineatlas::compute
