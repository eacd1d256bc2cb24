#include "machine.hpp"

#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include <gnu/libc-version.h>
#include <sys/utsname.h>

namespace lineatlas::bench {
namespace {

/// The rest of the first line that starts with `key`, after `key` and any characters of `between`.
std::string value_in(const char* file, const std::string& key, const char* between) {
    std::ifstream input{file};
    for (std::string line; std::getline(input, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t at = line.find_first_not_of(between, key.size());
        if (at == std::string::npos) return {};
        line.erase(0, at);
        while (!line.empty() && (line.back() == '"' || line.back() == ' ')) line.pop_back();
        return line;
    }
    return {};
}

std::string first_line(const char* file) {
    std::ifstream input{file};
    std::string line;
    std::getline(input, line);
    return line;
}

} // namespace

nlohmann::ordered_json describe_machine() {
    utsname system{};
    ::uname(&system);
    const char* fallback = std::getenv("LINEATLAS_BUNDLE_FALLBACK");
    return {{"processor", value_in("/proc/cpuinfo", "model name", "\t :")},
            {"threads", std::thread::hardware_concurrency()},
            {"memory", value_in("/proc/meminfo", "MemTotal:", " ")},
            {"system", value_in("/etc/os-release", "PRETTY_NAME=", "\"")},
            {"kernel", std::string{system.release} + " " + system.machine},
            {"glibc", gnu_get_libc_version()},
            {"nvidia_driver", first_line("/proc/driver/nvidia/version")},
            {"libraries_from_bundle", fallback != nullptr ? fallback : ""}};
}

} // namespace lineatlas::bench
