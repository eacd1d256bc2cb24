// compact (of samples): n bytes in, the uint32 addresses of those that are not 0 out, packed, in
// order. Bytes: 1 read per element and 4 written per element kept, however often a way reads them;
// for boost_compute_uint32, which is another job of the same size, 4 read and 4 written.
//
// Two inputs, half visible in both: `noise`, where every byte is chance (the worst for branches),
// and `stretches` of 1 to 39 samples, as lines give them.

#include <algorithm>
#include <numeric>
#include <ranges>

#define CL_TARGET_OPENCL_VERSION 120
#include <boost/compute/algorithm/copy_if.hpp>
#include <boost/compute/iterator/buffer_iterator.hpp>
#include <boost/compute/lambda.hpp>
#include <tbb/parallel_for.h>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Addresses = std::vector<std::uint32_t>;

enum class Input { noise, stretches };

Bytes make_alpha(std::uint32_t n, Input input) {
    Random random{3};
    Bytes alpha(n);
    bool visible = false;
    std::uint32_t left = 0;
    for (std::uint8_t& value : alpha) {
        if (left == 0) {
            visible = input == Input::noise ? random.below(2) != 0 : !visible;
            left = input == Input::noise ? 1 : 1 + random.below(39);
        }
        --left;
        value = visible ? static_cast<std::uint8_t>(1 + random.below(255)) : 0;
    }
    return alpha;
}

Addresses packed_addresses(const Bytes& alpha) {
    Addresses result;
    for (std::uint32_t i = 0; i < alpha.size(); ++i) {
        if (alpha[i] != 0) result.push_back(i);
    }
    return result;
}

Job counted(std::function<void()> run, std::size_t n, std::size_t kept) {
    return {.run = std::move(run),
            .bytes = static_cast<double>(n) + 4.0 * static_cast<double>(kept)};
}

Job prepare_backend(compute::Backend& backend, std::uint32_t n, Input input) {
    const Bytes alpha = make_alpha(n, input);
    const Addresses expected = packed_addresses(alpha);
    const SharedBuffer from = to_device(backend, alpha);
    const SharedBuffer packed = backend.allocate(n * sizeof(std::uint32_t));
    const SharedBuffer count = backend.allocate(sizeof(std::uint32_t));
    const auto run = [&backend, from, packed, count, n] {
        backend.compact_samples(
            {.alpha = *from, .count = n, .packed = *packed, .packed_count = *count});
        backend.finish();
    };
    run();
    require(read_back<std::uint32_t>(backend, *count, 1)[0] == expected.size() &&
                read_back<std::uint32_t>(backend, *packed, expected.size()) == expected,
            "compact");
    return counted(run, n, expected.size());
}

boost::compute::buffer boost_buffer(const SharedBuffer& buffer) {
    return boost::compute::buffer{static_cast<compute::OpenClBuffer&>(*buffer).memory()};
}

/// Boost.Compute's copy_if. Copying indices is in its `detail` alone, but it is copy_if's own way
/// with one other expression in the last kernel.
Job prepare_boost(compute::OpenClBackend& backend, std::uint32_t n, Input input) {
    const Bytes alpha = make_alpha(n, input);
    const Addresses expected = packed_addresses(alpha);
    const SharedBuffer from = to_device(backend, alpha);
    const SharedBuffer packed = backend.allocate(n * sizeof(std::uint32_t));
    boost::compute::command_queue queue{backend.queue()()};
    const auto run = [&backend, from, packed, in = boost_buffer(from), out = boost_buffer(packed),
                      queue, n]() mutable {
        using namespace boost::compute;
        const auto first = make_buffer_iterator<uchar_>(in, 0);
        detail::copy_index_if(first, first + n, make_buffer_iterator<uint_>(out, 0),
                              lambda::_1 != uchar_{0}, queue);
        backend.finish();
    };
    Job job = counted(run, n, expected.size());
    job.run();
    require(read_back<std::uint32_t>(backend, *packed, expected.size()) == expected,
            "compact/boost_compute");
    return job;
}

