#pragma once

#include <string>
#include <vector>

namespace lineatlas::viewer {

/// Messages to the user. Errors stay until they are dismissed; notices vanish by themselves.
class Messages {
  public:
    struct Message {
        std::string text;
        bool error = false;
        double seconds_left = 0; ///< of a notice
        int count = 1;           ///< times that it came in a row
    };

    void error(const std::string& text) {
        if (!all_.empty() && all_.back().error && all_.back().text == text) {
            ++all_.back().count;
            return;
        }
        all_.push_back({.text = text, .error = true});
        constexpr std::size_t most = 4;
        if (all_.size() > most) all_.erase(all_.begin());
    }
    void notice(const std::string& text) {
        std::erase_if(all_, [](const Message& message) { return !message.error; });
        constexpr double seconds = 4;
        all_.push_back({.text = text, .seconds_left = seconds});
    }
    void advance(double seconds) {
        for (Message& message : all_) message.seconds_left -= seconds;
        std::erase_if(all_, [](const Message& message) {
            return !message.error && message.seconds_left <= 0;
        });
    }
    void dismiss(std::size_t index) {
        all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(index));
    }
    const std::vector<Message>& all() const { return all_; }
    bool passing() const { ///< whether a message vanishes by itself
        for (const Message& message : all_) {
            if (!message.error) return true;
        }
        return false;
    }

  private:
    std::vector<Message> all_;
};

} // namespace lineatlas::viewer
