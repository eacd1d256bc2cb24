// Kernels that are launched only so that they are built (Renderer::prepare): with nothing to do
// they touch no memory but the beginning of their tables, and end.
#include <cstddef>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mman.h>

#include "compute/stages/kernel_forms.hpp"

namespace lineatlas::test {
namespace {

/// Zeros, as many as IdleLaunches has, with nothing before and behind them.
class LonelyTable {
  public:
    static constexpr std::size_t page = 4096;
    LonelyTable() {
        void* pages = ::mmap(nullptr, 3 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED) throw std::bad_alloc{};
        pages_ = static_cast<std::byte*>(pages);
        ::mprotect(pages_ + page, page, PROT_READ | PROT_WRITE);
    }
    ~LonelyTable() { ::munmap(pages_, 3 * page); }
    LonelyTable(const LonelyTable&) = delete;
    LonelyTable& operator=(const LonelyTable&) = delete;

    void* memory() const { return pages_ + page; }

  private:
    std::byte* pages_;
};

std::vector<std::string_view> all_stages() {
    std::set<std::string_view> stages;
    for (const compute::Kernel& kernel : compute::all_kernels()) stages.insert(kernel.stage);
    return {stages.begin(), stages.end()};
}

/// `of_gpu`: with the forms of a GPU that C++ has.
compute::Tuning cpp_tuning(bool of_gpu, bool scan_tiles = false) {
    return {.scan_tiles = scan_tiles,
            .depth_each = of_gpu,
            .stroke_pixels = of_gpu,
            .face_lists = of_gpu};
}

TEST(IdleKernels, TouchNothing) {
    for (std::uint32_t probes = 1; probes <= 4; ++probes) {
        // With 1 in the forms of a CPU, with more in those of a GPU that C++ has.
        for (const compute::KernelForm& form :
             compute::kernel_forms(all_stages(), probes, cpp_tuning(probes > 1))) {
            SCOPED_TRACE(std::string{form.kernel->name});
            const std::vector<LonelyTable> tables(form.kernel->tables.size());
            std::vector<void*> memory;
            for (const LonelyTable& table : tables) memory.push_back(table.memory());
            const std::vector<std::byte> parameters(form.kernel->parameter_size);
            const std::uint32_t items =
                form.per_element ? compute::IdleLaunches::many_items : form.group;
            compute::run_on_host(*form.kernel, parameters, memory, 0, items, items);
        }
    }
}

TEST(IdleKernels, AreAllOfAStage) {
    // Of what comes in variants, those that no frame needs are left out.
    std::set<std::string_view> names, listed;
    for (const compute::Kernel& kernel : compute::all_kernels()) names.insert(kernel.name);
    for (const bool tiles : {false, true})
        for (const compute::KernelForm& form :
             compute::kernel_forms(all_stages(), 3, cpp_tuning(tiles, tiles)))
            listed.insert(form.kernel->name);
    EXPECT_EQ(listed, names);
}

} // namespace
} // namespace lineatlas::test
