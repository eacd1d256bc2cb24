// Open CASCADE throws where memory runs out, catches that itself in the middle of a translation or
// of a face's mesh, and leaves out what it was at: a third of a model would look like all of it.
// The linker finds what the module itself defines before what its libraries do, so its libraries
// make that exception by the function here.
#include <new>

#include <dlfcn.h>

extern "C" {
/// Standard_OutOfMemory::Standard_OutOfMemory(const char*).
__attribute__((visibility("default"))) void
make_out_of_memory(void* exception, const char* message) __asm__("_ZN20Standard_OutOfMemoryC1EPKc");

void make_out_of_memory(void* exception, const char* message) {
    // One without a message is made in advance, since there will be no memory for it. What `new`
    // does first where there is none: the process that reads says so and ends.
    const std::new_handler no_memory = std::get_new_handler();
    if (message != nullptr && *message != '\0' && no_memory != nullptr) no_memory();
    using Constructor = void(void*, const char*);
    reinterpret_cast<Constructor*>(dlsym(RTLD_NEXT, "_ZN20Standard_OutOfMemoryC1EPKc"))(exception,
                                                                                        message);
}
}
