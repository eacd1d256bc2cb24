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
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder_, failure}) {
        const auto time = entry.last_write_time(failure);
        if (!failure) times.emplace(entry.path(), time);
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
