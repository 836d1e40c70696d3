#include "base/page_memory.h"

#include <new>

#include "base/platform.h"

namespace candela {

PageMemory::PageMemory(size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  data_ = platform::AllocatePages(bytes);
  if (!data_) throw std::bad_alloc();
}

PageMemory::~PageMemory() {
  if (data_) platform::FreePages(data_, size_);
}

}  // namespace candela
