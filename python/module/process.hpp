#pragma once

#include <Python.h>

// What becomes of the drivers, and of calls that are at work, when the process forks or ends.
namespace lineatlas::python {

/// For as long as it lives its thread works without the interpreter's lock, and the interpreter
/// does not end: it would end the thread in the middle of the library. A daemon thread that begins
/// one when the interpreter has begun to end stays here for ever, as such threads do in Python.
class Released {
  public:
    Released();
    ~Released();
    Released(const Released&) = delete;
    Released& operator=(const Released&) = delete;

  private:
    PyThreadState* state_;
};

/// Before anything of OpenGL or OpenCL is made or used. Throws DeviceError where the process was
/// forked from one that had done so: the threads of drivers do not survive that, and whoever waits
/// for them hangs.
void enter_drivers();

/// Whether enter_drivers() throws: what the parent had made can't even be given back.
bool has_lost_drivers();

/// Once, with the module: to be told when the process forks and when the interpreter ends.
void watch_process();

} // namespace lineatlas::python
