// Ends the process if Open CASCADE runs out of memory. Open CASCADE throws then, catches its
// exception in the middle of a translation or of a face's mesh, and leaves that out: a third of a
// model would look like all of it. The linker prefers functions of the module to those of its
// libraries, so the libraries make that exception by the function here.
#include <new>

#include <dlfcn.h>

extern "C" {
/// Standard_OutOfMemory::Standard_OutOfMemory(const char*).
__attribute__((visibility("default"))) void
make_out_of_memory(void* exception, const char* message) __asm__("_ZN20Standard_OutOfMemoryC1EPKc");

void make_out_of_memory(void* exception, const char* message) {
    // An exception without a message is made in advance, for lack of memory later. Any other calls
    // the handler that `new` would call: the process that reads reports that memory ran out, and
    // ends.
    const std::new_handler no_memory = std::get_new_handler();
    if (message != nullptr && *message != '\0' && no_memory != nullptr) no_memory();
    using Constructor = void(void*, const char*);
    reinterpret_cast<Constructor*>(dlsym(RTLD_NEXT, "_ZN20Standard_OutOfMemoryC1EPKc"))(exception,
                                                                                        message);
}
}
