#include "lineatlas/style_files.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/pens.hpp"
#include "lineatlas/error.hpp"
#include "pen_rules.hpp"
#include "settings.hpp"
#include "sources/sources.hpp"
#include "toml_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

/// A style file before it is parsed.
struct StyleText {
    std::string name;
    std::string place; ///< for messages: the path in quotes, or the name of a built-in style
    fs::path path;     ///< empty for a built-in one
    std::string text;
};

std::string in_quotes(const fs::path& path) {
    return value_to_toml(SettingValue{path.string()});
}

StyleText read_file(const fs::path& path) {
    const auto refuse = [&](const char* cause) {
        return FileError(fmt::format("cannot read {}: {}", in_quotes(path), cause));
    };
    std::error_code ignored;
    if (!fs::exists(path, ignored)) throw refuse("no such file");
    if (!fs::is_regular_file(path, ignored)) throw refuse("it is no file");
    constexpr std::uintmax_t most_bytes = 1 << 20;
    const std::uintmax_t size = fs::file_size(path, ignored);
    if (size > most_bytes) throw refuse("it is larger than 1 MiB, which no style is");
    // Reads no more than the size, because files that the system generates may be endless.
    std::string text(size, '\0');
    std::ifstream file{path, std::ios::binary};
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
        throw refuse("no permission, or a damaged disk");
    return {.name = path.stem().string(),
            .place = in_quotes(path),
            .path = path,
            .text = std::move(text)};
}

std::vector<StyleText> built_in_styles() {
    std::vector<StyleText> styles;
    for (const EmbeddedSource& source : embedded_styles()) {
        const std::string name = fs::path{source.name}.stem().string();
        styles.push_back({.name = name,
                          .place = fmt::format("built-in style \"{}\"", name),
                          .path = {},
                          .text = std::string{source.text}});
    }
    return styles;
}

/// The styles that have a name.
std::vector<StyleText> shipped_styles() {
    const char* folder = std::getenv("LINEATLAS_STYLE_DIR");
    if (folder == nullptr) return built_in_styles();
    std::vector<StyleText> styles;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{folder, error}) {
        if (entry.path().extension() == ".toml") styles.push_back(read_file(entry.path()));
    }
    if (error) {
        throw FileError(fmt::format("cannot read the folder {} that LINEATLAS_STYLE_DIR names: {}",
                                    in_quotes(folder), error.message()));
    }
    std::ranges::sort(styles, {}, &StyleText::name);
    return styles;
}

/// `from`: the folder of the including file. A text without '/' and '.' is the name of a style.
StyleText find_style(const std::string& name, const fs::path& from) {
    if (name.find_first_of("./") != std::string::npos) return read_file(from / name);
    const std::vector<StyleText> styles = shipped_styles();
    const auto found = std::ranges::find(styles, name, &StyleText::name);
    if (found != styles.end()) return *found;
    std::vector<std::string> names;
    for (const StyleText& style : styles) names.push_back(style.name);
    std::string advice = suggestion(name, names);
    if (advice.empty()) {
        advice = fmt::format("; there is {}, or a file by its path", fmt::join(names, ", "));
    }
    throw UsageError(fmt::format("there is no style {}{}", in_quotes(name), advice));
}

/// Limits the depth of keys (a.a.a.a = 1). The parser limits only the depth of values, and recurses
/// for each key.
void check_lines(const StyleText& file) {
    constexpr std::size_t longest = 4096;
    std::size_t line = 1;
    for (std::size_t at = 0; at < file.text.size(); ++line) {
        const std::size_t end = std::min(file.text.find('\n', at), file.text.size());
        if (end - at > longest)
            throw FileError(fmt::format("{} line {}: it is longer than {} characters", file.place,
                                        line, longest));
        at = end + 1;
    }
}

toml::table parse(const StyleText& file) {
    check_lines(file);
    try {
        return toml::parse(file.text);
    } catch (const toml::parse_error& error) {
        std::string cause{error.description()}; // quotes the file, line ends and all
        std::ranges::replace_if(
            cause, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
        throw FileError(
            fmt::format("{} line {}: {}", file.place, error.source().begin.line, cause));
    }
}

/// A number. Unlike value<double>() it accepts whole numbers that no double holds exactly.
std::optional<double> number_of(const toml::node& node) {
    if (const toml::value<std::int64_t>* whole = node.as_integer()) {
        return static_cast<double>(whole->get());
    }
    return node.value_exact<double>();
}

} // namespace

