#pragma once

#include <Python.h>

// The drivers, and calls at work, when the process forks or ends.
namespace lineatlas::python {

/// Releases the interpreter's lock for its lifetime, and lets the interpreter wait with its end:
/// otherwise the end would kill this thread in the middle of the library. A daemon thread that
/// makes one while the interpreter ends blocks for ever, as such threads do in Python.
class Released {
  public:
    Released();
    ~Released();
    Released(const Released&) = delete;
    Released& operator=(const Released&) = delete;

  private:
    PyThreadState* state_;
};

/// Call this before using OpenGL or OpenCL. Throws DeviceError in a process that was forked from a
/// process that had called it. Threads of drivers do not survive a fork, so a call would hang.
void enter_drivers();

/// True if enter_drivers() throws. Then the parent's objects cannot even be released.
bool has_lost_drivers();

/// Registers handlers for forks and for the interpreter's end. Call it once, with the module.
void watch_process();

} // namespace lineatlas::python
