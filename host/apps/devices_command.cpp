#include "commands.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <epoxy/gl.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "device_probe.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "io/atomic_file.hpp"
#include "io/confinement.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"
#include "style/member_names.hpp"

namespace lineatlas::apps {
namespace {

struct DevicesOptions {
    unsigned wait = 30;
    std::filesystem::path json;
    std::vector<std::size_t> probe; ///< device and mode, in a child process
};

std::string gl_string(GLenum name) {
    return reinterpret_cast<const char*>(glGetString(name));
}

std::string kind_of(const compute::OpenClDevice& device) {
    if (device.is_cpu) return "CPU";
    return device.is_gpu ? "GPU" : "accelerator";
}

nlohmann::ordered_json describe(const compute::OpenClDevice& device, bool is_default) {
    return {{"name", device.name()},
            {"driver", device.driver_version},
            {"kind", kind_of(device)},
            {"default", is_default},
            {"gl_sharing_listed", device.has_extension("cl_khr_gl_sharing")},
            {"gl_event_listed", device.has_extension("cl_khr_gl_event")},
            {"extensions", device.extensions}};
}

/// Prints whether something works, and returns it for a file.
nlohmann::ordered_json show(std::string_view what, const Probe& probe) {
    print_output(
        fmt::format("    {:<16} {:<3}  {}\n", what, probe.works ? "yes" : "no", probe.reason));
    return {{"works", probe.works}, {"reason", probe.reason}};
}

/// The trials of a device that do not depend on the mode.
struct Trials {
    Probe kernels, frames;

    /// Whether the device is of no use. A device that takes long to build kernels may be.
    bool failed() const { return failed(kernels) || failed(frames); }

  private:
    static bool failed(const Probe& probe) { return probe.is_known && !probe.works; }
};

Trials try_device(std::size_t index, std::chrono::seconds limit) {
    Probe kernels = probe_kernels(index, limit);
    Probe frames = kernels.works
                       ? probe_frames(index, limit)
                       : Probe{false, "not tried: not all kernels are known to compile", false};
    return {std::move(kernels), std::move(frames)};
}

/// Prints a device and its modes while they are tried, and returns them.
nlohmann::ordered_json show_device(const std::vector<compute::OpenClDevice>& devices,
                                   std::size_t index, const Trials& trials, bool is_default,
                                   std::chrono::seconds limit) {
    const compute::OpenClDevice& device = devices[index];
    print_output(fmt::format("{} {}\n", is_default ? "*" : " ", device.name()));
    print_output(fmt::format("    driver {}, {}\n", device.driver_version, kind_of(device)));
    nlohmann::ordered_json json = describe(device, is_default);
    json["kernels"] = show("kernels", trials.kernels);
    json["frames"] = show("frames", trials.frames);
    if (trials.failed()) return json; // no mode works then, for the same reason
    for (const interop::SharingMode mode : interop::all_modes) {
        const std::string_view name = interop::name_of(mode);
        json["modes"][std::string{name}] = show(name, probe_mode(index, mode, limit));
    }
    json["forms"] = show("forms", probe_forms(index, limit));
    return json;
}

/// The place of the device that is used by default: the best that passes its trials.
std::optional<std::size_t> find_default(const std::vector<compute::OpenClDevice>& devices,
                                        const std::vector<Trials>& trials) {
    std::vector<compute::OpenClDevice> working;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (trials[i].failed()) continue;
        working.push_back(devices[i]);
        places.push_back(i);
    }
    if (working.empty()) return std::nullopt;
    return places[interop::default_device(working)];
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
    // Strings of drivers may hold any bytes.
    const std::string text =
        json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

void list_devices(const DevicesOptions& options) {
    const gl::HeadlessContext context;
    nlohmann::ordered_json json{
        {"gl", {{"renderer", gl_string(GL_RENDERER)}, {"version", gl_string(GL_VERSION)}}},
        {"devices", nlohmann::ordered_json::array()}};
    print_output(fmt::format("GL: {} ({})\n\n", gl_string(GL_RENDERER), gl_string(GL_VERSION)));
    const std::vector<compute::OpenClDevice> devices = compute::list_opencl_devices();
    if (devices.empty()) {
        print_output(fmt::format("{}\n", in_words_of_the_tool(compute::no_device_message())));
    } else {
        const std::chrono::seconds limit{options.wait};
        std::vector<Trials> trials;
        for (std::size_t i = 0; i < devices.size(); ++i) trials.push_back(try_device(i, limit));
        const std::optional<std::size_t> chosen = find_default(devices, trials);
        for (std::size_t i = 0; i < devices.size(); ++i)
            json["devices"].push_back(show_device(devices, i, trials[i], i == chosen, limit));
        for (const std::string& cause : compute::drivers_that_fail())
            print_output(fmt::format("  not used: {}\n", cause));
        print_output(fmt::format(
            "\n{}choose another with --device or LINEATLAS_DEVICE, by any part of its "
            "names:\n  opencl:<platform>[:<device>]\n",
            chosen ? "* is used by default; " : "No device passes its trial, so cpp is used; "));
    }
    print_output("\ncpp: kernels as C++ on all cores (--compute cpp)\n");
    const std::string readers = describe(offered_confinement());
    print_output(fmt::format("\nProcesses that read models and pictures: {}\n", readers));
    json["readers"] = readers;
    if (!options.json.empty()) write_json(options.json, json);
}

} // namespace

Command setup_devices(CLI::App& app) {
    app.footer("For every OpenCL device: whether it can share buffers with OpenGL in each of the "
               "four modes,\nand why or why not. Each answer is tried, not guessed, in a process "
               "of its own, since some\ndrivers crash.");
    const auto options = std::make_shared<DevicesOptions>();
    app.add_option("--wait", options->wait, "Seconds to wait for a driver's answer")
        ->check(CLI::Range(1, 600))
        ->capture_default_str();
    app.add_option("--json", options->json, "File to write the answers to");
    app.add_option(probe_option, options->probe)->expected(2)->group(""); // hidden from --help
    return [options] {
        if (options->probe.empty()) return list_devices(*options);
        answer_probe(options->probe[0], options->probe[1]);
    };
}

} // namespace lineatlas::apps
