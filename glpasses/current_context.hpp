#pragma once

namespace lineatlas::gl {

/// The GL context of this thread, as the library that manages it knows it.
struct CurrentContext {
    enum class System { none, egl, glx };
    System system = System::none;
    void* context = nullptr;
    void* display = nullptr;

    bool operator==(const CurrentContext&) const = default;
};

/// Asks the libraries that this process has loaded. Makes no GL call, because without a context GL
/// calls end the process.
CurrentContext current_context();

/// The current context, fit to be used: throws UsageError if there is none, DeviceError if its GL
/// is too old.
CurrentContext require_context();

/// Whether the current context renders on the CPU.
bool is_software();

/// Throws DeviceError if the current context was lost (GL_KHR_robustness): a driver that was reset,
/// a GPU that was taken out. Only contexts that were made robust learn of a loss.
void require_alive();

} // namespace lineatlas::gl
