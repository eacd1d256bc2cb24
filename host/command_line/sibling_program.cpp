#include "sibling_program.hpp"

#include <filesystem>

#include <unistd.h>

#include "lineatlas/error.hpp"

namespace lineatlas {

void run_sibling(const std::string& name, const std::vector<std::string>& arguments,
                 const std::string& advice) {
    const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe");
    const std::string program = (tool.parent_path() / name).string();
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    throw Error("cannot run \"" + program + "\"; " + advice);
}

} // namespace lineatlas
