#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace lineatlas::viewer {

/// Earlier states, for undo and redo. `same(a, b)`: true if two states are equal.
template <class State, bool (*same)(const State&, const State&)>
class History {
  public:
    void clear() { states_.clear(); }

    /// Notes the current state. States that were undone are forgotten.
    void note(const State& now) {
        if (!states_.empty() && same(states_[at_], now)) return;
        if (!states_.empty()) states_.resize(at_ + 1);
        if (states_.size() == most) states_.erase(states_.begin());
        states_.push_back(now);
        at_ = states_.size() - 1;
    }

    bool can_go_back() const { return !states_.empty() && at_ > 0; }
    bool can_go_forward() const { return at_ + 1 < states_.size(); }
    /// Goes one step back or forward. Returns the state to be taken; null if there is none.
    const State* back() { return can_go_back() ? &states_[--at_] : nullptr; }
    const State* forward() { return can_go_forward() ? &states_[++at_] : nullptr; }

  private:
    static constexpr std::size_t most = 200;
    std::vector<State> states_;
    std::size_t at_ = 0;
};

} // namespace lineatlas::viewer
