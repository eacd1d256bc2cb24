#include "commands.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

#include <CLI/App.hpp>
#include <fmt/core.h>

#include "core/pens.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/style_files.hpp"
#include "style/settings.hpp"

namespace lineatlas::apps {
namespace {

struct StylesArguments {
    std::string name;
    bool keys = false;
    std::string pen_folder;
};

void print_list() {
    for (const StyleInfo& style : list_styles()) {
        print_output(fmt::format("{:<12}{}\n", style.name, style.description));
    }
}

void print_style(const std::string& name) {
    const Style style = load_style(name);
    const std::vector<StyleInfo> styles = list_styles();
    const auto listed = std::ranges::find(styles, name, &StyleInfo::name);
    print_output(write_style(style, listed == styles.end() ? "" : listed->description));
}

/// Writes pens at a good width for images: a texel per pixel, and room for the grain.
void write_pens(const std::filesystem::path& folder) {
    for (const PenName& pen : pen_names()) {
        const std::filesystem::path path = folder / (std::string{pen.name} + ".png");
        check_image_path(path);
        write_image(path, image_of_pen(make_pen(pen.name, 16)));
        print_output(fmt::format("{:<10}{}\n", pen.name, pen.description));
    }
}

} // namespace

Command setup_styles(CLI::App& app) {
    auto arguments = std::make_shared<StylesArguments>();
    StylesArguments& a = *arguments;
    app.add_option("NAME", a.name,
                   "A style to print as TOML, with every key: a start for your own");
    app.add_flag("--keys", a.keys, "Print every setting: what it does, its default and its range");
    app.add_option("--write-pens", a.pen_folder,
                   "Write the built-in pens as PNG files into this folder");
    app.footer("Without arguments it lists all styles.\n"
               "Examples:\n"
               "  lineatlas styles pencil > mine.toml\n"
               "  lineatlas draw model.obj -o picture.png --style ./mine.toml --width 3");
    return [arguments] {
        if (arguments->keys) {
            print_output(settings_table());
        } else if (!arguments->pen_folder.empty()) {
            write_pens(arguments->pen_folder);
        } else if (!arguments->name.empty()) {
            print_style(arguments->name);
        } else {
            print_list();
        }
    };
}

} // namespace lineatlas::apps
