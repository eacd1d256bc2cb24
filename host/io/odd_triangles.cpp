#include "odd_triangles.hpp"

#include <string_view>

#include "source_file.hpp"

namespace lineatlas {

void add_notes(const OddTriangles& odd, std::vector<std::string>& notes) {
    const auto note = [&](std::size_t count, std::string_view what) {
        if (count > 0)
            notes.push_back(counted(count, "triangle", "triangles") + ' ' + std::string(what));
    };
    note(odd.repeated, "with the same three corners as another left out");
    note(odd.collapsed, "with corners at one place left out");
    note(odd.flat, "without area seen as part of another");
}

} // namespace lineatlas
