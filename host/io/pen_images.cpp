#include "pen_images.hpp"

#include "core/pens.hpp"

namespace lineatlas {

std::map<std::string, Image>
read_pen_images(const Style& style, const std::set<std::string>& known,
                const std::function<Image(const std::filesystem::path&)>& read) {
    std::map<std::string, Image> images;
    for (const std::string& mark : {style.pen.mark, style.hidden_pen.mark, style.focus.mark}) {
        if (is_pen_file(mark) && !known.contains(mark) && !images.contains(mark))
            images[mark] = read(mark);
    }
    return images;
}

} // namespace lineatlas
