#include "build_error.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "devices.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::size_t longest_line = 200;

/// The line without control characters and blanks around it, cut if it is long.
std::string as_text(std::string line) {
    std::ranges::replace_if(
        line, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
    line.erase(line.find_last_not_of(' ') + 1);
    if (line.size() <= longest_line) return line;
    std::size_t end = longest_line;
    while ((static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end; // within a letter
    return line.substr(0, end) + "...";
}

} // namespace

std::string first_error(std::string_view log) {
    std::istringstream lines{std::string{log}};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        line = as_text(line);
        if (contains_ignoring_case(line, "error")) return line;
        if (first.empty()) first = line;
    }
    return first;
}

std::string keep_build_log(std::string_view title, std::string_view log) {
    const char* file = std::getenv("LINEATLAS_BUILD_LOG");
    if (file == nullptr) return "LINEATLAS_BUILD_LOG=FILE keeps the whole log";
    std::ofstream out{file, std::ios::app};
    out << title << '\n' << log << '\n' << std::flush;
    return (out.good() ? "the whole log is in \"" : "its log cannot be written to \"") +
           std::string{file} + '"';
}

} // namespace lineatlas::compute
