// app/ui/freed_memory.h: memory that is given back is kept for the next who asks.
#pragma once

namespace sinew::app {

/// For a process that draws on the processor. Mesa asks for some hundred kilobytes for each piece of a mesh and gives
/// them back; where they go to the system each time and come back page by page, drawing many vertices takes much
/// longer. Keeps 64 MB at most. Without glibc: nothing.
void keepFreedMemory();

}  // namespace sinew::app
