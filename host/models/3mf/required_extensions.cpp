#include "required_extensions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "models/part_names.hpp"
#include "refusal.hpp"

namespace lineatlas::threemf {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The extensions that are read as far as they matter for the drawing.
constexpr std::array<std::string_view, 3> read_ones{
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"};

/// Names for other extensions.
struct Known {
    std::string_view part; ///< of the namespace
    std::string_view name;
};
constexpr std::array known{
    Known{"/beamlattice/", "beam lattices"},    Known{"/slice/", "slices"},
    Known{"/securecontent/", "secure content"}, Known{"/volumetric/", "volumetric data"},
    Known{"/implicit/", "implicit functions"},  Known{"/booleanoperations/", "boolean operations"},
    Known{"/displacement/", "displacement"},    Known{"/trianglesets/", "triangle sets"}};

using Attributes = std::map<std::string_view, std::string_view>;

/// The text from the first tag on, behind comments and the like; empty without a tag.
std::string_view from_first_tag(std::string_view head) {
    while (true) {
        head.remove_prefix(std::min(head.find('<'), head.size()));
        const bool comment = head.starts_with("<!--");
        if (!comment && !head.starts_with("<?")) return head;
        const std::string_view end = comment ? "-->" : "?>";
        head.remove_prefix(std::min(head.find(end), head.size()));
    }
}

/// The attributes of the first tag, <model ...>.
Attributes attributes_of(std::string_view head) {
    Attributes attributes;
    head = from_first_tag(head);
    head.remove_prefix(std::min(head.find_first_of(" \t\r\n>/"), head.size()));
    while (true) {
        const std::size_t at = head.find_first_not_of(blanks);
        if (at == head.npos || head[at] == '>' || head[at] == '/') return attributes;
        head.remove_prefix(at);
        const std::size_t equals = head.find('=');
        const std::size_t quote = head.find_first_of("\"'");
        if (equals == head.npos || quote == head.npos || quote < equals) return attributes;
        const std::size_t end = head.find(head[quote], quote + 1);
        if (end == head.npos) return attributes;
        const std::string_view name = head.substr(0, equals);
        attributes[name.substr(0, name.find_last_not_of(blanks) + 1)] =
            head.substr(quote + 1, end - quote - 1);
        head.remove_prefix(end + 1);
    }
}

std::string name_of(std::string_view space) {
    for (const Known& each : known)
        if (space.find(each.part) != space.npos)
            return std::string(each.name) + " (" + models::part_name(space, "") + ')';
    return models::part_name(space, "without a name");
}

} // namespace

void check_required_extensions(std::string_view head) {
    const Attributes attributes = attributes_of(head);
    const auto required = attributes.find("requiredextensions");
    if (required == attributes.end()) return;
    std::string_view rest = required->second;
    while (true) {
        const std::size_t begin = rest.find_first_not_of(blanks);
        if (begin == rest.npos) return;
        rest.remove_prefix(begin);
        const std::string_view prefix = rest.substr(0, rest.find_first_of(blanks));
        rest.remove_prefix(prefix.size());
        const auto space = attributes.find("xmlns:" + std::string(prefix));
        if (space == attributes.end())
            refuse("it requires the extension \"" + models::part_name(prefix, "") +
                   "\", which it does not declare");
        if (std::ranges::find(read_ones, space->second) == read_ones.end())
            refuse("it requires the 3MF extension " + name_of(space->second) +
                   ", which is not supported");
    }
}

} // namespace lineatlas::threemf