/// copy_if as its documentation shows it: uint32 in, the values that are not 0 out.
Job prepare_boost_uint32(compute::OpenClBackend& backend, std::uint32_t n, Input input) {
    const Bytes alpha = make_alpha(n, input);
    const Addresses values(alpha.begin(), alpha.end());
    Addresses expected;
    std::ranges::copy_if(values, std::back_inserter(expected), [](auto v) { return v != 0; });
    const SharedBuffer from = to_device(backend, values);
    const SharedBuffer packed = backend.allocate(n * sizeof(std::uint32_t));
    boost::compute::command_queue queue{backend.queue()()};
    const auto run = [&backend, from, packed, in = boost_buffer(from), out = boost_buffer(packed),
                      queue, n]() mutable {
        using namespace boost::compute;
        const auto first = make_buffer_iterator<uint_>(in, 0);
        copy_if(first, first + n, make_buffer_iterator<uint_>(out, 0), lambda::_1 != uint_{0},
                queue);
        backend.finish();
    };
    Job job = counted(run, n * std::size_t{4}, expected.size());
    job.run();
    require(read_back<std::uint32_t>(backend, *packed, expected.size()) == expected,
            "compact/boost_compute_uint32");
    return job;
}

std::size_t std_compact(const Bytes& alpha, Addresses& packed) {
    const auto addresses =
        std::views::iota(std::uint32_t{0}, static_cast<std::uint32_t>(alpha.size()));
    const auto end = std::copy_if(addresses.begin(), addresses.end(), packed.begin(),
                                  [&](std::uint32_t i) { return alpha[i] != 0; });
    return static_cast<std::size_t>(end - packed.begin());
}

/// The same two passes as the kernels': count per block, write from the block's offset.
std::size_t tbb_compact(const Bytes& alpha, Addresses& packed) {
    constexpr std::size_t block = 16384;
    const std::size_t blocks = (alpha.size() + block - 1) / block;
    const auto of_block = [&](std::size_t b) {
        return std::span{alpha}.subspan(b * block, std::min(block, alpha.size() - b * block));
    };
    std::vector<std::size_t> offsets(blocks + 1);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
        const auto bytes = of_block(b);
        offsets[b] =
            bytes.size() - static_cast<std::size_t>(std::ranges::count(bytes, std::uint8_t{0}));
    });
    std::exclusive_scan(offsets.begin(), offsets.end(), offsets.begin(), std::size_t{0});
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
        std::size_t next = offsets[b];
        const auto bytes = of_block(b);
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            if (bytes[i] != 0) packed[next++] = static_cast<std::uint32_t>(b * block + i);
        }
    });
    return offsets.back();
}

Job prepare_host(std::size_t (*compact)(const Bytes&, Addresses&), std::uint32_t n, Input input) {
    const auto alpha = std::make_shared<Bytes>(make_alpha(n, input));
    const auto packed = std::make_shared<Addresses>(n);
    const Addresses expected = packed_addresses(*alpha);
    const std::size_t count = compact(*alpha, *packed);
    require(count == expected.size() &&
                std::ranges::equal(expected, std::span{*packed}.first(count)),
            "compact in C++");
    return counted([compact, alpha, packed] { compact(*alpha, *packed); }, n, count);
}

Rows rows_for(const Backends& backends, Input input) {
    const std::string stage = input == Input::noise ? "compact_noise" : "compact_stretches";
    Rows rows = own_rows(backends, stage, [input](compute::Backend& backend, std::uint32_t n) {
        return prepare_backend(backend, n, input);
    });
    compute::OpenClBackend& device = *backends.device;
    const auto add = [&](const std::string& way, auto prepare) {
        rows.push_back({stage + "/" + way, prepare});
    };
    add("std", [input](std::uint32_t n) { return prepare_host(std_compact, n, input); });
    add("tbb", [input](std::uint32_t n) { return prepare_host(tbb_compact, n, input); });
    add("boost_compute",
        [&device, input](std::uint32_t n) { return prepare_boost(device, n, input); });
    add("boost_compute_uint32",
        [&device, input](std::uint32_t n) { return prepare_boost_uint32(device, n, input); });
    return rows;
}

} // namespace

Rows compact_rows(const Backends& backends) {
    Rows rows = rows_for(backends, Input::noise);
    for (Row& row : rows_for(backends, Input::stretches)) rows.push_back(std::move(row));
    return rows;
}

} // namespace lineatlas::bench
