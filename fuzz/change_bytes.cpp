// For formats in which parts are found by their place or length: an input that grows or shrinks
// seldom gets past the header, so half of the time this mutator changes bytes where they are.
#include <cstddef>
#include <random>

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t most);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t most,
                                          unsigned seed) {
  std::minstd_rand random(seed);
  if (size == 0 || random() % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  for (auto changes = 1 + random() % 4; changes > 0; --changes) {
    unsigned char& byte = data[random() % size];
    const auto kind = random() % 3;
    if (kind == 0) byte = static_cast<unsigned char>(random());
    if (kind == 1) byte = static_cast<unsigned char>(byte ^ 1u << random() % 8);
    if (kind == 2) byte = static_cast<unsigned char>(byte + (random() % 2 == 0 ? 1 : 255));
  }
  return size;
}
