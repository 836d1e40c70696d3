// What reaches the terminal: no control characters, no broken UTF-8, bounded length.
#include "base/text.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/check.h"
#include "base/diagnostics.h"

namespace {

bool IsPrintable(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  const std::string_view text(reinterpret_cast<const char*>(data), size);

  const std::string escaped = EscapeControl(text);
  CHECK(IsPrintable(escaped) && EscapeControl(escaped) == escaped);
  CHECK(Quote(text).size() <= 62);
  const std::string cut = CutTo(100, escaped);
  CHECK(cut.size() <= 100 && EscapeControl(cut) == cut);

  // The first line is a word, the others are the candidates.
  std::vector<std::string_view> words;
  for (size_t start = 0; start <= text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    words.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  const auto nearest = Nearest(words[0], std::span(words).subspan(1));
  CHECK(!nearest || std::find(words.begin() + 1, words.end(), *nearest) != words.end());

  Diagnostics diagnostics;
  diagnostics.Error({std::make_shared<const std::string>(text), 1, 1}, std::string(text));
  for (const std::string& line : diagnostics.Lines()) CHECK(line.size() < 500 && IsPrintable(line));
  return 0;
}
