#include "material_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "named_files.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view blanks = " \t";

/// The text after each `mtllib` that begins a line; each name once.
std::vector<std::string> material_names(std::string_view text) {
    constexpr std::string_view keyword = "mtllib";
    std::vector<std::string> names;
    std::set<std::string_view> known;
    text = without_utf8_mark(text);
    for (std::size_t at = text.find(keyword); at != text.npos; at = text.find(keyword, at + 1)) {
        const std::size_t before = text.substr(0, at).find_last_not_of(blanks);
        const bool first = before == text.npos || text[before] == '\n' || text[before] == '\r';
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::string_view rest = text.substr(at + keyword.size(), end - at - keyword.size());
        const std::size_t begin = rest.find_first_not_of(blanks);
        if (!first || begin == 0 || begin == rest.npos) continue;
        rest = rest.substr(begin, rest.find_last_not_of(blanks) + 1 - begin);
        if (known.insert(rest).second) names.emplace_back(rest);
    }
    return names;
}

class Reader {
  public:
    explicit Reader(const fs::path& obj) : beside_(obj) {}

    void read(std::string name) {
        std::ranges::replace(name, '\\', '/');
        // A name may hold blanks, or the line may name several files: the first that exists counts.
        Outcome outcome = read_one(name);
        std::istringstream words(name);
        bool any = outcome == Outcome::read;
        for (std::string word; outcome != Outcome::read && words >> word;) {
            const Outcome of_word = read_one(word);
            any = any || of_word == Outcome::read;
            if (of_word == Outcome::outside) outcome = of_word;
        }
        if (any) return;
        files_.notes.push_back("material file " + lineatlas::quoted(name) +
                               (outcome == Outcome::outside
                                    ? " is not beside the model or below its folder"
                                    : " cannot be read") +
                               "; its materials have no colour");
    }

    MaterialFiles take() { return std::move(files_); }

  private:
    using Outcome = NamedFiles::Outcome;

    Outcome read_one(const fs::path& name) {
        std::string contents;
        const Outcome outcome = beside_.read(name, contents);
        if (outcome == Outcome::read) files_.contents.push_back(std::move(contents));
        return outcome;
    }

    NamedFiles beside_;
    MaterialFiles files_;
};

} // namespace

MaterialFiles read_material_files(const SourceFile& obj) {
    Reader reader(obj.path);
    for (const std::string& name : material_names(obj.bytes)) reader.read(name);
    return reader.take();
}

} // namespace lineatlas