std::optional<SettingValue> value_of(const toml::node& node) {
    if (const auto flag = node.value_exact<bool>()) return *flag;
    if (const auto number = number_of(node)) return *number;
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (!node.is_array()) return std::nullopt;
    std::vector<double> numbers;
    for (const toml::node& element : *node.as_array()) {
        const auto number = number_of(element);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

namespace {

class StyleLoader {
  public:
    /// A built-in style, even if names stand for other styles.
    Style load_embedded(std::string_view name) {
        const std::vector<StyleText> styles = built_in_styles();
        apply(*std::ranges::find(styles, name, &StyleText::name));
        return style_;
    }

    Style load(const std::string& name) {
        apply(find_style(name, {}));
        return style_;
    }

    /// A style that is a table of a larger file.
    Style load_table(const toml::table& table, const fs::path& path) {
        apply({.name = {}, .place = in_quotes(path), .path = path, .text = {}}, table);
        return style_;
    }

  private:
    void apply(const StyleText& file) { apply(file, parse(file)); }

    void apply(const StyleText& file, const toml::table& table) {
        open_.push_back(identity(file));
        // A file's own keys count more than those of included files, wherever the include stands.
        if (const toml::node* include = table.get("include")) apply_includes(file, *include);
        for (const auto& [key, node] : table) apply_key(file, key, node);
        open_.pop_back();
    }

    static std::string identity(const StyleText& file) {
        if (file.path.empty()) return file.place;
        std::error_code ignored;
        return fs::weakly_canonical(file.path, ignored).string();
    }

    void apply_includes(const StyleText& file, const toml::node& include) {
        const auto refuse = [&](const toml::node& node, std::string_view cause) {
            return FileError(
                fmt::format("{} line {}: {}", file.place, node.source().begin.line, cause));
        };
        const auto apply_one = [&](const toml::node& node) {
            const auto name = node.value_exact<std::string>();
            if (!name) throw refuse(node, "include must be the name or path of a style, or a list");
            StyleText included;
            try {
                included = find_style(*name, file.path.parent_path());
            } catch (const Error& error) {
                throw refuse(node, fmt::format("include: {}", error.what()));
            }
            // Files that include each other several times would be read exponentially often, and
            // each level takes stack.
            if (open_.size() > most_levels) {
                throw refuse(node, fmt::format("include \"{}\" is more than {} levels deep", *name,
                                               most_levels));
            }
            if (++included_ > most_included) {
                throw refuse(node, fmt::format("include \"{}\": more than {} files are included in "
                                               "all, each counted as often as it is named",
                                               *name, most_included));
            }
            if (std::ranges::find(open_, identity(included)) != open_.end()) {
                throw refuse(node, fmt::format("include \"{}\" leads back to a file that is "
                                               "being read: a circle",
                                               *name));
            }
            apply(included);
        };
        if (const toml::array* list = include.as_array()) {
            for (const toml::node& node : *list) apply_one(node);
        } else {
            apply_one(include);
        }
    }

    void apply_key(const StyleText& file, const toml::key& key, const toml::node& node) {
        if (key == "include") return;
        try {
            if (key == "pens") return apply_pens(file, node);
            if (key == "description") {
                if (!node.is_string()) throw UsageError("description must be a text");
                return;
            }
            const Setting& setting = find_setting(key.str());
            const std::optional<SettingValue> value = value_of(node);
            if (!value) {
                throw UsageError(fmt::format("{} must be {}", setting.key, setting.values));
            }
            set_value(style_, setting, beside(file, setting, *value), key.str());
        } catch (const UsageError& error) {
            throw FileError(
                fmt::format("{} line {}: {}", file.place, key.source().begin.line, error.what()));
        }
    }

    /// Rules of a file come after those of included files. An empty list removes these.
    void apply_pens(const StyleText& file, const toml::node& node) {
        const toml::array* rules = node.as_array();
        if (rules == nullptr) throw UsageError("pens must be tables: [[pens]]");
        if (rules->empty()) style_.pens.clear();
        for (const toml::node& rule : *rules) {
            const toml::table* table = rule.as_table();
            if (table == nullptr) throw UsageError("pens must be tables: [[pens]]");
            if (style_.pens.size() == most_rules)
                throw UsageError(fmt::format("pens: there are more than {} rules", most_rules));
            style_.pens.push_back(read_rule(file, *table));
        }
    }

    static PenRule read_rule(const StyleText& file, const toml::table& table) {
        PenRule rule;
        for (const auto& [key, node] : table) {
            try {
                if (key == "match") {
                    read_match(node, rule.match);
                    continue;
                }
                const std::optional<SettingValue> value = value_of(node);
                if (!value) throw UsageError(fmt::format("pens: {} has no such value", key.str()));
                const bool is_mark = key == "pen";
                set_pen_key(rule, key.str(),
                            is_mark ? beside(file, pen_setting(key.str()), *value) : *value);
            } catch (const UsageError& error) {
                throw FileError(fmt::format("{} line {}: {}", file.place, key.source().begin.line,
                                            error.what()));
            }
        }
        return rule;
    }

    static void read_match(const toml::node& node, PenMatch& match) {
        const toml::table* table = node.as_table();
        if (table == nullptr)
            throw UsageError("pens: match must be a table: { kind = \"crease\" }");
        for (const auto& [key, value] : *table) {
            if (const auto flag = value.value_exact<bool>()) {
                set_match_key(match, key.str(), *flag);
                continue;
            }
            std::vector<std::string> texts;
            const auto add = [&texts, name = key.str()](const toml::node& one) {
                const auto text = one.value_exact<std::string>();
                if (!text) throw UsageError(fmt::format("pens: {} must be a text", name));
                texts.push_back(*text);
            };
            if (const toml::array* list = value.as_array())
                for (const toml::node& one : *list) add(one);
            else
                add(value);
            set_match_key(match, key.str(), texts);
        }
    }

    /// Image files stand beside the style that names them.
    static SettingValue beside(const StyleText& file, const Setting& setting,
                               const SettingValue& value) {
        const auto* name = std::get_if<std::string>(&value);
        if (!setting.is_mark || name == nullptr || !is_pen_file(*name)) return value;
        const fs::path path = file.path.parent_path() / *name;
        return path.has_parent_path() ? path.string() : "./" + path.string();
    }

    static constexpr std::size_t most_levels = 16;
    static constexpr std::size_t most_rules = 1000;
    static constexpr std::size_t most_included = 100;

    Style style_;
    std::size_t included_ = 0;
    std::vector<std::string> open_; ///< identities of the files being read, outermost first
};

} // namespace

toml::table read_toml(const fs::path& file) {
    return parse(read_file(file));
}

Style style_of(const toml::table& table, const fs::path& file) {
    return StyleLoader{}.load_table(table, file);
}

Style load_style(const std::string& name_or_path) {
    return StyleLoader{}.load(name_or_path);
}

Style default_style() {
    return StyleLoader{}.load_embedded("plain");
}

std::string settings_table() {
    return markdown_table(settings(), default_style());
}

std::string write_style(const Style& style, std::string_view description) {
    std::string text =
        fmt::format("description = {}\n", value_to_toml(SettingValue{std::string{description}}));
    for (const Setting& setting : settings()) {
        text += fmt::format("\n# {}: {}.\n{} = {}\n", setting.help, setting.values, setting.key,
                            value_to_toml(setting.get(style)));
    }
    if (!style.pens.empty()) {
        text += "\n# Pens of lines that match; each rule changes what it names.\n";
        text += pens_to_toml(style.pens);
    }
    return text;
}

std::vector<StyleInfo> list_styles() {
    std::vector<StyleInfo> styles;
    for (const StyleText& file : shipped_styles()) {
        styles.push_back({file.name, parse(file)["description"].value_or(std::string{})});
    }
    return styles;
}

} // namespace lineatlas
