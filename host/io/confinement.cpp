#include "confinement.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <new>
#include <string_view>
#include <system_error>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "landlock.hpp"
#include "lineatlas/error.hpp"
#include "reader_protocol.hpp"
#include "system_calls.hpp"

namespace lineatlas {

namespace {

constexpr std::array<std::string_view, 6> kept{"LD_LIBRARY_PATH", "LINEATLAS_MODULE_DIR",
                                               // Settings of sanitizers, which nothing else reads.
                                               "ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS",
                                               "UBSAN_OPTIONS"};

void check(int result) {
    if (result != 0) throw std::system_error(errno, std::generic_category(), "a limit");
}

void allow_no_more_than(rlim_t most, __rlimit_resource resource) {
    const rlimit limits{.rlim_cur = most, .rlim_max = most};
    check(::setrlimit(resource, &limits));
}

/// Takes a step of confinement, by the means that this machine offers. Throws DeviceError.
void step(void (*give_up)(const Confinement& offered)) {
    if (reader::sanitized) return;
    try {
        give_up(offered_confinement());
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::not_enough_memory) {
            if (const std::new_handler no_memory = std::get_new_handler()) no_memory();
        }
        throw DeviceError("cannot confine the process that works on files by " +
                          std::string(error.what()));
    }
}

} // namespace

Confinement offered_confinement() {
    if (reader::sanitized) return {};
    return {.system_calls = has_seccomp(), .files = landlock_version()};
}

std::string describe(const Confinement& confinement) {
    if (reader::sanitized) return "not confined: built with a sanitizer";
    std::string by, missing;
    const auto add = [](std::string& list, const std::string& part) {
        list += (list.empty() ? "" : ", ") + part;
    };
    add(confinement.system_calls ? by : missing, confinement.system_calls ? "seccomp"
                                                 : knows_seccomp() ? "this kernel has no seccomp"
                                                                   : "built without libseccomp");
    add(confinement.files > 0 ? by : missing, confinement.files > 0
                                                  ? "Landlock " + std::to_string(confinement.files)
                                                  : "this kernel has no Landlock");
    std::string text = by.empty() ? "confined by limits alone" : "confined by " + by;
    return missing.empty() ? text : text + "; " + missing;
}

std::vector<std::string> small_environment() {
    std::vector<std::string> environment;
    for (const std::string_view name : kept) {
        if (const char* value = std::getenv(std::string{name}.c_str()))
            environment.push_back(std::string{name} + '=' + value);
    }
    return environment;
}

void forget_what_was_inherited() {
    const std::vector<std::string> environment = small_environment();
    // The memory of variables is cleared too, because a variable may be a password.
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
        ::explicit_bzero(*variable, std::strlen(*variable));
    static std::array<char*, 1> nothing{};
    // Not null, as clearenv() would set it, because OpenColorIO 2.5 reads it.
    environ = nothing.data();
    for (const std::string& variable : environment) {
        const std::size_t equals = variable.find('=');
        ::setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 1);
    }
    ::close_range(STDERR_FILENO + 1, ~0U, 0);
}

bool has_one_thread() {
    std::error_code error;
    const std::filesystem::directory_iterator threads("/proc/self/task", error);
    return !error && std::distance(begin(threads), end(threads)) == 1;
}

void confine_to_reading() {
    step([](const Confinement& offered) {
        if (!has_one_thread())
            throw std::system_error(std::make_error_code(std::errc::operation_not_permitted),
                                    "no means that reaches the threads it has already");
        check(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0));
        allow_no_more_than(0, RLIMIT_FSIZE);
        if (offered.files > 0) restrict_files(Files::read);
    });
}

void confine() {
    step([](const Confinement& offered) {
        if (offered.files > 0) restrict_files(Files::none);
        allow_no_more_than(0, RLIMIT_NOFILE); // open files stay open
        if (offered.system_calls) restrict_system_calls();
    });
}

} // namespace lineatlas
