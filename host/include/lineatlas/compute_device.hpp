#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/export.hpp"

/// @file
/// Devices run the kernels. The library brings `opencl` and `cpp`. A program can add another one by
/// a class derived from compute::Device and a call of compute::register_device(); docs/backends.md
/// leads through a whole example.
/// @code{.cpp}
/// for (const compute::DeviceKind& kind : compute::device_kinds()) std::cout << kind.name << '\n';
/// const auto device = compute::make_device("cpp");
/// const auto buffer = device->allocate(1024);
/// device->clear(*buffer, 1024);
/// device->finish();
/// @endcode

namespace lineatlas::compute {

/// The memory of a device that the library keeps under one name.
struct TableMemory {
    std::string_view name;    ///< "clipped segments": docs/architecture.md has the list
    std::string_view purpose; ///< what messages call it: "the table of line segments"
    std::uint64_t bytes = 0;  ///< of all buffers of that name
};

/// Memory that kernels read and write. A buffer is made by the device that uses it. It may outlive
/// neither the device nor, if it wraps other memory, that memory.
class LINEATLAS_API Buffer {
  public:
    /// `size`: in bytes.
    explicit Buffer(std::size_t size) : size_(size) {}
    virtual ~Buffer();
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    std::size_t size() const { return size_; } ///< in bytes
    /// The number of launches so far of kernels that write to the buffer.
    std::uint64_t writes() const { return writes_; }

  private:
    friend class Stages; // counts the launches
    friend class TableList;
    std::size_t size_;
    TableMemory* counted_in_ = nullptr;
    std::uint64_t writes_ = 0;
};

/// What a kernel does with one of its tables.
enum class Access {
    in,        ///< only read
    out,       ///< only written, perhaps not everywhere
    inout,     ///< both
    unordered, ///< both, and its elements may be written in any order
};

/// A table that a kernel takes, in the order of its arguments.
struct KernelTable {
    std::string_view name;    ///< of the argument
    std::string_view type;    ///< of its elements: "float", "uint", "uchar" or a struct of kernels/
    std::size_t element_size; ///< bytes
    Access access;            ///< what the kernel does with it
};

/// A kernel of the library. Kernels live as long as the program.
struct Kernel {
    std::string_view stage; ///< "project_clip": docs/architecture.md has the list
    std::string_view name;  ///< of its function
    /// Macros that choose its form, in the syntax of a compiler's options: "-DPROBES_PER_AXIS=3".
    /// Empty for most. A device adds macros of its own tuning (docs/devices.md).
    std::string_view defines;
    std::size_t parameter_size;          ///< bytes of the struct that is its first argument
    std::span<const KernelTable> tables; ///< the arguments after that
    bool has_barriers; ///< needs work-groups that share memory; chosen by Tuning::scan_tiles alone
    std::uint32_t index; ///< its place in all_kernels()

