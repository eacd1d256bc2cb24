#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "message_socket.hpp"
#include "worker_process.hpp"

namespace lineatlas {

// Files are read in a process of their own: whatever a hostile file does to its parser, the calling
// process only gets a FileError. The reading process is this program itself, started again, so its
// main() begins with serve_as_reader(). Programs that embed the library use another program that
// does so. The process is not a fork, because a copy of a process with several threads may find
// locks held.

/// The limits of reading one file. 0: by the size of the file.
struct ReadLimits {
    std::uint64_t memory = 0; ///< bytes, of the process that reads, and of its results here
    std::chrono::milliseconds time{0}; ///< until the whole result is here
};

/// `limits` with its zeros filled in, for a file of `size` bytes.
ReadLimits limits_for(std::uintmax_t size, const ReadLimits& limits);

/// For messages: "0.25 GiB".
std::string written_gibibytes(std::uint64_t bytes);

/// The output of the process that reads. Results go out after the whole file has been read.
class ReaderOutput {
  public:
    explicit ReaderOutput(int socket) : socket_(socket) {}

    template <class T>
    void value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(std::as_bytes(std::span{&value, 1}));
    }
    template <class T>
    void values(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        value(std::uint64_t{values.size()});
        bytes(std::as_bytes(values));
    }
    template <class T>
    void values(const std::vector<T>& list) {
        values(std::span<const T>{list});
    }
    void text(std::string_view text) { values(std::span<const char>{text}); }

  private:
    void bytes(std::span<const std::byte> bytes) const;

    int socket_;
};

/// A kind of file that can be read: its name, and how it is read.
struct ReaderKind {
    using Parse = std::function<void(ReaderOutput&)>;

    std::string_view name;
    /// Reads all files that belong to the model or picture, without parsing them. The function that
    /// it returns parses them; it is called when the process is confined (confinement.hpp).
    /// `settings`: those that the ReaderProcess was given.
    Parse (*open)(const std::filesystem::path& path, std::string_view settings);
};

/// If this process was started by a ReaderProcess: reads the file and returns the exit code that
/// main() is to end with.
std::optional<int> serve_as_reader(int argc, char** argv, std::span<const ReaderKind> kinds);

/// Whether this program has called serve_as_reader().
bool serves_as_reader();

/// A process that reads `path`. It never outlives this object, nor the thread that made it. All
/// members throw FileError if the reader refuses the file, or if its process crashed, needed too
/// much memory or took too long.
class ReaderProcess {
  public:
    /// Starts the process and waits until the file has been read. `program`: the program to start;
    /// empty: this one.
    ReaderProcess(std::string_view kind, const std::filesystem::path& path,
                  const ReadLimits& limits, std::string_view settings = {},
                  const std::filesystem::path& program = {});

    // The values that the other side wrote, in the same order. Sizes come before contents and are
    // counted before anything is allocated, so all values together take no more than
    // ReadLimits::memory.

    template <class T>
    T value() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        receive(std::as_writable_bytes(std::span{&value, 1}));
        return value;
    }
    template <class T>
    std::vector<T> values() {
        std::vector<T> values(count(sizeof(T)));
        receive(std::as_writable_bytes(std::span{values}));
        return values;
    }
    /// A list of elements without a fixed size. `read()` returns each of them.
    template <class Read>
    auto list(Read read) {
        std::vector<decltype(read())> list;
        std::size_t left = count(sizeof(list[0]));
        for (list.reserve(left); left > 0; --left) list.push_back(read());
        return list;
    }
    std::string text();

    /// Throws FileError because the values make no sense.
    [[noreturn]] void refuse() const;

    int id() const { return worker_.id(); }

  private:
    void start(std::string_view kind, std::string_view settings,
               const std::filesystem::path& program);
    void await_answer();
    void receive(std::span<std::byte> bytes);
    std::size_t count(std::size_t element_size);
    [[noreturn]] void ended();
    [[noreturn]] void fail(const std::string& cause) const;
    [[noreturn]] void fail_for_memory() const;

    std::filesystem::path path_;
    ReadLimits limits_;
    Patience patience_{std::chrono::nanoseconds{0}};
    std::uint64_t kept_ = 0;        ///< bytes of the values received so far
    std::vector<std::byte> buffer_; ///< bytes that have come of the next values
    std::size_t taken_ = 0;         ///< bytes taken from the buffer
    WorkerProcess worker_;
};

} // namespace lineatlas
