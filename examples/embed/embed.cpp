// The smallest program that uses the library.
#include <candela/candela.h>

#include <cstdio>

int main() {
  const auto missing = candela::ReadFile("no-such-file");
  std::printf("%d threads; %s\n", candela::ThreadCount(), missing.error().message.c_str());
}
