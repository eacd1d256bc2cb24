#include "driver_trial.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/driver_copy.hpp"
#include "core/memory_limit.hpp"
#include "opencl.hpp"

namespace lineatlas::compute {
namespace {

namespace fs = std::filesystem;

/// Memory for the frame itself, beside the memory that drivers take for one small kernel.
constexpr std::size_t room = std::size_t{192} << 20U;
/// Some drivers wait endlessly. A good driver takes less than a second, but many on a busy machine.
/// So only the time counts in which no thread of the copy runs or waits to run.
constexpr std::chrono::seconds most_asleep{3};
constexpr std::chrono::seconds most_time{60};
/// ocl-icd asks each platform for its devices before it names any, to sort them. "none" turns that
/// off.
constexpr const char* sort = "OCL_ICD_PLATFORM_SORT";
constexpr std::string_view of_pocl = "Portable Computing Language";

bool has_linker() {
    const char* folders = std::getenv("PATH");
    std::istringstream path{folders != nullptr ? folders : ""};
    for (std::string folder; std::getline(path, folder, ':');) {
        if (::access((fs::path{folder} / "ld").c_str(), X_OK) == 0) return true;
    }
    return false;
}

void try_device(const cl::Device& device) {
    const cl::Context context{device};
    const cl::CommandQueue queue{context, device};
    const cl::Program program{
        context, "kernel void tried(global uint* result) { result[get_global_id(0)] = 1; }"};
    program.build(device); // the constructor would ask for OpenCL C 2.0, which some devices lack
    constexpr std::size_t items = 64;
    const cl::Buffer buffer{context, CL_MEM_READ_WRITE, items * sizeof(cl_uint)};
    cl::Kernel kernel{program, "tried"};
    kernel.setArg(0, buffer);
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange{items}, cl::NDRange{16});
    std::array<cl_uint, items> result{};
    queue.enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof result, result.data());
    // PoCL 7.1 does not report that its linker has failed.
    if (std::ranges::count(result, 1U) != items) throw std::runtime_error{"it has not run"};
}

/// How much of a driver is tried.
enum class Trial {
    devices, ///< its list of devices
    kernels, ///< a kernel, with memory left for a frame
};

void try_platform(const cl::Platform& platform, Trial trial) {
    std::vector<cl::Device> devices;
    if (::clGetDeviceIDs(platform(), CL_DEVICE_TYPE_ALL, 0, nullptr, nullptr) !=
        CL_DEVICE_NOT_FOUND)
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    for (const cl::Device& device : devices) {
        device.getInfo<CL_DEVICE_NAME>();
        device.getInfo<CL_DEVICE_EXTENSIONS>();
        if (trial == Trial::kernels) try_device(device);
    }
}

/// Runs in the copy. Names each platform before it is tried, so that the last one named is the one
/// that failed.
[[noreturn]] void try_all(int output, std::size_t first, Trial trial, const char* cache) {
    begin_driver_copy();
    if (cache != nullptr)
        ::setenv("POCL_CACHE_DIR", cache, 1); // a kernel that is built already
                                              // needs no ld
    const auto say = [&](const std::string& line) {
        if (::write(output, line.data(), line.size()) < 0) ::_exit(1);
    };
    if (trial == Trial::kernels) take_memory(room);
    try {
        std::vector<cl::Platform> platforms;
        cl::Platform::get(&platforms);
        for (std::size_t i = first; i < platforms.size(); ++i) {
            say(platforms[i].getInfo<CL_PLATFORM_NAME>() + "\n");
            try_platform(platforms[i], trial);
        }
    } catch (const cl::Error& error) {
        ::_exit(error.err() == CL_PLATFORM_NOT_FOUND_KHR ? 0 : 1);
    } catch (const std::exception&) {
        ::_exit(1);
    }
    ::_exit(0);
}

/// Whether all threads of a process, and of processes that it has started, sleep.
bool is_asleep(const std::string& process) {
    std::error_code error;
    for (fs::directory_iterator task{fs::path{"/proc"} / process / "task", error}, end;
         !error && task != end; task.increment(error)) {
        std::string text;
        std::getline(std::ifstream{task->path() / "stat"}, text);
        const std::size_t name = text.rfind(") "); // a name may hold anything; the state follows it
        if (name != std::string::npos && text[name + 2] != 'S' && text[name + 2] != 'Z')
            return false;
        std::ifstream children{task->path() / "children"};
        while (children >> text)
            if (!is_asleep(text)) return false;
    }
    return true;
}

