#include "pen_images.hpp"

#include <vector>

#include "core/pens.hpp"

namespace lineatlas {

std::map<std::string, Image>
read_pen_images(const Style& style, const std::set<std::string>& known,
                const std::function<Image(const std::filesystem::path&)>& read) {
    std::map<std::string, Image> images;
    std::vector<std::string> marks{style.pen.mark, style.hidden_pen.mark, style.focus.mark};
    for (const PenRule& rule : style.pens)
        if (rule.mark) marks.push_back(*rule.mark);
    for (const std::string& mark : marks) {
        if (is_pen_file(mark) && !known.contains(mark) && !images.contains(mark))
            images[mark] = read(mark);
    }
    return images;
}

} // namespace lineatlas
