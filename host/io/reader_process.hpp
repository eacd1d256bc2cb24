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
// main() begins with serve_as_reader(). For programs that embed the library it is another program
// whose main() does so. Not a fork: a copy of a process with several threads may find locks held.

/// What reading one file may take. 0: by the size of the file.
struct ReadLimits {
    std::uint64_t memory = 0; ///< bytes: of the process that reads, and of what is kept of it here
    std::chrono::milliseconds time{0}; ///< until all of it is here
};

/// `limits` with everything filled in, for a file of `size` bytes.
ReadLimits limits_for(std::uintmax_t size, const ReadLimits& limits);

/// For messages: "0.25 GiB".
std::string written_gibibytes(std::uint64_t bytes);

/// The other process: what it reads goes out here, after all of it has been read.
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

/// Something that can be read: the name it is asked for by, and how it is read.
struct ReaderKind {
    using Parse = std::function<void(ReaderOutput&)>;

    std::string_view name;
    /// Reads all files that belong to it, but believes nothing in them. What it returns does: it is
    /// called when the process is confined (confinement.hpp).
    /// `settings`: what the ReaderProcess was given.
    Parse (*open)(const std::filesystem::path& path, std::string_view settings);
};

/// If this process was started by a ReaderProcess: reads the file and returns the exit code that
/// main() is to end with.
std::optional<int> serve_as_reader(int argc, char** argv, std::span<const ReaderKind> kinds);

/// Whether this program has called it.
bool serves_as_reader();

/// A process that reads `path`. It never outlives this object, nor the thread that made it.
/// Everything throws FileError: what the reader refuses; and how the process ended, if it crashed,
/// needed too much memory or took too long.
class ReaderProcess {
  public:
    /// Waits until the file has been read. `program`: what is started; empty: this program.
    ReaderProcess(std::string_view kind, const std::filesystem::path& path,
                  const ReadLimits& limits, std::string_view settings = {},
                  const std::filesystem::path& program = {});

    // What the other side wrote, in the same order. Sizes come before contents and are counted
    // before anything is allocated: all that is kept of it is no more than ReadLimits::memory.

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
    /// Elements of no fixed size, each as `read()` returns it.
    template <class Read>
    auto list(Read read) {
        std::vector<decltype(read())> list;
        std::size_t left = count(sizeof(list[0]));
        for (list.reserve(left); left > 0; --left) list.push_back(read());
        return list;
    }
    std::string text();

    /// Says that what came makes no sense.
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
    std::uint64_t kept_ = 0;        ///< bytes, of what was received
    std::vector<std::byte> buffer_; ///< what has come of the next values
    std::size_t taken_ = 0;         ///< of the buffer
    WorkerProcess worker_;
};

} // namespace lineatlas
