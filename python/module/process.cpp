#include "process.hpp"

#include <atomic>

#include <pybind11/pybind11.h>

#include <pthread.h>
#include <unistd.h>

#include "lineatlas/error.hpp"

namespace lineatlas::python {
namespace {

namespace py = pybind11;

std::atomic<bool> drivers_entered = false, drivers_lost = false;

// Only threads with the interpreter's lock change these. Python also holds the lock in fork().
std::atomic<int> at_work = 0; ///< number of Released objects
std::atomic<bool> ending = false;
pthread_t ending_thread;

void begin_child() {
    drivers_lost = drivers_lost || drivers_entered;
    at_work = 0; // only the forking thread lives on, and it was in Python code
}

/// Waits for all calls. Other threads cannot begin new ones.
void end_calls() {
    ending_thread = pthread_self();
    ending = true;
    const py::gil_scoped_release release; // calls need the lock to return
    for (int count = at_work; count > 0; count = at_work) at_work.wait(count);
}

} // namespace

Released::Released() {
    if (ending && pthread_equal(ending_thread, pthread_self()) == 0) {
        PyEval_SaveThread();
        for (;;) pause();
    }
    ++at_work;
    state_ = PyEval_SaveThread();
}

Released::~Released() {
    PyEval_RestoreThread(state_);
    --at_work;
    at_work.notify_all();
}

void enter_drivers() {
    drivers_entered = true;
    if (!drivers_lost) return;
    throw DeviceError(
        "this process was forked from one that had used OpenGL or OpenCL, whose drivers do not "
        "survive that; start processes by multiprocessing.get_context(\"spawn\"), or draw only "
        "after the fork");
}

bool has_lost_drivers() {
    return drivers_lost;
}

void watch_process() {
    pthread_atfork(nullptr, nullptr, &begin_child);
    py::module_::import("atexit").attr("register")(py::cpp_function(&end_calls));
}

} // namespace lineatlas::python
