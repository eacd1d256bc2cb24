// A compute backend from outside the library, as docs/backends.md describes it: one stage of its
// own, on several threads, and the others from the plain C++ backend.
#include "threads_backend.hpp"

#include <algorithm>
#include <thread>
#include <vector>

#include "compute/backends.hpp"
#include "compute/reference/reference_backend.hpp"
#include "compute/reference/stages.hpp"

namespace lineatlas::example {
namespace {

using namespace compute;

class ThreadsBackend final : public ReferenceBackend {
  public:
    std::string description() const override { return "threads"; }

    void facing(const FacingArgs& args) override {
        const std::size_t n = args.table.triangle_count;
        const std::size_t count = std::max(1U, std::thread::hardware_concurrency());
        const auto vertices = view_all<float>(args.table.vertices);
        const auto corners = view<std::uint32_t>(args.table.triangles, 3 * n);
        const auto front = view<std::uint8_t>(args.front, n);
        std::vector<std::jthread> threads; // each waits for its thread at the end
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t first = n * k / count, size = n * (k + 1) / count - first;
            threads.emplace_back([=, eye = args.eye] {
                reference::facing(vertices, corners.subspan(3 * first, 3 * size), eye,
                                  front.subspan(first, size));
            });
        }
    }
};

std::unique_ptr<Backend> make_threads(std::string_view) {
    return std::make_unique<ThreadsBackend>();
}

} // namespace

void register_threads_backend() {
    register_backend({"threads", "plain C++, facing on several threads", make_threads});
}

} // namespace lineatlas::example
