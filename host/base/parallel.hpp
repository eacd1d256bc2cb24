#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace lineatlas {

// Work on all cores. The pieces do not depend on the number of cores, nor do the results if each
// piece writes to places of its own. Without oneTBB the calling thread does all the work.

/// Calls work(first, end) for pieces of [0, count), in any order and on several threads at once.
/// Each piece has `piece` elements, the last one perhaps fewer. The calling thread takes part.
/// Throws what a piece throws, and leaves out pieces that have not begun by then.
void for_each_piece(std::size_t count, std::size_t piece,
                    const std::function<void(std::size_t first, std::size_t end)>& work);

/// Calls work(first, end) for ranges that make up [0, count), for work that is cheaper in long
/// ranges. Ranges have at least `least` / 2 elements, are as long as leaves all cores enough
/// ranges, and do not always end at the same places. BetweenPieces does not ask between them.
/// Otherwise as for_each_piece().
void for_each_range(std::size_t count, std::size_t least,
                    const std::function<void(std::size_t first, std::size_t end)>& work);

/// While it lives, for_each_piece() of this thread calls `ask` now and then, between two pieces. An
/// exception of `ask` leaves for_each_piece(). A thread has one such object at a time.
class BetweenPieces {
  public:
    explicit BetweenPieces(std::function<void()> ask);
    ~BetweenPieces();
    BetweenPieces(const BetweenPieces&) = delete;
    BetweenPieces& operator=(const BetweenPieces&) = delete;

  private:
    std::function<void()> ask_;
};

/// Asks as for_each_piece() does, for long loops of one thread.
void ask_between_pieces();

/// Does two things, at the same time if a core is free.
void do_both(const std::function<void()>& one, const std::function<void()>& other);

/// The size of pieces for work that takes some nanoseconds per element. It is a multiple of 64, so
/// that pieces may write to their own words of a std::vector<bool>.
inline constexpr std::size_t usual_piece = 8192;

/// Calls each(i) for all i below `count`, in pieces.
template <class Each>
void for_each_index(std::size_t count, const Each& each, std::size_t piece = usual_piece) {
    for_each_piece(count, piece, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) each(i);
    });
}

/// Returns the results of make(first, end) for all pieces, in their order.
template <class Made, class Make>
std::vector<Made> made_of_pieces(std::size_t count, std::size_t piece, const Make& make) {
    std::vector<Made> made((count + piece - 1) / piece);
    for_each_piece(count, piece, [&](std::size_t first, std::size_t end) {
        made[first / piece] = make(first, end);
    });
    return made;
}

/// The elements of all lists, one list after the other.
template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& lists) {
    std::size_t count = 0;
    for (const std::vector<T>& list : lists) count += list.size();
    std::vector<T> all;
    all.reserve(count);
    for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

/// How many elements of `a` are among the first `count` of `a` and `b` merged. Of equal elements
/// those of `a` go first.
template <class T, class Less>
std::size_t merged_share(std::span<const T> a, std::span<const T> b, std::size_t count,
                         const Less& less) {
    std::size_t low = count > b.size() ? count - b.size() : 0, high = std::min(count, a.size());
    while (low < high) {
        const std::size_t of_a = (low + high) / 2;
        if (less(b[count - of_a - 1], a[of_a]))
            high = of_a;
        else
            low = of_a + 1;
    }
    return low;
}

/// Sorts a list by an order in which only equal elements are equivalent. Takes as much memory
/// again.
template <class T, class Less = std::less<T>>
void sort_in_pieces(std::vector<T>& list, const Less& less = {}) {
    constexpr std::size_t piece = 4 * usual_piece;
    const auto place = [](auto& elements, std::size_t i) {
        return elements.begin() + static_cast<std::ptrdiff_t>(i);
    };
    for_each_piece(list.size(), piece, [&](std::size_t first, std::size_t end) {
        std::sort(place(list, first), place(list, end), less);
    });
    std::vector<T> merged(list.size() > piece ? list.size() : 0);
    for (std::size_t run = piece; run < list.size(); run *= 2) {
        for_each_piece(list.size(), piece, [&](std::size_t first, std::size_t end) {
            const std::size_t begin = first / (2 * run) * (2 * run);
            const std::size_t middle = std::min(begin + run, list.size());
            const std::size_t last = std::min(middle + run, list.size());
            const std::span<const T> all{list};
            const auto a = all.subspan(begin, middle - begin);
            const auto b = all.subspan(middle, last - middle);
            const std::size_t a_first = merged_share(a, b, first - begin, less);
            const std::size_t a_end = merged_share(a, b, end - begin, less);
            const auto own_a = a.subspan(a_first, a_end - a_first);
            const auto own_b = b.subspan(first - begin - a_first, end - first - own_a.size());
            std::merge(own_a.begin(), own_a.end(), own_b.begin(), own_b.end(), place(merged, first),
                       less);
        });
        std::swap(list, merged);
    }
}

} // namespace lineatlas
