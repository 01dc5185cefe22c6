// app/ui/freed_memory.cpp: two settings of glibc's allocator.
#include "app/ui/freed_memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace sinew::app {

void keepFreedMemory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, 16 << 20);  // Larger ones go back at once.
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace sinew::app
