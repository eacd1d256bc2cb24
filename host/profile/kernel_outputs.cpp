#include <iterator>

#include <fmt/format.h>

#include "kernel_figures.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas {
namespace {

using Json = nlohmann::ordered_json;

/// A share in percent; "-" if there is no roof.
std::string share(double value, double roof) {
    return roof > 0 ? fmt::format("{:.1f}", 100 * value / roof) : "-";
}

/// A number in units of `unit`; "-" if it is not known.
std::string number(const std::optional<double>& value, double unit = 1) {
    return value ? fmt::format("{:.2f}", *value / unit) : "-";
}

std::string per(const std::optional<double>& value, const std::optional<double>& other) {
    return value && other && *other > 0 ? fmt::format("{:.2f}", *value / *other) : "-";
}

/// A number of the driver's; "-" if the driver does not tell.
std::string told(std::uint64_t value, bool is_told) {
    return is_told ? std::to_string(value) : "-";
}

std::string time_row(const KernelTime& kernel, const Roofs& roofs) {
    return fmt::format(
        "{:<14}{:<24}{:>9}{:>11.4f}{:>9.4f}{:>9.4f}{:>9.3f}{:>9.2f}{:>9}{:>8.2f}{:>9.2f}{:>8}  "
        "{}\n",
        kernel.stage, kernel.name, kernel.launches, kernel.median * 1e-6, kernel.p10 * 1e-6,
        kernel.p90 * 1e-6, kernel.bytes * 1e-6, kernel.gigabytes_per_second,
        share(kernel.gigabytes_per_second, roofs.copy), kernel.operations * 1e-6,
        kernel.gigaops_per_second, share(kernel.gigaops_per_second, roofs.arithmetic),
        name_of(kernel.bound));
}

std::string resource_row(const KernelTime& kernel) {
    constexpr double million = 1e6, thousand = 1e3;
    const KernelResources& own = kernel.resources;
    const bool is_told = own.largest_group > 0;
    return fmt::format(
        "{:<14}{:<24}{:>9}{:>11}{:>11}{:>11}{:>9}{:>9}{:>10}{:>8}{:>11}{:>10}\n", kernel.stage,
        kernel.name, number(kernel.cores), number(kernel.instructions, million),
        per(kernel.instructions, kernel.cycles), number(kernel.cache_misses, thousand),
        told(own.local_bytes, is_told), told(own.private_bytes, is_told),
        told(own.multiple, is_told), told(own.largest_group, is_told),
        told(own.registers, own.registers > 0), told(own.resident, own.resident > 0));
}

/// A value of CSV; empty if it is not known.
std::string field(const Json& value) {
    if (value.is_null()) return {};
    return value.is_string() ? value.get<std::string>() : value.dump();
}

} // namespace

namespace {

/// What the driver tells of a kernel; empty if it tells nothing.
Json figures_of(const KernelResources& resources) {
    if (resources.largest_group == 0) return Json::object();
    const auto if_told = [](std::uint32_t value) {
        return value > 0 ? Json(value) : Json(nullptr);
    };
    return {{"largest_group", resources.largest_group},
            {"group_multiple", resources.multiple},
            {"local_bytes", resources.local_bytes},
            {"private_bytes", resources.private_bytes},
            {"registers", if_told(resources.registers)},
            {"resident_items", if_told(resources.resident)}};
}

} // namespace

Json figures_of(const KernelTime& kernel) {
    const auto if_known = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    Json json{{"launches", kernel.launches},
              {"median_us", kernel.median * 1e-3},
              {"p10_us", kernel.p10 * 1e-3},
              {"p90_us", kernel.p90 * 1e-3},
              {"bytes", kernel.bytes},
              {"operations", kernel.operations},
              {"gb_per_s", kernel.gigabytes_per_second},
              {"gop_per_s", kernel.gigaops_per_second},
              {"bound", name_of(kernel.bound)},
              {"cores", if_known(kernel.cores)},
              {"cycles", if_known(kernel.cycles)},
              {"instructions", if_known(kernel.instructions)},
              {"cache_misses", if_known(kernel.cache_misses)}};
    json.update(figures_of(kernel.resources));
    return json;
}

std::string kernel_table(std::span<const KernelTime> kernels, const Roofs& roofs) {
    std::string text =
        fmt::format("{:<14}{:<24}{:>9}{:>11}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>9}{:>8}  {}\n",
                    "stage", "kernel", "launches", "median ms", "10 %", "90 %", "MB", "GB/s",
                    "% copy", "Mop", "Gop/s", "% roof", "bound by");
    for (const KernelTime& kernel : kernels) text += time_row(kernel, roofs);
    text += fmt::format("roofs: a copy {:.2f} GB/s; products and sums {:.1f} Gop/s\n\n", roofs.copy,
                        roofs.arithmetic);
    text += fmt::format("{:<14}{:<24}{:>9}{:>11}{:>11}{:>11}{:>9}{:>9}{:>10}{:>8}{:>11}{:>10}\n",
                        "stage", "kernel", "cores", "M instr.", "per cycle", "k misses", "local B",
                        "private", "multiple", "group", "registers", "resident");
    for (const KernelTime& kernel : kernels) text += resource_row(kernel);
    return text;
}

std::string kernel_csv(std::span<const KernelTime> kernels, const Roofs& roofs) {
    std::string text =
        "stage,kernel,launches,median_us,p10_us,p90_us,bytes,operations,gb_per_s,copy_gb_per_s,"
        "gop_per_s,roof_gop_per_s,bound,cores,cycles,instructions,cache_misses,largest_group,"
        "group_multiple,local_bytes,private_bytes,registers,resident_items\n";
    for (const KernelTime& kernel : kernels) {
        fmt::format_to(std::back_inserter(text),
                       "{},{},{},{:.3f},{:.3f},{:.3f},{:.0f},{:.0f},{:.3f},{:.3f},{:.3f},{:.3f},{}",
                       kernel.stage, kernel.name, kernel.launches, kernel.median * 1e-3,
                       kernel.p10 * 1e-3, kernel.p90 * 1e-3, kernel.bytes, kernel.operations,
                       kernel.gigabytes_per_second, roofs.copy, kernel.gigaops_per_second,
                       roofs.arithmetic, name_of(kernel.bound));
        const Json figures = figures_of(kernel);
        for (const char* key :
             {"cores", "cycles", "instructions", "cache_misses", "largest_group", "group_multiple",
              "local_bytes", "private_bytes", "registers", "resident_items"})
            text += ',' + field(figures.value(key, Json{}));
        text += '\n';
    }
    return text;
}

std::string kernel_json(std::span<const KernelTime> kernels, const Roofs& roofs) {
    Json json{
        {"roofs", {{"copy_gb_per_s", roofs.copy}, {"arithmetic_gop_per_s", roofs.arithmetic}}},
        {"kernels", Json::array()}};
    for (const KernelTime& kernel : kernels) {
        Json row{{"stage", kernel.stage}, {"kernel", kernel.name}};
        row.update(figures_of(kernel));
        json["kernels"].push_back(std::move(row));
    }
    return json.dump(1) + "\n";
}

std::string kernel_trace(std::span<const FrameProfile> frames, std::span<const KernelTime> kernels,
                         const std::string& description) {
    return trace_of(frames, kernels, description);
}

} // namespace lineatlas
