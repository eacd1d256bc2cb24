#include "session_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <glm/geometric.hpp>

#include "io/source_file.hpp"
#include "joined_models.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/style_files.hpp"
#include "style/frame_settings.hpp"
#include "style/toml_file.hpp"
#include "values.hpp"

namespace lineatlas {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = "session"; ///< the key that a session begins with
constexpr std::int64_t version = 1;
constexpr double radians_per_degree = std::numbers::pi / 180;

/// Options beside frame_settings() that say what is drawn and how. None of them names an output
/// file.
constexpr std::array<std::string_view, 10> other_options{
    "size", "crease", "silhouettes", "smooth-edges", "deflection",
    "only", "hide",   "explode",     "section",      "hatching"};

bool is_option(std::string_view key) {
    return std::ranges::find(other_options, key) != other_options.end() ||
           std::ranges::find(frame_settings(), key, &FrameSetting::key) != frame_settings().end();
}

std::vector<std::string> known_keys() {
    std::vector<std::string> keys{std::string{mark}, "model",      "scene",       "views",
                                  "style",           "style-name", "sections-off"};
    keys.insert(keys.end(), other_options.begin(), other_options.end());
    for (const FrameSetting& setting : frame_settings()) keys.push_back(setting.key);
    return keys;
}

/// The value of an option as a word; it may be a number in the file.
std::string as_word(const toml::node& node) {
    const std::optional<SettingValue> value = value_of(node);
    if (value && std::holds_alternative<std::string>(*value)) return std::get<std::string>(*value);
    if (value && (std::holds_alternative<double>(*value) || std::holds_alternative<bool>(*value)))
        return value_to_toml(*value);
    throw UsageError("it must be a text, a number or a list of texts");
}

/// Throws UsageError.
void check(const SessionFile::Option& option) {
    for (const std::string& value : option.values) {
        if (option.key == "size") parse_size("size", value);
        if (option.key == "crease") parse_crease("crease", value);
        if (option.key == "silhouettes") parse_silhouettes("silhouettes", value);
        if (option.key == "section") parse_section(value, {{0, 0, 0}, {1, 1, 1}});
    }
    if (option.key == "section" && option.values.size() > most_sections)
        throw UsageError(fmt::format("section has {} planes at most, not {}", most_sections,
                                     option.values.size()));
    FrameSettings checked;
    for (const FrameSetting& setting : frame_settings()) {
        if (setting.key != option.key) continue;
        for (const std::string& value : option.values)
            set_value(checked, setting, value_from_text(value), option.key);
    }
}

/// Reads one file; every message names it.
class Reader {
  public:
    explicit Reader(fs::path file) : file_(std::move(file)) {}

    SessionFile read() {
        const toml::table table = read_toml(file_);
        const auto found = table.get(mark);
        if (found == nullptr) {
            throw FileError(quoted(file_) + " is no session: these begin with \"session = 1\"; a "
                                            "style is taken by --style");
        }
        if (found->value<std::int64_t>() != version)
            throw at(*found, fmt::format("this program reads sessions of version {}", version));
        session_.style = default_style();
        for (const auto& [key, node] : table) {
            try {
                take(key.str(), node);
            } catch (const UsageError& error) {
                const std::string cause = error.what();
                const bool named = cause.starts_with(key.str());
                throw at(node, named ? cause : fmt::format("{}: {}", key.str(), cause));
            }
        }
        if (session_.models.empty() == session_.scene.empty())
            throw FileError(quoted(file_) + ": it needs a \"model\" or a \"scene\", not both");
        return std::move(session_);
    }

  private:
    FileError at(const toml::node& node, const std::string& cause) const {
        return FileError(
            fmt::format("{} line {}: {}", quoted(file_), node.source().begin.line, cause));
    }

    void take(std::string_view key, const toml::node& node) {
        if (key == mark) return;
        if (key == "model") {
            for (const std::string& model : words(node))
                if (!model.empty()) session_.models.push_back(file_.parent_path() / model);
            if (session_.models.size() > most_models)
                throw UsageError(fmt::format("model has {} files at most, not {}", most_models,
                                             session_.models.size()));
        } else if (key == "scene") {
            session_.scene = as_word(node);
        } else if (key == "views") {
            take_views(node);
        } else if (key == "style-name") {
            session_.style_name = as_word(node);
        } else if (key == "style") {
            const toml::table* table = node.as_table();
            if (table == nullptr) throw UsageError("it must be a table: [style]");
            session_.style = style_of(*table, file_);
        } else if (key == "sections-off") {
            session_.sections_off = words(node);
            check({"section", session_.sections_off});
        } else if (is_option(key)) {
            session_.options.push_back({std::string{key}, words(node)});
            check(session_.options.back());
        } else {
            throw UsageError("a session has no such key" + suggestion(key, known_keys()));
        }
    }

    static std::vector<std::string> words(const toml::node& node) {
        const toml::array* list = node.as_array();
        if (list == nullptr) return {as_word(node)};
        std::vector<std::string> result;
        for (const toml::node& one : *list) result.push_back(as_word(one));
        return result;
    }

    void take_views(const toml::node& node) {
        const toml::array* list = node.as_array();
        constexpr std::size_t most = 1000;
        if (list == nullptr || list->empty() || list->size() > most)
            throw UsageError(fmt::format("these must be 1 to {} tables: [[views]]", most));
        for (const toml::node& one : *list) {
            const toml::table* table = one.as_table();
            if (table == nullptr) throw UsageError("these must be tables: [[views]]");
            try {
                session_.views.push_back(view(*table));
            } catch (const UsageError& error) {
                throw at(one, fmt::format("views: {}", error.what()));
            }
        }
    }

