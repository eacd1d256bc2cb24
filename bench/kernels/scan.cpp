// scan: exclusive prefix sums of n uint32, in place.
// Bytes: 4 read and 4 written per element, however often a way reads an element.
//
// A frame scans in place, and rivals gain from that too. The input is copied back before every run,
// which is not timed. Otherwise sums of sums would soon reach the largest value, where saturation
// has other work to do than in a frame.

#include <algorithm>
#include <iterator>
#include <numeric>

#define CL_TARGET_OPENCL_VERSION 120
#include <boost/compute/algorithm/exclusive_scan.hpp>
#include <boost/compute/iterator/buffer_iterator.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_scan.h>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

using Values = std::vector<std::uint32_t>;

Values random_values(std::uint32_t n) {
    Random random{2};
    Values values(n);
    for (std::uint32_t& value : values) value = random.below(200); // the total stays below 2^32
    return values;
}

Values scanned(Values values) {
    std::exclusive_scan(values.begin(), values.end(), values.begin(), std::uint32_t{0});
    return values;
}

Job counted(std::function<void()> run, std::function<void()> reset, std::uint32_t n) {
    return {.run = std::move(run), .bytes = 8.0 * n, .reset = std::move(reset)};
}

std::function<void()> upload(compute::Device& device, const SharedBuffer& buffer,
                             const Values& values) {
    return [&device, buffer, values] { write(device, *buffer, values); };
}

template <compute::ScanKind kind>
Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Values values = random_values(n);
    const SharedBuffer buffer = device.allocate((n + std::size_t{1}) * sizeof(std::uint32_t));
    const auto reset = upload(device, buffer, values);
    reset();
    const auto run = [&stages, buffer, n] {
        stages.scan(*buffer, n, kind);
        stages.device().finish();
    };
    run();
    require(read_back<std::uint32_t>(device, *buffer, n) == scanned(values), "scan");
    Job job = counted(run, reset, n);
    job.result = [&device, buffer, n] {
        return read_back<std::uint8_t>(device, *buffer, (n + std::size_t{1}) * 4);
    };
    return job;
}

Job prepare_boost(compute::OpenClBackend& device, std::uint32_t n) {
    const Values values = random_values(n);
    const SharedBuffer buffer = to_device(device, values);
    const boost::compute::buffer memory{static_cast<compute::OpenClBuffer&>(*buffer).memory()};
    boost::compute::command_queue queue{device.queue()()};
    const auto run = [&device, buffer, memory, queue, n]() mutable {
        const auto first = boost::compute::make_buffer_iterator<boost::compute::uint_>(memory, 0);
        boost::compute::exclusive_scan(first, first + n, first, 0U, queue);
        device.finish();
    };
    Job job = counted(run, upload(device, buffer, values), n);
    job.run();
    require(read_back<std::uint32_t>(device, *buffer, n) == scanned(values), "scan/boost_compute");
    return job;
}

void std_scan(Values& values) {
    std::exclusive_scan(values.begin(), values.end(), values.begin(), std::uint32_t{0});
}

void tbb_scan(Values& values) {
    tbb::parallel_scan(
        tbb::blocked_range<std::size_t>{0, values.size()}, std::uint32_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::uint32_t sum, bool is_final) {
            if (!is_final) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) sum += values[i];
                return sum;
            }
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                sum += std::exchange(values[i], sum);
            }
            return sum;
        },
        std::plus<>{});
}

Job prepare_host(void (*scan)(Values&), std::uint32_t n) {
    const Values input = random_values(n);
    const auto values = std::make_shared<Values>(input);
    scan(*values);
    require(*values == scanned(input), "scan in C++");
    // The same allocation is filled again, because a new one would have other pages.
    return counted([scan, values] { scan(*values); },
                   [input, values] { std::ranges::copy(input, values->begin()); }, n);
}

} // namespace

Rows scan_rows(const Devices& devices) {
    using compute::ScanKind;
    Rows rows = own_rows(devices, "scan", prepare<ScanKind::saturate>);
    // Rivals compute a sum that wraps.
    std::ranges::move(own_rows(devices, "scan_wrap", prepare<ScanKind::wrap>),
                      std::back_inserter(rows));
    compute::OpenClBackend& device = *devices.opencl;
    rows.push_back({"scan/std", [](std::uint32_t n) { return prepare_host(std_scan, n); }});
    rows.push_back({"scan/tbb", [](std::uint32_t n) { return prepare_host(tbb_scan, n); }});
    rows.push_back(
        {"scan/boost_compute", [&](std::uint32_t n) { return prepare_boost(device, n); }});
    return rows;
}

} // namespace lineatlas::bench