    /// The name of its source in kernels/: "project_clip.cl".
    std::string file() const { return std::string{stage} + ".cl"; }
};

/// Every kernel, in the order of a frame.
LINEATLAS_API std::span<const Kernel> all_kernels();

/// The OpenCL C 1.2 of a kernel's file, with all included files. Throws FileError if
/// LINEATLAS_KERNEL_DIR is set and lacks it.
LINEATLAS_API std::string source_of(const Kernel& kernel);

/// Runs the work-items from `first` to `last` - 1, out of `count`, as C++ on the calling thread.
/// `tables`: the memory of the tables, in the order of Kernel::tables, aligned to 64 bytes. Several
/// threads may run parts of one launch at the same time. Throws UsageError for a kernel that has
/// barriers.
LINEATLAS_API void run_on_host(const Kernel& kernel, std::span<const std::byte> parameters,
                               std::span<void* const> tables, std::size_t first, std::size_t last,
                               std::size_t count);

/// A kernel to be run.
struct Launch {
    const Kernel& kernel;                  ///< one of all_kernels()
    std::span<const std::byte> parameters; ///< Kernel::parameter_size bytes; copied by launch()
    std::span<Buffer* const> tables;       ///< in the order of Kernel::tables
    std::uint32_t items;                   ///< work-items, above 0
    /// Work-items of a work-group, at most. Kernels ignore work-items beyond their last element, so
    /// the number of work-items may be rounded up.
    std::uint32_t group;
};

/// How kernels are launched on a device: kernels/tuning.toml for OpenCL devices. Values are above
/// 0.
struct Tuning {
    bool scan_tiles = false;            ///< tiles in local memory instead of serial chunks
    std::uint32_t scan_chunks = 16;     ///< least number of serial chunks per scan
    std::uint32_t longest_chunk = ~0U;  ///< most elements of a chunk; a quirk sets it
    std::uint32_t scan_tile = 64;       ///< work-group size of a tile; a power of two
    std::uint32_t scan_per_item = 8;    ///< values per work-item of a tile
    std::uint32_t local_size = 256;     ///< work-group size of kernels with a work-item per element
    std::uint32_t block_local_size = 1; ///< work-group size of kernels with a work-item per block
    std::uint32_t atlas_block = 256;    ///< samples per work-item
    bool atlas_vectors = true;          ///< all probes of a sample in one vector
    std::uint32_t depth_lanes = 8;      ///< triangles, and texels, at a time: 1, 4 or 8
    std::uint32_t depth_tile = 240;     ///< texels a side that a work-item draws; run_on_host: 240
    std::uint32_t depth_workers = 64;   ///< work-items that take such tiles, one after the other
    std::uint32_t depth_clusters = ~0U; ///< clusters of triangles that one launch draws
    bool depth_each = false;            ///< each triangle draws itself, not tiles all of them
    bool long_atomics = false;          ///< so by minima of 64 bits; a device sets it
    bool stroke_pixels = false;         ///< pixels draw all strokes over them, not tiles
    std::uint32_t halo_lanes = 16;      ///< lines tested at a time: 1, 8 or 16
    std::uint32_t face_lanes = 16;      ///< faces tested at a time: 1, 4, 8 or 16
    std::uint32_t face_chunks = 64;     ///< chunks of faces that go into tiles at the same time
    bool face_lists = false;            ///< each face goes into tiles by itself, and lists are
                                        ///< sorted by entry
    std::uint32_t segment_block = 4096; ///< segments per work-item of compact
    bool program_cache = false;         ///< built programs are kept in the user's cache
};

/// A kernel or a transfer that a device has run. Times are nanoseconds of
/// std::chrono::steady_clock.
struct CommandTime {
    std::string_view name;   ///< of the kernel; "write", "read", "copy" or "fill"
    std::int64_t submitted;  ///< when the host submitted it
    std::int64_t start;      ///< when the device began
    std::int64_t end;        ///< when the device was done
    std::uint64_t items = 0; ///< work-items, of a kernel
    std::uint32_t group = 0; ///< of one work-group
    std::uint64_t bytes = 0; ///< of the tables that it reads and those that it writes
};

/// The commands that a device gets while it keeps this log, in order.
class LINEATLAS_API CommandLog {
  public:
    virtual ~CommandLog() = default;

    /// Whether all commands have run; does not wait.
    virtual bool complete() const = 0;
    /// The times of all commands; waits if not complete(). Empty if the device keeps no times.
    virtual std::vector<CommandTime> read() = 0;
    /// By how much these times may differ from the host's clock, in nanoseconds.
    virtual std::optional<std::int64_t> error() const = 0;
};

/// A device runs kernels and owns their memory.
///
/// Calls are asynchronous where a device can, and run in the order they are made; `finish` and
/// `download` wait. All methods throw DeviceError when the device fails. A device and its buffers
/// belong to one thread at a time. Integer results are equal bit by bit on every device, floats
/// within 1e-5 relative.
class LINEATLAS_API Device {
  public:
    Device() = default;
    virtual ~Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// @name What it is
    /// @{

    /// "cpp", or "opencl: <device> (<platform>)".
    virtual std::string description() const = 0;
    /// How the library is to launch its kernels here; always the same.
    virtual const Tuning& tuning() const = 0;

    /// @}
    /// @name Memory
    /// @{

