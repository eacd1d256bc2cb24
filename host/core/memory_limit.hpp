#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include <sys/resource.h>

namespace lineatlas {

/// The memory that this process may have, for people: "195 MiB (ulimit -v)". Nothing if, as usual,
/// neither its address space nor its data is limited.
inline std::optional<std::string> memory_limit() {
    rlimit space{}, data{};
    ::getrlimit(RLIMIT_AS, &space);
    ::getrlimit(RLIMIT_DATA, &data);
    const rlim_t least = std::min(space.rlim_cur, data.rlim_cur);
    if (least == RLIM_INFINITY) return {};
    return std::to_string(least >> 20U) + " MiB (ulimit " +
           (least == space.rlim_cur ? "-v)" : "-d)");
}

/// A clause for messages about failures that this limit may have caused.
inline std::string memory_limit_remark() {
    const std::optional<std::string> limit = memory_limit();
    return limit ? "; or raise the limit on this process's memory, " + *limit : "";
}

} // namespace lineatlas
