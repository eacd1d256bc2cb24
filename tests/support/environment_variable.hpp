#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace lineatlas::test {

/// Gives a variable of the environment another value, or none. The destructor restores the old
/// value.
class EnvironmentVariable {
  public:
    EnvironmentVariable(std::string name, const std::optional<std::string>& value)
        : name_(std::move(name)) {
        if (const char* found = std::getenv(name_.c_str())) found_ = found;
        set(value);
    }
    ~EnvironmentVariable() { set(found_); }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

  private:
    void set(const std::optional<std::string>& value) const {
        if (value)
            ::setenv(name_.c_str(), value->c_str(), 1);
        else
            ::unsetenv(name_.c_str());
    }

    std::string name_;
    std::optional<std::string> found_;
};

} // namespace lineatlas::test
