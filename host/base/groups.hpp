#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "parallel.hpp"

namespace lineatlas {

/// Items grouped by a number that each has, as triangles are by a vertex. Several threads put items
/// in place, so the items of one number are in any order; sort them if the order matters.
template <class Item>
class Groups {
  public:
    /// Calls items_of(i, add) for all i below `count`, twice. add(number, item) adds an item to the
    /// group of a number, which is below `numbers`.
    template <class ItemsOf>
    Groups(std::size_t numbers, std::size_t count, const ItemsOf& items_of) : first_(numbers + 1) {
        std::vector<std::atomic<std::uint32_t>> next(numbers);
        for_each_index(count, [&](std::size_t i) {
            items_of(i, [&](std::uint32_t number, const Item&) {
                next[number].fetch_add(1, std::memory_order_relaxed);
            });
        });
        for (std::size_t number = 0; number < numbers; ++number) {
            const std::uint32_t size = next[number].load(std::memory_order_relaxed);
            next[number].store(first_[number], std::memory_order_relaxed);
            first_[number + 1] = first_[number] + size;
        }
        items_.resize(first_.back());
        for_each_index(count, [&](std::size_t i) {
            items_of(i, [&](std::uint32_t number, const Item& item) {
                items_[next[number].fetch_add(1, std::memory_order_relaxed)] = item;
            });
        });
    }

    std::span<Item> operator[](std::size_t number) {
        return std::span{items_}.subspan(first_[number], first_[number + 1] - first_[number]);
    }
    std::span<const Item> operator[](std::size_t number) const {
        return std::span{items_}.subspan(first_[number], first_[number + 1] - first_[number]);
    }

  private:
    std::vector<std::uint32_t> first_; ///< first item of each number, and the end of all items
    std::vector<Item> items_;
};

} // namespace lineatlas
