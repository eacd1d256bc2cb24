#include "build_error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <system_error>

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
    while ((static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end; // not within a letter
    return line.substr(0, end) + "...";
}

/// The file and line that a line of a source, counted from 1, comes from by #line directives. Empty
/// if there is none before it.
std::string place_of_line(std::string_view source, std::size_t line) {
    std::istringstream lines{std::string{source}};
    std::string file;
    std::size_t number = 0;
    for (std::string text; line > 0 && std::getline(lines, text); --line) {
        std::istringstream directive{text};
        std::string word;
        if (directive >> word && word == "#line") {
            directive >> number >> std::quoted(file);
            continue;
        }
        if (line > 1) ++number;
    }
    return file.empty() ? file : file + ':' + std::to_string(number);
}

/// A message such as "NAME:12: error", in which NAME is none of the source's files, with the place
/// in its file.
std::string in_its_file(const std::string& message, std::string_view source) {
    const std::size_t name_end = message.find(':');
    if (name_end == message.npos) return message;
    const std::string name = message.substr(0, name_end);
    if (source.find('"' + name + '"') != source.npos) return message;
    std::size_t line = 0;
    const char* const begin = message.data() + name_end + 1;
    const auto [end, error] = std::from_chars(begin, message.data() + message.size(), line);
    if (error != std::errc{} || *end != ':') return message;
    const std::string place = place_of_line(source, line);
    return place.empty() ? message : place + end;
}

} // namespace

std::string first_error(std::string_view log, std::string_view source) {
    std::istringstream lines{std::string{log}};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        line = as_text(line);
        if (contains_ignoring_case(line, "error")) return in_its_file(line, source);
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