    static SessionFile::NamedView view(const toml::table& table) {
        SessionFile::NamedView result;
        for (const auto& [key, node] : table) {
            if (key == "name")
                result.name = as_word(node);
            else if (key == "eye")
                result.eye = vector(key.str(), node);
            else if (key == "target")
                result.target = vector(key.str(), node);
            else if (key == "up")
                result.up = vector(key.str(), node);
            else if (key == "fov")
                result.fov = fov(node);
            else if (key == "projection")
                result.projection = parse_projection(as_word(node));
            else
                throw UsageError(fmt::format("there is no \"{}\", but name, eye, target, up, fov "
                                             "and projection",
                                             key.str()));
        }
        if (result.eye == result.target)
            throw UsageError("eye and target must be two different points");
        if (glm::length(result.up) == 0) throw UsageError("up must not be the zero vector");
        return result;
    }

    static glm::dvec3 vector(std::string_view key, const toml::node& node) {
        const std::optional<SettingValue> value = value_of(node);
        const auto* numbers = value ? std::get_if<std::vector<double>>(&*value) : nullptr;
        const auto good = [](double number) { return std::abs(number) <= 1e15; }; // false for NaN
        if (numbers == nullptr || numbers->size() != 3 || !std::ranges::all_of(*numbers, good))
            throw UsageError(
                fmt::format("{} must be three finite numbers, as in [1, 2.5, -3]", key));
        return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    }

    static float fov(const toml::node& node) {
        const std::optional<SettingValue> value = value_of(node);
        const double* degrees = value ? std::get_if<double>(&*value) : nullptr;
        if (degrees == nullptr || !(*degrees >= 0.01 && *degrees <= 179.9))
            throw UsageError("fov must be a number from 0.01 to 179.9");
        return static_cast<float>(*degrees);
    }

    fs::path file_;
    SessionFile session_;
};

std::string text(const std::string& word) {
    return value_to_toml(SettingValue{word});
}

std::string list(const std::vector<std::string>& words) {
    std::vector<std::string> texts;
    for (const std::string& word : words) texts.push_back(text(word));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}

/// A line of the file.
std::string entry(const std::string& key, const std::vector<std::string>& values) {
    return fmt::format("{} = {}\n", key, values.size() == 1 ? text(values.front()) : list(values));
}

/// Paths relative to a folder if they are below it.
std::vector<std::string> named_from(const fs::path& folder, const std::vector<fs::path>& files) {
    std::vector<std::string> result;
    for (const fs::path& file : files) {
        const fs::path whole = fs::absolute(file).lexically_normal();
        const fs::path near = whole.lexically_relative(fs::absolute(folder).lexically_normal());
        const bool below = !near.empty() && *near.begin() != "..";
        result.push_back((below ? near : whole).string());
    }
    return result;
}

std::string vector(glm::dvec3 v) {
    return fmt::format("[{}, {}, {}]", shortest(v.x), shortest(v.y), shortest(v.z));
}

/// A style as a table: its lines, and its tables, stand below [style].
std::string style_table(const Style& style) {
    std::string lines = write_style(style);
    const std::string_view tables = "[[pens]]";
    for (std::size_t at = 0; (at = lines.find(tables, at)) != std::string::npos; ++at)
        if (at > 0 && lines[at - 1] == '\n') lines.replace(at, tables.size(), "[[style.pens]]");
    return "[style]\n" + lines;
}

} // namespace

std::string shortest(double value) {
    const auto single = static_cast<float>(value);
    return static_cast<double>(single) == value ? fmt::format("{}", single)
                                                : fmt::format("{}", value);
}

bool is_session(const fs::path& file) {
    return read_toml(file).contains(mark);
}

SessionFile read_session(const fs::path& file) {
    return Reader{file}.read();
}

std::string write_session(const SessionFile& session, const fs::path& folder) {
    std::string result = fmt::format(
        "# What lineatlas view shows; lineatlas draw draws it.\n{} = {}\n", mark, version);
    if (session.models.empty())
        result += fmt::format("scene = {}\n", text(session.scene));
    else
        result += entry("model", named_from(folder, session.models));
    for (const SessionFile::Option& option : session.options) {
        result += entry(option.key, option.values);
    }
    if (!session.sections_off.empty())
        result += fmt::format("sections-off = {}\n", list(session.sections_off));
    if (!session.style_name.empty())
        result += fmt::format("style-name = {}\n", text(session.style_name));
    for (const SessionFile::NamedView& view : session.views) {
        result += "\n[[views]]\n";
        if (!view.name.empty()) result += fmt::format("name = {}\n", text(view.name));
        result += fmt::format("eye = {}\ntarget = {}\nup = {}\nfov = {}\nprojection = {}\n",
                              vector(view.eye), vector(view.target), vector(view.up),
                              shortest(view.fov), text(std::string{name_of(view.projection)}));
    }
    return result + "\n" + style_table(session.style);
}

SessionFile::NamedView named_view(const View& view, glm::dvec3 origin, std::string name) {
    return {.name = std::move(name),
            .eye = origin + glm::dvec3{view.eye},
            .target = origin + glm::dvec3{view.target},
            .up = view.up,
            .fov = static_cast<float>(view.fov_y / radians_per_degree),
            .projection = view.projection};
}

View view_of(const SessionFile::NamedView& view, glm::dvec3 origin) {
    View result;
    result.eye = view.eye - origin;
    result.target = view.target - origin;
    result.up = glm::normalize(view.up);
    // Computed as for --fov.
    result.fov_y = view.fov * (std::numbers::pi_v<float> / 180);
    result.projection = view.projection;
    result.near = result.far = 0;
    return result;
}

} // namespace lineatlas
