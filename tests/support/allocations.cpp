// tests/support/allocations.cpp: replaces the global operator new with a counting one.
#include "tests/support/allocations.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local std::int64_t count = 0;
thread_local std::size_t watched = 0;  // Bytes; 0: none.
thread_local std::int64_t countOfWatched = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++count;
  if (size == watched) ++countOfWatched;
  const std::size_t whole = size == 0 ? alignment : (size + alignment - 1) / alignment * alignment;
  return std::aligned_alloc(alignment, whole);
}

void* needed(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return needed(counted(size, alignof(std::max_align_t))); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return needed(counted(size, static_cast<std::size_t>(alignment)));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size, alignof(std::max_align_t));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace sinew::test {

std::int64_t allocations() { return count; }

AllocationsOf::AllocationsOf(std::size_t bytes) {
  watched = bytes;
  countOfWatched = 0;
}

AllocationsOf::~AllocationsOf() { watched = 0; }

std::int64_t AllocationsOf::count() const { return countOfWatched; }

}  // namespace sinew::test
