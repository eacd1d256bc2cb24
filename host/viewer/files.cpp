#include "files.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "io/extension.hpp"
#include "io/model_types.hpp"
#include "lineatlas/error.hpp"
#include "saving.hpp"

namespace lineatlas::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_recent = 12;

bool can_open(const fs::path& file) {
    const std::string extension = lower_extension(file);
    return find_model_type(extension) != nullptr || extension == ".toml" || extension == ".json";
}

} // namespace

std::vector<FileEntry> list_folder(const fs::path& folder) {
    std::vector<FileEntry> entries;
    std::error_code failure;
    for (fs::directory_iterator at{folder, failure}, end; !failure && at != end;
         at.increment(failure)) {
        if (at->path().filename().string().starts_with('.')) continue;
        std::error_code unknown;
        const bool is_folder = at->is_directory(unknown);
        if (is_folder || (at->is_regular_file(unknown) && can_open(at->path())))
            entries.push_back({at->path(), is_folder});
    }
    std::ranges::sort(entries, [](const FileEntry& a, const FileEntry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.path < b.path;
    });
    return entries;
}

RecentFiles::RecentFiles(fs::path store) : store_(std::move(store)) {
    std::ifstream file{store_};
    for (std::string line; all_.size() < most_recent && std::getline(file, line);)
        if (!line.empty() && std::ranges::find(all_, fs::path{line}) == all_.end())
            all_.emplace_back(line);
    forget_lost();
}

void RecentFiles::forget_lost() {
    std::error_code failure;
    std::erase_if(all_, [&](const fs::path& file) { return !fs::exists(file, failure); });
}

void RecentFiles::add(const fs::path& file) {
    std::error_code failure;
    fs::path whole = fs::weakly_canonical(file, failure); // a file has one name here, however it
                                                          // was given
    if (failure || whole.string().find('\n') != std::string::npos) return;
    std::erase(all_, whole);
    all_.insert(all_.begin(), std::move(whole));
    if (all_.size() > most_recent) all_.resize(most_recent);
    if (store_.empty()) return;
    std::string text;
    for (const fs::path& path : all_) text += path.string() + '\n';
    fs::create_directories(store_.parent_path(), failure);
    try {
        save_text(text, store_);
    } catch (const FileError&) { // said so in the header
    }
}

fs::path recent_files_store() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        const fs::path path = value != nullptr ? value : "";
        return path.is_absolute() ? path : fs::path{};
    };
    if (const fs::path state = folder("XDG_STATE_HOME"); !state.empty())
        return state / "lineatlas" / "recent";
    if (const fs::path home = folder("HOME"); !home.empty())
        return home / ".local" / "state" / "lineatlas" / "recent";
    return {};
}

} // namespace lineatlas::viewer
