#include "parts.hpp"

namespace lineatlas::bench {

using std::chrono::seconds;

std::string output_option(PartKind kind, const std::filesystem::path& file) {
    const std::string name = file.string();
    if (kind == PartKind::tests) return "--gtest_output=xml:" + name;
    return (kind == PartKind::kernels ? "--kernels=" : "--json=") + name;
}

std::vector<Part> all_parts(const Places& places) {
    const auto test = [](const std::string& name, seconds limit, const std::string& filter = "*") {
        return Part{name, PartKind::tests, "tests/" + name, {"--gtest_filter=" + filter}, limit};
    };
    const auto figures = [](const std::string& name, const std::string& program,
                            std::vector<std::string> arguments, seconds limit) {
        return Part{name, PartKind::figures, "bin/lineatlas-bench-" + program, std::move(arguments),
                    limit};
    };
    // Each sharing mode gets a process of its own, because a driver may crash in one of them.
    const auto interop = [&](const std::string& mode) {
        return figures("interop " + mode, "interop", {"--modes", mode, "--rounds", "15"},
                       seconds{40});
    };
    // One part per scene: a slow machine still gets figures for the first scenes.
    const auto frames = [&](const std::string& scene) {
        return figures(
            "frames " + scene, "frames",
            {"--scenes", scene, "--methods", "OGL", "SAlo", "SAhi", "EX", "--frames", "10"},
            seconds{100});
    };
    const auto drawn = [&](const std::string& name, const std::vector<std::string>& options,
                           seconds limit) {
        std::vector<std::string> arguments{"draw", "--scene", "ship", "-o",
                                           (places.scratch / "ship.png").string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return Part{name, PartKind::output, "bin/lineatlas", std::move(arguments), limit};
    };
    // A picture for the report, drawn by the machine's own device or by `cpp`.
    const auto picture = [&](const std::string& of, const std::vector<std::string>& model,
                             const std::string& device) {
        const std::string file = of + "-" + (device.empty() ? "device" : device) + ".png";
        Part part{device.empty() ? of : of + " " + device,
                  PartKind::output,
                  "bin/lineatlas",
                  {},
                  seconds{60},
                  file,
                  {{"the bundle's", places.shipped / (of + ".png")}}};
        if (!device.empty())
            part.others.emplace_back("the device's", places.pictures / (of + "-device.png"));
        part.arguments = {"draw", "-o", (places.pictures / file).string()};
        part.arguments.insert(part.arguments.end(), model.begin(), model.end());
        if (!device.empty()) part.arguments.insert(part.arguments.end(), {"--compute", device});
        return part;
    };
    const std::vector<std::string> ship{"--scene", "ship"};
    const std::vector<std::string> contours{
        places.scan.string(), "--up", "z", "--silhouettes", "smooth", "--lines", "silhouette"};
    // Compares the tables of every kernel with those of `cpp`. Scans have smooth silhouettes.
    const auto compared = [&](const std::string& method) {
        return drawn("compared " + method,
                     {"--size", "512x384", "--method", method, "--silhouettes", "smooth",
                      "--compute", "opencl", "--compare-with", "cpp"},
                     seconds{60});
    };
    const auto profiled = [&](const std::string& method, const std::string& depth,
                              const std::string& strokes) {
        std::vector<std::string> options{"--method", method, "--size",    "1024x768",
                                         "--repeat", "10",   "--profile", "-",
                                         "--depth",  depth,  "--strokes", strokes};
        return drawn("forms " + method + " " + depth + " " + strokes, options, seconds{60});
    };
    const auto bounds = [&](const std::string& method) {
        Part part = drawn(
            "bounds " + method,
            {"--method", method, "--size", "1024x768", "--repeat", "10", "--compute", "opencl"},
            seconds{100});
        part.kind = PartKind::kernels;
        return part;
    };
    return {
        {"devices", PartKind::devices, "bin/lineatlas", {"devices", "--wait", "15"}, seconds{100}},
        picture("picture", ship, ""),
        compared("atlas"),
        compared("exact"),
        frames("ship"),
        frames("office"),
        frames("clevis"),
        frames("house"),
        picture("picture", ship, "cpp"),
        picture("scan", contours, ""),
        picture("scan", contours, "cpp"),
        profiled("atlas", "raster", "raster"),
        profiled("atlas", "compute", "raster"),
        profiled("atlas", "compute", "compute"),
        profiled("exact", "auto", "auto"),
        interop("gl-sharing"),
        interop("external-memory"),
        interop("host-pointer"),
        interop("copy"),
        test("sharing_modes_test", seconds{60}),
        figures("kernels", "kernels",
                {"--benchmark_filter=(ours|copy|device_.*)/4194304/", "--benchmark_min_time=0.05"},
                seconds{180}),
        test("stages_test", seconds{240}),
        test("compute_test", seconds{90}),
        test("pictures_test", seconds{90}, "*clevis*"),
        bounds("atlas"),
        bounds("exact"),
    };
}

} // namespace lineatlas::bench
