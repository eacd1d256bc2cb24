#include "landlock.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include <sys/syscall.h>
#include <unistd.h>

namespace lineatlas {

namespace {

// The C library has no functions for these, and headers of a system know what its own age had.

/// landlock_ruleset_attr: what is refused unless a rule allows it, and there is none.
struct Ruleset {
    std::uint64_t files, network, scopes;
};

constexpr std::uint32_t ask_version = 1;

constexpr std::uint64_t lowest(int bits) {
    return (std::uint64_t{1} << static_cast<unsigned>(bits)) - 1;
}

Ruleset everything(int version) {
    constexpr int since_1 = 13, since_2 = 14, since_3 = 15, since_5 = 16; // rights of files
    const int files = version >= 5   ? since_5
                      : version >= 3 ? since_3
                      : version >= 2 ? since_2
                                     : since_1;
    return {.files = lowest(files),
            .network = version >= 4 ? lowest(2) : 0,
            .scopes = version >= 6 ? lowest(2) : 0};
}

/// Older kernels refuse what is longer than what they know.
std::size_t size_of_ruleset(int version) {
    if (version >= 6) return sizeof(Ruleset);
    return version >= 4 ? offsetof(Ruleset, scopes) : offsetof(Ruleset, network);
}

std::system_error failure() {
    return {errno, std::generic_category(), "Landlock"};
}

} // namespace

int landlock_version() {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, ask_version);
    return version > 0 ? static_cast<int>(version) : 0;
}

void restrict_files() {
    const int version = landlock_version();
    const Ruleset rules = everything(version);
    const long ruleset =
        ::syscall(SYS_landlock_create_ruleset, &rules, size_of_ruleset(version), 0);
    if (ruleset < 0) throw failure();
    const long done = ::syscall(SYS_landlock_restrict_self, ruleset, 0);
    const std::system_error error = failure();
    ::close(static_cast<int>(ruleset));
    if (done != 0) throw error;
}

} // namespace lineatlas
