#include "kernel_folder.hpp"

#include <cstdlib>
#include <system_error>
#include <utility>

namespace lineatlas {

KernelFolder::KernelFolder() {
    if (const char* folder = std::getenv("LINEATLAS_KERNEL_DIR")) folder_ = folder;
    seen_ = last_ = look();
}

KernelFolder::WriteTimes KernelFolder::look() const {
    WriteTimes times;
    if (!is_set()) return times;
    std::error_code failure; // of a file that has just gone
    using Files = std::filesystem::recursive_directory_iterator;
    constexpr auto readable = std::filesystem::directory_options::skip_permission_denied;
    for (Files file{folder_, readable, failure}; !failure && file != Files{};
         file.increment(failure)) {
        std::error_code gone;
        const auto time = file->last_write_time(gone);
        if (!gone) times.emplace(file->path(), time);
    }
    return times;
}

bool KernelFolder::has_changed() {
    WriteTimes now = look();
    const bool at_rest = std::exchange(last_, now) == now;
    if (now == seen_ || !at_rest) return false;
    seen_ = std::move(now);
    return true;
}

} // namespace lineatlas
