#include <map>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/style_files.hpp"
#include "style/pen_rules.hpp"
#include "style/settings.hpp"
#include "style_values.hpp"

namespace lineatlas::python {
namespace {

namespace py = pybind11;

/// The key in style files. Python's names may have "_" for "-".
std::string key_of(std::string name) {
    for (char& letter : name)
        if (letter == '_') letter = '-';
    return name;
}

/// A value of a rule's condition: true or false, one text or several.
std::variant<bool, std::vector<std::string>> match_value(const std::string& key,
                                                         const py::handle& value) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::str>(value)) return std::vector{value.cast<std::string>()};
    try {
        return value.cast<std::vector<std::string>>();
    } catch (const py::cast_error&) {
        throw wrong_argument("pens: " + key, "a text, or a list of them",
                             py::reinterpret_borrow<py::object>(value));
    }
}

py::dict table_of(const char* called, const py::handle& value) {
    if (py::isinstance<py::dict>(value)) return py::reinterpret_borrow<py::dict>(value);
    throw wrong_argument(called, "a dict", py::reinterpret_borrow<py::object>(value));
}

PenRule rule_of(const py::handle& given) {
    PenRule rule;
    for (const auto& [name, value] : table_of("a rule of pens", given)) {
        const std::string key = key_of(py::str(name));
        if (key == "match") {
            for (const auto& [asked, names] : table_of("match", value))
                set_match_key(rule.match, std::string{py::str(asked)},
                              match_value(py::str(asked), names));
            continue;
        }
        const auto object = py::reinterpret_borrow<py::object>(value);
        const std::optional<SettingValue> own = setting_value(object);
        if (!own) throw wrong_argument("pens: " + key, "a value as in style files", object);
        set_pen_key(rule, key, *own);
    }
    return rule;
}

std::vector<PenRule> rules_of(const py::object& value) {
    if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value))
        throw wrong_argument("pens", "a list of dicts, one per rule", value);
    std::vector<PenRule> rules;
    for (const py::handle rule : value) rules.push_back(rule_of(rule));
    return rules;
}

py::list list_of(const std::vector<PenRule>& rules) {
    py::list list;
    for (const PenRule& rule : rules) {
        py::dict match, own;
        if (!rule.match.kinds.empty()) match["kind"] = rule.match.kinds;
        if (!rule.match.object.empty()) match["object"] = rule.match.object;
        if (!rule.match.material.empty()) match["material"] = rule.match.material;
        if (rule.match.hidden) match["hidden"] = true;
        own["match"] = match;
        for (const auto& [key, value] : pen_values(rule)) own[py::str(key)] = python_value(value);
        list.append(own);
    }
    return list;
}

constexpr const char* pens_key = "pens";

void set(Style& style, const std::string& name, const py::object& value) {
    if (name == pens_key) {
        style.pens = rules_of(value);
        return;
    }
    const Setting& setting = find_setting(key_of(name));
    const std::optional<SettingValue> given = setting_value(value);
    if (!given) throw wrong_argument(setting.key, setting.values, value);
    set_value(style, setting, *given, setting.key);
}

py::object get(const Style& style, const std::string& name) {
    if (name == pens_key) return list_of(style.pens);
    return python_value(find_setting(key_of(name)).get(style));
}

Style make_style(const BaseArgument& base, const py::kwargs& changes) {
    Style style = *base ? load_style((*base)->string()) : Style{};
    for (const auto& [name, value] : changes)
        set(style, py::str(name), py::reinterpret_borrow<py::object>(value));
    return style;
}

py::dict all_settings(const Style& style) {
    py::dict values;
    for (const Setting& setting : settings())
        values[py::str(setting.key)] = python_value(setting.get(style));
    values[pens_key] = list_of(style.pens);
    return values;
}

std::string describe(const Style& style) {
    const Style defaults;
    std::string text = "<lineatlas.Style";
    for (const Setting& setting : settings()) {
        const std::string value = value_to_toml(setting.get(style));
        if (value != value_to_toml(setting.get(defaults))) text += " " + setting.key + "=" + value;
    }
    if (!style.pens.empty()) text += fmt::format(" pens={} rules", style.pens.size());
    return text + ">";
}

} // namespace

Style style_of(const std::optional<StyleOrName>& given) {
    if (!given) return default_style();
    if (const auto* name = std::get_if<std::filesystem::path>(&*given))
        return load_style(name->string());
    return std::get<Style>(*given);
}

std::optional<SettingValue> setting_value(const py::object& value) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::detail::make_caster<std::string> text; text.load(value, false))
        return value_from_text(py::detail::cast_op<std::string&>(text));
    if (py::detail::make_caster<double> number; number.load(value, true))
        return py::detail::cast_op<double>(number);
    if (py::detail::make_caster<std::vector<double>> list; list.load(value, true))
        return py::detail::cast_op<std::vector<double>&>(list);
    return std::nullopt;
}

py::object python_value(const SettingValue& value) {
    return std::visit([](const auto& held) { return py::cast(held); }, value);
}

void bind_style(py::module_& module) {
    py::class_<Style>(
        module, "Style",
        "How a drawing looks: pens, colours, hidden lines, effects, paper.\n\n"
        "base: name of a style that ships, or path of a style file; none: plain black lines.\n"
        "Settings are those of style files, with \"_\" for \"-\": Style(\"pencil\", width=3,\n"
        "fill_color=\"navy\"). They are read and changed as items: style[\"width\"] = 4.\n"
        "\"pens\" is a list of rules, each a dict as in style files:\n"
        "style[\"pens\"] = [{\"match\": {\"kind\": \"outline\"}, \"width\": 3}].")
        .def(py::init(&make_style), py::arg("base") = py::none())
        .def("__getitem__", &get, py::arg("key"), "The value of a setting.")
        .def("__setitem__", &set, py::arg("key"), py::arg("value"), "Changes a setting.")
        .def("settings", &all_settings, "All settings and their values.")
        .def(
            "to_toml",
            [](const Style& style, const std::string& description) {
                return write_style(style, description);
            },
            py::arg("description") = "", "The style as the text of a style file.")
        .def("__repr__", &describe);
    module.def(
        "styles",
        [] {
            py::dict names;
            for (const StyleInfo& style : list_styles())
                names[py::str(style.name)] = style.description;
            return names;
        },
        "The styles that ship, by name, with a line about each.");
}

} // namespace lineatlas::python
