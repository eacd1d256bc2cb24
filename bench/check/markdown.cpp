#include "markdown.hpp"

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "io/atomic_file.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

class Document {
  public:
    void heading(std::string_view text) { add("\n## {}\n\n", text); }
    void line(std::string_view text) { add("{}\n", text); }
    void table(const std::vector<std::string>& columns) {
        row(columns);
        row(std::vector<std::string>(columns.size(), "---"));
    }
    void row(const std::vector<std::string>& cells) { add("| {} |\n", fmt::join(cells, " | ")); }
    void verbatim(std::string_view text) { add("```\n{}\n```\n", text); }
    std::string text = "# What this machine did\n";

  private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    }
};

/// A member of an object; null if it is missing.
const Json& member(const Json& json, const char* name) {
    static const Json none;
    const auto found = json.find(name);
    return found != json.end() ? *found : none;
}

/// A member as text; "" if it is missing.
std::string text_of(const Json& json, const char* name) {
    const Json& value = member(json, name);
    if (value.is_null()) return "";
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string number_of(const Json& json, const char* name) {
    const Json& value = member(json, name);
    return value.is_number() ? fmt::format("{:.3g}", value.get<double>()) : "";
}

void add_machine(Document& document, const Json& report) {
    document.heading("Machine");
    for (const auto& [name, value] : report["machine"].items())
        document.line(fmt::format("- {}: {}", name, text_of(report["machine"], name.c_str())));
    if (report.contains("gl"))
        document.line(fmt::format("- GL: {}, {}", text_of(report["gl"], "renderer"),
                                  text_of(report["gl"], "version")));
    for (const Json& device : member(report, "devices")) {
        document.line(
            fmt::format("\n{}, driver {}\n", text_of(device, "name"), text_of(device, "driver")));
        document.table({"", "works", "why"});
        const auto answer = [&](const std::string& what, const Json& json) {
            document.row(
                {what, member(json, "works") == true ? "yes" : "no", text_of(json, "reason")});
        };
        for (const char* what : {"kernels", "frames"})
            if (device.contains(what)) answer(what, device[what]);
        for (const auto& [mode, json] : member(device, "modes").items()) answer(mode, json);
        if (device.contains("forms")) answer("forms", device["forms"]);
    }
}

void add_outcomes(Document& document, const Json& parts) {
    document.heading("Parts");
    document.table({"part", "outcome", "seconds", "tests", "failed"});
    for (const Json& part : parts) {
        const Json& tests = member(part, "tests");
        document.row({text_of(part, "name"), text_of(part, "outcome"), number_of(part, "seconds"),
                      text_of(tests, "tests"), text_of(tests, "failures")});
    }
    for (const Json& part : parts) {
        for (const Json& failed : member(member(part, "tests"), "failed"))
            document.line(
                fmt::format("\n{}: {}", text_of(failed, "name"), text_of(failed, "message")));
    }
}

/// The figures of all parts whose names begin with `beginning`, in the order of the parts.
std::vector<Json> figures_of(const Json& parts, std::string_view beginning) {
    std::vector<Json> result;
    for (const Json& part : parts)
        if (text_of(part, "name").starts_with(beginning) && part.contains("figures") &&
            part["figures"].is_object())
            result.push_back(part["figures"]);
    return result;
}

void add_frames(Document& document, const Json& parts) {
    const std::vector<Json> all = figures_of(parts, "frames ");
    if (all.empty()) return;
    document.heading("Frames: milliseconds, medians");
    document.table({"scene", "method", "frame", "over OGL", "stages, each with a wait after it"});
    for (const Json& figures : all) {
        for (const auto& [scene, json] : member(figures, "scenes").items()) {
            const Json& methods = member(json, "methods");
            for (const auto& [method, measured] : methods.items()) {
                std::vector<std::string> stages;
                for (const auto& [stage, time] : member(measured, "stages").items())
                    stages.push_back(fmt::format("{} {:.3g}", stage, time.get<double>()));
                std::string ratio;
                if (methods.contains("OGL"))
                    ratio = fmt::format("{:.2f}", methods["OGL"]["ms"].get<double>() /
                                                      measured["ms"].get<double>());
                document.row({scene, method, number_of(measured, "ms"), ratio,
                              fmt::format("{}", fmt::join(stages, ", "))});
            }
        }
    }
}

void add_interop(Document& document, const Json& parts) {
    const std::vector<Json> all = figures_of(parts, "interop ");
    if (all.empty()) return;
    document.heading("Handing buffers over: milliseconds, medians");
    document.table({"device", "mode", "KiB", "to compute", "to GL", "memcpy of the host"});
    for (const Json& figures : all) {
        for (const Json& cost : member(figures, "handovers"))
            document.row({text_of(cost, "device"), text_of(cost, "mode"),
                          std::to_string(cost["bytes"].get<std::size_t>() / 1024),
                          number_of(cost, "to_compute_ms"), number_of(cost, "to_gl_ms"),
                          number_of(cost, "memcpy_ms")});
    }
}

/// A number as a share of another one, in percent; "" if one of both is missing.
std::string share_of(const Json& json, const char* name, const Json& roof) {
    const Json& value = member(json, name);
    if (!value.is_number() || !roof.is_number() || roof <= 0) return "";
    return fmt::format("{:.3g}", 100 * value.get<double>() / roof.get<double>());
}

void add_bounds(Document& document, const Json& parts) {
    for (const Json& part : parts) {
        const std::string name = text_of(part, "name");
        const Json& figures = member(part, "figures");
        if (!name.starts_with("bounds ") || !figures.is_object()) continue;
        const Json& roofs = member(figures, "roofs");
        document.heading("Why kernels take their time: a frame by " + name.substr(7));
        document.line(fmt::format("A copy moves {} GB/s; the device does {} Gop/s.\n",
                                  number_of(roofs, "copy_gb_per_s"),
                                  number_of(roofs, "arithmetic_gop_per_s")));
        document.table({"stage", "kernel", "us", "10 %", "90 %", "launches", "MB", "% of a copy",
                        "Mop", "% of the device", "bound by", "cores", "local bytes",
                        "private bytes", "multiple", "largest group", "registers",
                        "resident items"});
        const auto millions = [](const Json& kernel, const char* key) {
            const Json& value = member(kernel, key);
            return value.is_number() ? fmt::format("{:.3g}", value.get<double>() * 1e-6) : "";
        };
        for (const Json& kernel : member(figures, "kernels"))
            document.row({text_of(kernel, "stage"), text_of(kernel, "kernel"),
                          number_of(kernel, "median_us"), number_of(kernel, "p10_us"),
                          number_of(kernel, "p90_us"), text_of(kernel, "launches"),
                          millions(kernel, "bytes"),
                          share_of(kernel, "gb_per_s", member(roofs, "copy_gb_per_s")),
                          millions(kernel, "operations"),
                          share_of(kernel, "gop_per_s", member(roofs, "arithmetic_gop_per_s")),
                          text_of(kernel, "bound"), number_of(kernel, "cores"),
                          text_of(kernel, "local_bytes"), text_of(kernel, "private_bytes"),
                          text_of(kernel, "group_multiple"), text_of(kernel, "largest_group"),
                          text_of(kernel, "registers"), text_of(kernel, "resident_items")});
    }
}

void add_kernels(Document& document, const Json& parts) {
    for (const Json& figures : figures_of(parts, "kernels")) {
        document.heading("Kernels at 4,194,304 elements: microseconds, and speed beside a copy");
        document.table({"kernel", "us", "GB/s", "of a copy"});
        for (const Json& row : member(figures, "benchmarks")) {
            std::string name = text_of(row, "name");
            name = name.substr(0, name.find("/4194304"));
            const Json& bytes = member(row, "bytes_per_second");
            document.row({name, number_of(row, "real_time"),
                          bytes.is_number() ? fmt::format("{:.3g}", bytes.get<double>() / 1e9) : "",
                          number_of(row, "share_of_copy")});
        }
    }
}

/// Adds all pictures. Those of one model share a row.
void add_pictures(Document& document, const Json& parts) {
    std::vector<std::string> names, pictures;
    const auto end_row = [&] {
        if (names.empty()) return;
        document.line("");
        document.table(names);
        document.row(pictures);
        names.clear();
        pictures.clear();
    };
    bool any = false;
    for (const Json& part : parts) {
        const std::string name = text_of(part, "name"), picture = text_of(part, "picture");
        if (picture.empty()) continue;
        if (!any) document.heading("Pictures: by the machine's device, and by C++");
        any = true;
        if (!names.empty() && !name.starts_with(names.front())) end_row();
        names.push_back(name);
        pictures.push_back(fmt::format("![{}]({})", name, picture));
    }
    end_row();
}

void add_differences(Document& document, const Json& parts) {
    bool any = false;
    for (const Json& part : parts) {
        for (const auto& [whose, compared] : member(part, "compared").items()) {
            if (!any) {
                document.line("");
                document.table(
                    {"picture", "beside", "pixels", "that differ", "by more than a twentieth"});
            }
            any = true;
            document.row({text_of(part, "name"), whose, text_of(compared, "pixels"),
                          text_of(compared, "differ"), text_of(compared, "differ_clearly")});
        }
    }
}

void add_output(Document& document, const Json& parts) {
    for (const Json& part : parts) {
        if (!part.contains("output") || text_of(part, "output").empty()) continue;
        document.heading(text_of(part, "name"));
        document.verbatim(text_of(part, "output"));
    }
}

} // namespace

void write_markdown(const std::filesystem::path& path, const Json& report) {
    Document document;
    const Json& parts = report["parts"];
    add_machine(document, report);
    add_outcomes(document, parts);
    add_frames(document, parts);
    add_interop(document, parts);
    add_bounds(document, parts);
    add_kernels(document, parts);
    add_pictures(document, parts);
    add_differences(document, parts);
    add_output(document, parts);
    AtomicFile{path}.commit(
        {reinterpret_cast<const unsigned char*>(document.text.data()), document.text.size()});
}

} // namespace lineatlas::bench