/// How a copy ended, and the platforms that it tried.
struct Ending {
    bool good = false;
    bool idle = false; ///< it was ended for doing nothing
    bool late = false; ///< it was ended for taking too long
    int signal = 0;    ///< the signal that ended it, or 0
    std::vector<std::string> tried;
};

/// Runs a copy of the process. `first`: the platform to begin with.
Ending run_copy(std::size_t first, Trial trial, const char* cache) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return {};
    const pid_t copy = ::fork();
    if (copy == 0) try_all(pipe[1], first, trial, cache);
    ::close(pipe[1]);
    Ending ending;
    std::string said;
    std::array<char, 256> part{};
    constexpr std::chrono::milliseconds step{100};
    std::chrono::milliseconds asleep{0}, waited{0};
    for (ssize_t count = 1; copy > 0 && count != 0;) {
        pollfd waiting{.fd = pipe[0], .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, static_cast<int>(step.count())) != 0) {
            count = ::read(pipe[0], part.data(), part.size());
            if (count > 0) said.append(part.data(), static_cast<std::size_t>(count));
            if (count < 0 && errno != EINTR) break;
            continue;
        }
        waited += step;
        asleep = is_asleep(std::to_string(copy)) ? asleep + step : step.zero();
        ending.idle = asleep >= most_asleep;
        ending.late = waited >= most_time;
        if (ending.idle || ending.late) ::kill(copy, SIGKILL);
    }
    ::close(pipe[0]);
    int status = 0;
    if (copy < 0 || ::waitpid(copy, &status, 0) != copy) return {};
    ending.good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
    std::istringstream lines{said};
    for (std::string line; std::getline(lines, line);) ending.tried.push_back(line);
    return ending;
}

class EmptyCache {
  public:
    EmptyCache() {
        std::error_code error;
        name_ = (fs::temp_directory_path(error) / "lineatlas-trial-XXXXXX").string();
        made_ = !error && ::mkdtemp(name_.data()) != nullptr;
    }
    ~EmptyCache() {
        std::error_code ignored;
        if (made_) fs::remove_all(name_, ignored);
    }
    EmptyCache(const EmptyCache&) = delete;
    EmptyCache& operator=(const EmptyCache&) = delete;

    const char* path() const { return made_ ? name_.c_str() : nullptr; }

  private:
    std::string name_;
    bool made_ = false;
};

/// The cause of a failure. `platform`: the one that failed; empty: none had been found yet.
std::string why(const std::string& platform, const Ending& ending, bool linker,
                const std::optional<std::string>& limit) {
    const auto seconds = [](std::chrono::seconds time) {
        return std::to_string(time.count()) + " seconds";
    };
    if (!linker && !ending.idle && !ending.late && platform == of_pocl)
        return "PoCL needs the linker ld, and there is none in PATH (on Debian and Ubuntu: apt "
               "install binutils)";
    std::string text = platform.empty() ? "the OpenCL drivers" : '"' + platform + '"';
    text += ending.idle   ? " did nothing for " + seconds(most_asleep)
            : ending.late ? " took more than " + seconds(most_time)
                          : std::string{" failed a trial"};
    if (!ending.idle && !ending.late && ending.signal != 0)
        text += std::string{" ("} + ::strsignal(ending.signal) + ")";
    if (limit) text += " with the memory that this process may have, " + *limit;
    return text;
}

} // namespace

DriverTrial try_drivers(bool mistrusted) {
    DriverTrial trial;
    const bool linker = has_linker();
    const std::optional<std::string> limit = memory_limit();
    const Trial kind = linker && !limit ? Trial::devices : Trial::kernels;
    if (kind == Trial::devices && !mistrusted) return trial;
    std::optional<EmptyCache> cache;
    if (kind == Trial::kernels) cache.emplace();
    trial.working.emplace();
    std::size_t next = 0;
    for (bool all = false; !all;) {
        const Ending ending = run_copy(next, kind, cache ? cache->path() : nullptr);
        all = ending.good || ending.tried.empty();
        for (std::size_t i = 0; i < ending.tried.size(); ++i) {
            const bool failed = !ending.good && i + 1 == ending.tried.size();
            if (!failed) trial.working->push_back(next + i);
        }
        next += ending.tried.size();
        if (ending.good) continue;
        if (ending.tried.empty() && ::getenv(sort) == nullptr) {
            ::setenv(sort, "none", 1);
            all = false;
            continue;
        }
        const std::string failing = ending.tried.empty() ? "" : ending.tried.back();
        trial.cause += (trial.cause.empty() ? "" : "; ") + why(failing, ending, linker, limit);
    }
    return trial;
}

} // namespace lineatlas::compute
