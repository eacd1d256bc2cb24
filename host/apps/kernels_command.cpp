#include "commands.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "io/standard_streams.hpp"
#include "kernel_assembly.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

using compute::Access;
using compute::Kernel;

/// The forms of one kernel, which follow one another in all_kernels().
std::span<const Kernel> forms_of(std::string_view name) {
    const std::span<const Kernel> all = compute::all_kernels();
    const auto first = std::ranges::find(all, name, &Kernel::name);
    const auto is_other = [&](const Kernel& kernel) { return kernel.name != name; };
    return {first, std::find_if(first, all.end(), is_other)};
}

/// The macros of each form; empty for a kernel that has only one and needs none.
std::string describe(std::span<const Kernel> forms) {
    std::vector<std::string_view> defines;
    for (const Kernel& form : forms) defines.push_back(form.defines);
    if (defines.size() > 1 && defines.front().empty()) defines.front() = "none";
    return fmt::format("{}{}", fmt::join(defines, ", "),
                       forms.front().has_barriers ? " (barriers)" : "");
}

void print_list() {
    std::string text = fmt::format("{:<17}{:<24}{:<14}{}\n", "program", "kernel", "stage", "forms");
    const std::span<const Kernel> all = compute::all_kernels();
    for (std::size_t i = 0; i < all.size(); i += forms_of(all[i].name).size()) {
        text += fmt::format("{:<17}{:<24}{:<14}{}", all[i].file(), all[i].name, all[i].stage,
                            describe(forms_of(all[i].name)));
        text.erase(text.find_last_not_of(' ') + 1) += '\n';
    }
    print_output(text);
}

const char* name_of(Access access) {
    switch (access) {
    case Access::in:
        return "in";
    case Access::out:
        return "out";
    case Access::inout:
        return "inout";
    case Access::unordered:
        return "unordered";
    }
    return "unknown";
}

/// The files of which `source` consists, each once, as its line directives name them.
std::vector<std::string_view> files_in(std::string_view source) {
    constexpr std::string_view directive = "#line 1 \"";
    std::vector<std::string_view> files;
    for (std::size_t at = source.find(directive); at != source.npos;
         at = source.find(directive, at)) {
        at += directive.size();
        const std::string_view file = source.substr(at, source.find('"', at) - at);
        if (std::ranges::find(files, file) == files.end()) files.push_back(file);
    }
    return files;
}

/// The part of `text` from `begin` up to `end`; empty if `begin` is missing.
std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
    const std::size_t first = text.find(begin);
    if (first == text.npos) return {};
    text.remove_prefix(first + begin.size());
    return text.substr(0, text.find(end));
}

/// A struct as the kernel's source declares it.
std::string declaration_of(std::string_view type, std::string_view source) {
    const std::string end = fmt::format("}} {};\n", type);
    const std::string begin = fmt::format("typedef struct {} {{", type);
    return fmt::format("{}{}{}", begin, between(source, begin, end), end);
}

/// `text` as comments, one per line. It may have comments itself.
std::string commented(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
        result.append(length > 1 ? "// " : "//").append(text.substr(0, length));
        text.remove_prefix(length);
    }
    return result;
}

std::string describe(const Kernel& kernel, std::string_view source) {
    const std::vector<std::string_view> files = files_in(source);
    const std::string forms = describe(forms_of(kernel.name));
    const std::string_view parameters =
        between(source, fmt::format("KERNEL({}, ", kernel.name), ")");
    std::string text =
        fmt::format("{}: a kernel of the stage {}\nfiles: {}\nforms: {}\n\n", kernel.name,
                    kernel.stage, fmt::join(files, ", "), forms.empty() ? "one" : forms);
    text += fmt::format("parameters, {} bytes:\n{}\n", kernel.parameter_size,
                        declaration_of(parameters, source));
    text += fmt::format("{:<24}{:<11}{:<17}{:>7}\n", "table", "access", "elements", "bytes");
    for (const compute::KernelTable& table : kernel.tables)
        text += fmt::format("{:<24}{:<11}{:<17}{:>7}\n", table.name, name_of(table.access),
                            table.type, table.element_size);
    return text;
}

struct KernelsArguments {
    std::string name;
    bool assembly = false;
    std::string form;
    std::string device;
};

/// The form that the arguments choose.
const Kernel& chosen_kernel(const KernelsArguments& arguments) {
    const std::span<const Kernel> forms = forms_of(arguments.name);
    if (forms.empty()) {
        throw UsageError(fmt::format("there is no kernel \"{}\"; `lineatlas kernels` lists all",
                                     arguments.name));
    }
    if (arguments.form.empty()) return forms.front();
    const auto chosen = std::ranges::find(forms, arguments.form, &Kernel::defines);
    if (chosen != forms.end()) return *chosen;
    throw UsageError(fmt::format("the kernel {} has no form \"{}\"; `lineatlas kernels` lists "
                                 "those there are",
                                 arguments.name, arguments.form));
}

void print_kernel(const KernelsArguments& arguments) {
    const Kernel& kernel = chosen_kernel(arguments);
    if (arguments.assembly) return print_output(assembly_of(kernel, arguments.device));
    const std::string source = source_of(kernel);
    print_output(commented(describe(kernel, source)) + "\n" + source);
}

} // namespace

Command setup_kernels(CLI::App& app) {
    const auto arguments = std::make_shared<KernelsArguments>();
    KernelsArguments& a = *arguments;
    auto* name =
        app.add_option("NAME", a.name,
                       "A kernel to print: what it is, its parameters and tables, and its source "
                       "with all that it includes");
    auto* assembly = app.add_flag("--assembly", a.assembly,
                                  "Print what the compiler made of it: its loops, and how many "
                                  "numbers they work on at once, then its instructions")
                         ->needs(name);
    app.add_option("--form", a.form, "One of its forms, as the list has them; else the first")
        ->needs(assembly);
    app.add_option(
           "--device", a.device,
           "With --assembly: the device whose compiler is asked, opencl:<platform>[:<device>]; "
           "without it the kernel as C++")
        ->needs(assembly);
    app.footer("Without a name it lists all kernels. The source of a kernel is OpenCL C "
               "1.2.\nLINEATLAS_KERNEL_DIR names a folder of kernels in place of the built-in ones."
               "\nExamples:\n"
               "  lineatlas kernels\n"
               "  lineatlas kernels project_clip\n"
               "  lineatlas kernels atlas --assembly --form=-DPROBES_PER_AXIS=4 --device "
               "opencl:portable");
    return [arguments] { arguments->name.empty() ? print_list() : print_kernel(*arguments); };
}

} // namespace lineatlas::apps