    /// Device memory; its content is undefined. Never smaller than 16 bytes.
    virtual std::unique_ptr<Buffer> allocate(std::size_t bytes) = 0;
    /// The largest size of one buffer in bytes; always the same.
    virtual std::uint64_t largest_buffer() const {
        return std::numeric_limits<std::uint64_t>::max();
    }
    /// How many bytes all future buffers together can hold.
    virtual std::uint64_t free_memory() const { return std::numeric_limits<std::uint64_t>::max(); }
    /// A buffer over memory of the caller (page-aligned), without a copy where the device can.
    virtual std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) = 0;
    /// Between these two, the memory behind a wrapped buffer is the host's to read and write.
    virtual void begin_host_access(Buffer& buffer) = 0;
    /// Ends what begin_host_access() began: the memory is the device's again.
    virtual void end_host_access(Buffer& buffer) = 0;

    /// @}
    /// @name Transfers
    /// @{

    /// Copies `data` into the buffer, from the byte `offset` on. `data` may be changed once this
    /// returns.
    virtual void upload(Buffer& buffer, std::span<const std::byte> data,
                        std::size_t offset = 0) = 0;
    /// Copies out of the buffer, from the byte `offset` on; waits.
    virtual void download(Buffer& buffer, std::span<std::byte> data, std::size_t offset = 0) = 0;
    /// As upload() of the first bytes, but may return at once: `data` must not change until
    /// finish(). Does nothing if `data` is empty.
    virtual void begin_upload(Buffer& buffer, std::span<const std::byte> data) {
        if (!data.empty()) upload(buffer, data);
    }
    /// As download() of the first bytes, but may return at once: `data` must stay valid until
    /// finish(), and then holds the bytes. Does nothing if `data` is empty.
    virtual void begin_download(Buffer& buffer, std::span<std::byte> data) {
        if (!data.empty()) download(buffer, data);
    }
    /// Copies the first `bytes` bytes of one buffer into another.
    virtual void copy(Buffer& from, Buffer& to, std::size_t bytes) = 0;
    /// Sets the first `bytes` bytes, a multiple of 4, to 0.
    virtual void clear(Buffer& buffer, std::size_t bytes) = 0;

    /// @}
    /// @name Work
    /// @{

    /// Runs a kernel over `launch.items` work-items.
    virtual void launch(const Launch& launch) = 0;

    virtual void flush() = 0;  ///< starts what was submitted
    virtual void finish() = 0; ///< waits until all of it is done

    /// @}
    /// @name Times and tables
    /// @{

    /// Keeps the times of all commands until end_log(), for a profile. Returns null if the device
    /// keeps no times.
    virtual std::shared_ptr<CommandLog> begin_log() { return nullptr; }
    /// Ends the log that begin_log() began; the log can still be read.
    virtual void end_log() {}

    /// What the library keeps here, in the order in which names came up. Stays until the next
    /// buffer is made.
    const std::deque<TableMemory>& tables() const { return tables_; }
    /// @}

  private:
    friend class TableList;
    std::deque<TableMemory> tables_; // buffers point to its elements
};

/// A kind of device that can be chosen by its name.
struct DeviceKind {
    std::string name;    ///< what `--compute` and DeviceOptions::compute take
    std::string summary; ///< a few words for lists
    /// Makes a device. `device`: the user's choice, in the kind's own terms; empty: the best one.
    /// Throws UsageError for a device that does not exist, DeviceError if it cannot work on this
    /// machine.
    std::unique_ptr<Device> (*make)(std::string_view device);
};

/// All kinds: those of the library, then those that were registered.
LINEATLAS_API const std::vector<DeviceKind>& device_kinds();

/// Adds a kind of device to this process. Must be called before any thread uses the library. Throws
/// UsageError if the name is taken.
LINEATLAS_API void register_device(DeviceKind kind);

/// "opencl, cpp, ...", for messages.
LINEATLAS_API std::string device_kind_names();

/// A device of the kind `name`; throws UsageError that lists all kinds if there is none of that
/// name.
LINEATLAS_API std::unique_ptr<Device> make_device(std::string_view name,
                                                  std::string_view device = {});

} // namespace lineatlas::compute
