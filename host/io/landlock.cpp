#include "landlock.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/file_descriptor.hpp"

namespace lineatlas {

namespace {

// The C library has no functions for these calls, and headers of a system know only what its kernel
// had.

/// landlock_ruleset_attr: the actions that are refused unless a rule allows them.
struct Ruleset {
    std::uint64_t files, network, scopes;
};

/// landlock_path_beneath_attr: the actions that are allowed in a folder and everything below it.
struct [[gnu::packed]] FolderRule {
    std::uint64_t allowed;
    std::int32_t folder;
};

constexpr std::uint32_t ask_version = 1;
constexpr int rule_of_folder = 1;
constexpr std::uint64_t read_file = 1U << 2U, read_folder = 1U << 3U;

constexpr std::uint64_t lowest(int bits) {
    return (std::uint64_t{1} << static_cast<unsigned>(bits)) - 1;
}

Ruleset everything(int version) {
    constexpr int since_1 = 13, since_2 = 14, since_3 = 15, since_5 = 16; // numbers of rights
    const int files = version >= 5   ? since_5
                      : version >= 3 ? since_3
                      : version >= 2 ? since_2
                                     : since_1;
    return {.files = lowest(files),
            .network = version >= 4 ? lowest(2) : 0,
            .scopes = version >= 6 ? lowest(2) : 0};
}

/// The size of a ruleset by version. Older kernels refuse a longer one than they know.
std::size_t size_of_ruleset(int version) {
    if (version >= 6) return sizeof(Ruleset);
    return version >= 4 ? offsetof(Ruleset, scopes) : offsetof(Ruleset, network);
}

/// Throws std::system_error if a system call has failed.
void check(long result) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), "Landlock");
}

/// The descriptor that a system call has opened. Throws if it failed.
FileDescriptor opened(long number) {
    check(number);
    return FileDescriptor{static_cast<int>(number)};
}

void allow_reading(const FileDescriptor& ruleset) {
    const FileDescriptor root = opened(::open("/", O_PATH | O_CLOEXEC));
    const FolderRule rule{.allowed = read_file | read_folder, .folder = root.number()};
    check(::syscall(SYS_landlock_add_rule, ruleset.number(), rule_of_folder, &rule, 0));
}

} // namespace

int landlock_version() {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, ask_version);
    return version > 0 ? static_cast<int>(version) : 0;
}

void restrict_files(Files allowed) {
    const int version = landlock_version();
    const Ruleset rules = everything(version);
    const FileDescriptor ruleset =
        opened(::syscall(SYS_landlock_create_ruleset, &rules, size_of_ruleset(version), 0));
    if (allowed == Files::read) allow_reading(ruleset);
    check(::syscall(SYS_landlock_restrict_self, ruleset.number(), 0));
}

} // namespace lineatlas
