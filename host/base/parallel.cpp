#include "parallel.hpp"

#include <chrono>
#include <utility>

#ifdef LINEATLAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

namespace lineatlas {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_questions{50};

/// The question that this thread asks; nullptr: none.
thread_local const std::function<void()>* asked = nullptr;
thread_local Clock::time_point asked_at;

} // namespace

void ask_between_pieces() {
    if (asked == nullptr) return;
    const Clock::time_point now = Clock::now();
    if (now - asked_at < between_questions) return;
    asked_at = now;
    (*asked)();
}

BetweenPieces::BetweenPieces(std::function<void()> ask) : ask_(std::move(ask)) {
    asked = &ask_;
    asked_at = Clock::now();
}

BetweenPieces::~BetweenPieces() {
    asked = nullptr;
}

void for_each_piece(std::size_t count, std::size_t piece,
                    const std::function<void(std::size_t, std::size_t)>& work) {
    const auto do_piece = [&](std::size_t first) {
        ask_between_pieces();
        work(first, std::min(count, first + piece));
    };
#ifdef LINEATLAS_TBB
    if (count > piece) {
        const std::size_t pieces = (count + piece - 1) / piece;
        return tbb::parallel_for(std::size_t{0}, pieces,
                                 [&](std::size_t i) { do_piece(i * piece); });
    }
#endif
    for (std::size_t first = 0; first < count; first += piece) do_piece(first);
}

void for_each_range(std::size_t count, [[maybe_unused]] std::size_t least,
                    const std::function<void(std::size_t, std::size_t)>& work) {
#ifdef LINEATLAS_TBB
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count, least},
                      [&](const auto& range) { work(range.begin(), range.end()); });
#else
    if (count > 0) work(0, count);
#endif
}

void do_both(const std::function<void()>& one, const std::function<void()>& other) {
    ask_between_pieces();
#ifdef LINEATLAS_TBB
    tbb::parallel_invoke(one, other);
#else
    one();
    other();
#endif
}

} // namespace lineatlas
