#include "sibling_program.hpp"

#include <filesystem>

#include <unistd.h>

#include "lineatlas/error.hpp"

namespace lineatlas {

namespace {

std::string path_of(const std::string& name) {
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

} // namespace

bool has_sibling(const std::string& name) {
    return ::access(path_of(name).c_str(), X_OK) == 0;
}

void run_sibling(const std::string& name, const std::vector<std::string>& arguments,
                 const std::string& advice) {
    const std::string program = path_of(name);
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    throw Error("cannot run \"" + program + "\"; " + advice);
}

} // namespace lineatlas
