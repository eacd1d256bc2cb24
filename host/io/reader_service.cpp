// The process that reads, at the other end of ReaderProcess.
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "confinement.hpp"
#include "lineatlas/error.hpp"
#include "message_socket.hpp"
#include "reader_process.hpp"
#include "reader_protocol.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

constexpr int exit_failed = 1;

bool called = false;

std::uint64_t number_of(std::string_view word) {
    std::uint64_t number = 0;
    std::from_chars(word.data(), word.data() + word.size(), number);
    return number;
}

void limit(__rlimit_resource resource, rlim_t most) {
    const rlimit limits{.rlim_cur = most, .rlim_max = most};
    ::setrlimit(resource, &limits);
}

/// Limits data, not address space: the libraries for pictures take half a gigabyte of address space
/// and do not use it.
void limit_memory(std::uint64_t bytes) {
    if (!reader::sanitized) limit(RLIMIT_DATA, bytes);
}

/// Makes the allocator keep freed memory and take memory in large pieces. The process lives for one
/// file, and Open CASCADE frees and allocates the same megabytes for every face. All three settings
/// are needed: setting one of them stops the allocator from adapting the others.
void keep_memory() {
    constexpr int piece = 8 << 20, largest_kept = 32 << 20;
    ::mallopt(M_TOP_PAD, piece);
    ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    ::mallopt(M_MMAP_THRESHOLD, largest_kept);
}

/// Makes this process end with its parent. Returns false if the parent has ended already.
bool end_with_parent(std::uint64_t parent) {
    return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 &&
           static_cast<std::uint64_t>(::getppid()) == parent;
}

/// `new` calls this if there is no memory, before a parser could catch the exception.
void say_no_memory() {
    ReaderOutput{reader::socket}.value(reader::Answer::no_memory);
    ::_exit(exit_failed);
}

/// Reads the file and answers. If the reader throws, the answer is its message.
void read_file(const ReaderKind& kind, const std::filesystem::path& path,
               std::string_view settings) {
    ReaderOutput output{reader::socket};
    const auto refuse = [&](std::string_view message) {
        output.value(reader::Answer::refused);
        output.text(message.substr(0, reader::longest_refusal));
    };
    try {
        confine_to_reading();
        const ReaderKind::Parse parse = kind.open(path, settings);
        confine();
        parse(output);
    } catch (const Error& error) {
        refuse(error.what());
    } catch (const std::exception& error) {
        refuse(read_error(path, printable(error.what())).what());
    }
}

} // namespace

void ReaderOutput::bytes(std::span<const std::byte> bytes) const {
    if (!send_all(socket_, bytes)) ::_exit(exit_failed); // nobody is there to be told why
}

bool serves_as_reader() {
    return called;
}

std::optional<int> serve_as_reader(int argc, char** argv, std::span<const ReaderKind> kinds) {
    called = true;
    if (argc != reader::argument_count || argv[1] != reader::argument) return std::nullopt;
    const auto kind = std::ranges::find(kinds, std::string_view{argv[2]}, &ReaderKind::name);
    if (kind == kinds.end() || !end_with_parent(number_of(argv[5]))) return exit_failed;
    limit(RLIMIT_CORE, 0);
    ::setenv("OPENIMAGEIO_THREADS", "1", 0); // stacks of threads count as memory
    keep_memory();
    limit_memory(number_of(argv[4]));
    std::set_new_handler(say_no_memory);
    read_file(*kind, argv[3], argv[6]);
    ::_exit(0); // freeing all memory takes time, and the kernel does it anyway
}

} // namespace lineatlas
