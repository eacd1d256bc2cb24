#include "kernels.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "cpp/host_kernels.hpp"
#include "kernel_bytes.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

#define LA_TABLE(type, name, access) {#name, #type, sizeof(type), Access::access},
#define LA_IN(type, name) LA_TABLE(type, name, in)
#define LA_OUT(type, name) LA_TABLE(type, name, out)
#define LA_INOUT(type, name) LA_TABLE(type, name, inout)
#define LA_UNORDERED(type, name) LA_TABLE(type, name, unordered)
#define LA_TABLES(stage, kernel, Parameters)                                                       \
    constexpr KernelTable kernel##_list[] = {                                                      \
        kernel##_tables(LA_IN, LA_OUT, LA_INOUT, LA_UNORDERED)};                                   \
    static_assert(std::size(kernel##_list) <= most_tables);
LA_KERNELS(LA_TABLES, LA_TABLES, LA_TABLES, LA_TABLES, LA_TABLES)

#define LA_VARIANT(stage, kernel, Parameters, defines, has_barriers)                               \
    {#stage, #kernel, defines, sizeof(Parameters), kernel##_list, has_barriers, 0},
#define LA_PLAIN(stage, kernel, Parameters) LA_VARIANT(stage, kernel, Parameters, "", false)
#define LA_SUMS(stage, kernel, Parameters)                                                         \
    LA_VARIANT(stage, kernel, Parameters, "-DSCAN_SATURATE=0", false)                              \
    LA_VARIANT(stage, kernel, Parameters, "-DSCAN_SATURATE=1", false)
#define LA_TILES(stage, kernel, Parameters)                                                        \
    LA_VARIANT(stage, kernel, Parameters, "-DSCAN_SATURATE=0", true)                               \
    LA_VARIANT(stage, kernel, Parameters, "-DSCAN_SATURATE=1", true)
#define LA_NUMBERS(stage, kernel, Parameters)                                                      \
    LA_VARIANT(stage, kernel, Parameters, "", false)                                               \
    LA_VARIANT(stage, kernel, Parameters, "-DNUMBERED", false)
#define LA_PROBES(stage, kernel, Parameters)                                                       \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=1", false)                            \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=2", false)                            \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=3", false)                            \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=4", false)                            \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=1 -DTILED", false)                    \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=2 -DTILED", false)                    \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=3 -DTILED", false)                    \
    LA_VARIANT(stage, kernel, Parameters, "-DPROBES_PER_AXIS=4 -DTILED", false)

std::vector<Kernel> list_kernels() {
    std::vector<Kernel> all{LA_KERNELS(LA_PLAIN, LA_SUMS, LA_TILES, LA_NUMBERS, LA_PROBES)};
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i].index = i;
    return all;
}

/// The C++ form of every kernel, by index; null for those that need barriers.
std::vector<HostFunction> list_functions() {
    std::vector<HostFunction> all;
    for (const Kernel& kernel : all_kernels()) {
        const HostKernel* own = find_form(host_kernels(), kernel.name, kernel.defines);
        all.push_back(own != nullptr ? own->run : nullptr);
    }
    return all;
}

} // namespace

std::span<const Kernel> all_kernels() {
    static const std::vector<Kernel> all = list_kernels();
    return all;
}

std::vector<std::string_view> stage_names() {
    std::vector<std::string_view> names;
    for (const Kernel& kernel : all_kernels()) {
        if (std::ranges::find(names, kernel.stage) == names.end()) names.push_back(kernel.stage);
    }
    return names;
}

const Kernel& first_variant(std::string_view name) {
    return *std::ranges::find(all_kernels(), name, &Kernel::name);
}

void run_on_host(const Kernel& kernel, std::span<const std::byte> parameters,
                 std::span<void* const> tables, std::size_t first, std::size_t last,
                 std::size_t count) {
    static const std::vector<HostFunction> functions = list_functions();
    const HostFunction run = functions[kernel.index];
    if (run == nullptr) {
        throw UsageError("the kernel " + std::string{kernel.name} +
                         " has barriers and does not run as C++; leave Tuning::scan_tiles off");
    }
    run(parameters.data(), tables.data(), first, last, count);
}

} // namespace lineatlas::compute
