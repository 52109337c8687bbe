#include "tests/apps/counted_allocations.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations = 0;

void* try_to_allocate(std::size_t size, std::size_t alignment) noexcept {
  ++allocations;
  const std::size_t whole =
      (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment;
  return std::aligned_alloc(alignment, whole);
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (void* memory = try_to_allocate(size, alignment)) return memory;
  throw std::bad_alloc();
}

constexpr std::size_t usual = alignof(std::max_align_t);

std::size_t number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

// Every form of them: those of a sanitizer do not call each other, as those of the library do, and
// memory of the one must not be freed by the other.
using std::align_val_t, std::nothrow_t, std::size_t;

void* operator new(size_t size) { return allocate(size, usual); }
void* operator new[](size_t size) { return allocate(size, usual); }
void* operator new(size_t size, align_val_t a) { return allocate(size, number(a)); }
void* operator new[](size_t size, align_val_t a) { return allocate(size, number(a)); }
void* operator new(size_t size, const nothrow_t&) noexcept { return try_to_allocate(size, usual); }
void* operator new[](size_t size, const nothrow_t&) noexcept {
  return try_to_allocate(size, usual);
}
void* operator new(size_t size, align_val_t a, const nothrow_t&) noexcept {
  return try_to_allocate(size, number(a));
}
void* operator new[](size_t size, align_val_t a, const nothrow_t&) noexcept {
  return try_to_allocate(size, number(a));
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, size_t, align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t, align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, const nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, align_val_t, const nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, align_val_t, const nothrow_t&) noexcept { std::free(memory); }

namespace ringlet {

long allocation_count() { return allocations; }

}  // namespace ringlet
