#include "handover_rates.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "compute/opencl/opencl_backend.hpp"
#include "compute/opencl/programs.hpp"
#include "core/median.hpp"
#include "glpasses/current_context.hpp"
#include "shared_table.hpp"

namespace lineatlas::interop {
namespace {

constexpr std::size_t few_bytes = std::size_t{64} << 10U, many_bytes = std::size_t{4} << 20U;
constexpr int rounds = 5;

/// The binary logarithms of rates, rounded: what is kept.
struct Logarithms {
    int to_compute_ms = 0, to_compute_bytes = 0, to_gl_ms = 0, to_gl_bytes = 0;
};

int rounded_log2(double value) {
    return static_cast<int>(std::lround(std::log2(std::max(value, 1e-6))));
}

double milliseconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

struct Times {
    double to_compute = 0, to_gl = 0; ///< milliseconds
};

/// The times of a table that the other side has written.
Times time_table(Sharing& sharing, std::size_t bytes) {
    SharedTable table{sharing, compute::table::work_space};
    table.fit(bytes);
    const std::vector<std::byte> content(bytes);
    std::vector<double> to_compute, to_gl;
    for (int round = 0; round <= rounds; ++round) {
        glClearNamedBufferData(table.gl_to_write(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                               nullptr);
        glFinish();
        const double there = milliseconds_of([&] {
            table.compute();
            sharing.device().finish();
        });
        table.upload(content);
        sharing.device().finish();
        const double back = milliseconds_of([&] {
            table.gl();
            glFinish();
        });
        if (round == 0) continue; // which touches new memory
        to_compute.push_back(there);
        to_gl.push_back(back);
    }
    return {median(std::move(to_compute)), median(std::move(to_gl))};
}

/// Bytes per millisecond, from the times of a small and of a large table.
double bandwidth(double few, double many) {
    constexpr double least = 1e-6; // where both take the same time
    return static_cast<double>(many_bytes - few_bytes) / std::max(many - few, least);
}

Logarithms measure(Sharing& sharing) {
    const Times few = time_table(sharing, few_bytes), many = time_table(sharing, many_bytes);
    return {.to_compute_ms = rounded_log2(few.to_compute),
            .to_compute_bytes = rounded_log2(bandwidth(few.to_compute, many.to_compute)),
            .to_gl_ms = rounded_log2(few.to_gl),
            .to_gl_bytes = rounded_log2(bandwidth(few.to_gl, many.to_gl))};
}

HandoverRates rates_of(const Logarithms& kept, SharingMode mode) {
    HandoverRates rates{.to_compute = {.milliseconds = std::exp2(kept.to_compute_ms)},
                        .to_gl = {.milliseconds = std::exp2(kept.to_gl_ms)},
                        .measured = true};
    if (mode != SharingMode::copy) return rates;
    rates.to_compute.bytes_per_millisecond = std::exp2(kept.to_compute_bytes);
    rates.to_gl.bytes_per_millisecond = std::exp2(kept.to_gl_bytes);
    return rates;
}

std::string gl_name() {
    std::string name;
    for (const GLenum part : {GL_VENDOR, GL_RENDERER, GL_VERSION})
        if (const GLubyte* text = glGetString(part))
            name += reinterpret_cast<const char*>(text) + std::string{"\n"};
    return name;
}

/// Everything that the rates depend on.
std::string key_of(const compute::OpenClDevice& device, SharingMode mode) {
    return "hand-overs\n" + compute::cache_key(device, {.name = "hand-overs",
                                                        .source = gl_name(),
                                                        .options = std::string{name_of(mode)}});
}

std::optional<Logarithms> kept(const compute::ProgramCache& cache, const std::string& key) {
    const std::optional<std::vector<unsigned char>> file = cache.find(key);
    if (!file) return std::nullopt;
    std::istringstream text{std::string{file->begin(), file->end()}};
    Logarithms found;
    text >> found.to_compute_ms >> found.to_compute_bytes >> found.to_gl_ms >> found.to_gl_bytes;
    return text ? std::optional{found} : std::nullopt;
}

void keep(const compute::ProgramCache& cache, const std::string& key, const Logarithms& found) {
    std::ostringstream text;
    text << found.to_compute_ms << ' ' << found.to_compute_bytes << ' ' << found.to_gl_ms << ' '
         << found.to_gl_bytes;
    const std::string file = text.str();
    cache.store(key, {reinterpret_cast<const unsigned char*>(file.data()), file.size()});
}

bool can_keep(const compute::ProgramCache& cache) {
    return cache.store("hand-overs can be kept", {});
}

} // namespace

HandoverRates assumed_rates(SharingMode mode) {
    if (mode == SharingMode::host_pointer)
        return {.to_compute = {.milliseconds = 0.02}, .to_gl = {.milliseconds = 0.02}};
    // A GPU that changes from one API to the other; at the bus, 4 GB/s.
    HandoverRate rate{.milliseconds = 0.25};
    if (mode == SharingMode::copy) rate.bytes_per_millisecond = 4e6;
    return {.to_compute = rate, .to_gl = rate};
}

HandoverRates handover_rates(Sharing& sharing) {
    const SharingMode mode = sharing.mode();
    const auto* opencl = dynamic_cast<const compute::OpenClBackend*>(&sharing.device());
    if (opencl == nullptr || (opencl->device().is_cpu && gl::is_software()))
        return assumed_rates(mode);
    const std::optional<compute::ProgramCache> cache = compute::user_program_cache(true);
    if (!cache) return assumed_rates(mode);
    const std::string key = key_of(opencl->device(), mode);
    if (const auto known = kept(*cache, key)) return rates_of(*known, mode);
    if (!can_keep(*cache)) return assumed_rates(mode);
    keep(*cache, key, measure(sharing));
    const auto written = kept(*cache, key); // or what another process has measured meanwhile
    return written ? rates_of(*written, mode) : assumed_rates(mode);
}

} // namespace lineatlas::interop
