#include "base/page_memory.h"

#include <new>

#include "base/check.h"
#include "base/platform.h"

namespace candela {

PageMemory::PageMemory(size_t bytes) : size_(bytes), reserved_(bytes) {
  if (bytes == 0) return;
  data_ = platform::AllocatePages(bytes);
  if (!data_) throw std::bad_alloc();
}

PageMemory::~PageMemory() {
  if (data_) platform::FreePages(data_, reserved_);
}

void PageMemory::Shrink(size_t bytes) {
  CHECK(bytes <= size_);
  size_ = bytes;
  if (data_) reserved_ = platform::ShrinkPages(data_, reserved_, bytes);
}

}  // namespace candela
