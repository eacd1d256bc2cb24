#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace lineatlas::viewer {

/// Gives freed memory back to the system. glibc keeps it in a heap for each thread; what threads
/// have read, drawn and saved is freed in pieces, and hundreds of megabytes would stay.
inline void give_freed_memory_back() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

} // namespace lineatlas::viewer
