// app/ui/freed_memory.h: keeps freed memory for reuse.
#pragma once

namespace sinew::app {

/// For drawing on the processor: Mesa allocates and frees some hundred kilobytes for each piece of a mesh, which is
/// much slower if they go back to the system each time. Keeps 64 MB at most. Does nothing without glibc.
void keepFreedMemory();

}  // namespace sinew::app
