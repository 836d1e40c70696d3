#include "render/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

// The functions themselves instead of a library that has to be found.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "base/text.h"

namespace candela {
namespace {

constexpr std::string_view kMagic = "candela checkpoint 1\n";
constexpr size_t kWordBytes = 8;

/// Appends whole numbers of 64 bits, the lowest byte first, to a file.
class Writer {
 public:
  explicit Writer(size_t capacity) { bytes_.reserve(capacity), bytes_ = kMagic; }

  void Put(uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<char>(word >> shift));
  }
  void Put(const ExactSum& sum) {
    for (const uint64_t word : sum.Words()) Put(word);
  }
  void Put(const std::string& text) {
    Put(text.size());
    bytes_ += text;
  }
  std::string Finish() && {
    Put(XXH3_64bits(bytes_.data(), bytes_.size()));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

/// Reads them again. What lies beyond the end is 0, and numbers may be none that `Writer` writes;
/// `IsSound` tells afterwards.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  uint64_t Word() {
    const std::string_view part = Take(kWordBytes);
    uint64_t word = 0;
    for (size_t i = 0; i < part.size(); ++i) {
      word |= uint64_t{static_cast<unsigned char>(part[i])} << (8 * i);
    }
    return word;
  }
  /// A word that holds a number of 32 bits.
  uint32_t Half() {
    const uint64_t word = Word();
    if (word > std::numeric_limits<uint32_t>::max()) is_sound_ = false;
    return static_cast<uint32_t>(word);
  }
  ExactSum Sum() {
    const uint64_t whole = Word(), fraction = Word();
    const ExactSum sum = ExactSum::FromWords(whole, fraction);
    if (sum.Words() != std::array{whole, fraction}) is_sound_ = false;
    return sum;
  }
  std::string Text() { return std::string(Take(Word())); }

  /// A number of entries of so many words each, which cannot be more than are left.
  size_t Count(size_t words) {
    const uint64_t count = Word();
    if (count <= bytes_.size() / (words * kWordBytes)) return count;
    is_sound_ = false;
    return 0;
  }
  /// Everything was there and as it is written, and nothing is left.
  bool IsSound() const { return is_sound_ && bytes_.empty(); }

 private:
  std::string_view Take(uint64_t size) {
    if (size > bytes_.size()) is_sound_ = false;
    const std::string_view part = bytes_.substr(0, size);
    bytes_.remove_prefix(part.size());
    return part;
  }

  std::string_view bytes_;
  bool is_sound_ = true;
};

uint64_t BitsOf(float value) {
  return std::bit_cast<uint32_t>(value);
}

Error InputError(std::string message) {
  return {ErrorCode::kInput, std::move(message)};
}

Result<void> CheckOwner(const CheckpointOwner& found, const CheckpointOwner& expected) {
  if (found.version != expected.version) {
    return InputError(fmt::format("was made by version {}, this is {}; both may draw other samples",
                                  EscapeControl(found.version), expected.version));
  }
  if (found.scene != expected.scene) {
    return InputError("belongs to another scene, or one of the scene's files has changed since");
  }
  if (found.options != expected.options) {
    return InputError(fmt::format("was made with other options, {}, where now there are {}",
                                  EscapeControl(found.options), expected.options));
  }
  return {};
}

constexpr size_t kPixelWords = 8;
constexpr size_t kDroppedWords = 6;

}  // namespace

std::string EncodeCheckpoint(const RenderJob& job, const CheckpointOwner& owner) {
  const std::span<const PixelSums> sums = job.film().Sums();
  // Room for everything: a file that grows takes twice its memory.
  constexpr size_t kOthers = size_t{1} << 16;
  Writer file(kWordBytes * (kPixelWords * sums.size() + job.TileSamples().size()) + kOthers);
  file.Put(owner.version);
  file.Put(owner.scene);
  file.Put(owner.options);
  file.Put(job.TileSamples().size());
  for (const uint32_t samples : job.TileSamples()) file.Put(samples);
  file.Put(sums.size());
  for (const PixelSums& pixel : sums) {
    for (const ExactSum* sum : {&pixel.red, &pixel.green, &pixel.blue, &pixel.weight}) {
      file.Put(*sum);
    }
  }
  file.Put(job.Dropped().Count());
  file.Put(job.Dropped().First().size());
  for (const DroppedSamples::Sample& sample : job.Dropped().First()) {
    file.Put(static_cast<uint32_t>(sample.x));
    file.Put(static_cast<uint32_t>(sample.y));
    file.Put(sample.index);
    for (int i = 0; i < 3; ++i) file.Put(BitsOf(sample.radiance[i]));
  }
  file.Put(job.Lost().samples);
  file.Put(job.Lost().light);
  file.Put(job.Lost().lost);
  return std::move(file).Finish();
}

Result<void> DecodeCheckpoint(std::string_view bytes, const CheckpointOwner& owner,
                              RenderJob* job) {
  if (!bytes.starts_with(kMagic)) return InputError("is not a checkpoint of this program");
  const Error damaged = InputError("is truncated or damaged");
  if (bytes.size() < kMagic.size() + kWordBytes) return damaged;
  const std::string_view content = bytes.substr(0, bytes.size() - kWordBytes);
  if (Reader(bytes.substr(content.size())).Word() != XXH3_64bits(content.data(), content.size())) {
    return damaged;
  }
  Reader file(content.substr(kMagic.size()));
  CheckpointOwner found;
  found.version = file.Text();
  found.scene = file.Text();
  found.options = file.Text();
  if (const auto checked = CheckOwner(found, owner); !checked) return checked;

  RenderState state;
  state.tile_samples.resize(file.Count(1));
  for (uint32_t& samples : state.tile_samples) samples = file.Half();
  state.sums.resize(file.Count(kPixelWords));
  for (PixelSums& pixel : state.sums) {
    for (ExactSum* sum : {&pixel.red, &pixel.green, &pixel.blue, &pixel.weight}) {
      *sum = file.Sum();
    }
  }
  const uint64_t dropped = file.Word();
  std::vector<DroppedSamples::Sample> first(file.Count(kDroppedWords));
  for (DroppedSamples::Sample& sample : first) {
    sample.x = static_cast<int>(file.Half());
    sample.y = static_cast<int>(file.Half());
    sample.index = file.Half();
    for (int i = 0; i < 3; ++i) sample.radiance[i] = std::bit_cast<float>(file.Half());
  }
  if (first.size() > std::min<uint64_t>(dropped, DroppedSamples::kMostNamed)) return damaged;
  state.dropped = DroppedSamples(dropped, std::move(first));
  state.lost.samples = file.Word();
  state.lost.light = file.Sum();
  state.lost.lost = file.Sum();
  if (!file.IsSound() || !job->CanRestore(state)) return damaged;
  const uint32_t most = *std::ranges::max_element(state.tile_samples);
  if (most > job->SamplesOfPixel()) {
    return InputError(
        fmt::format("holds {} samples of each pixel already, more than the {} asked "
                    "for",
                    most, job->SamplesOfPixel()));
  }
  job->Restore(state);
  return {};
}

}  // namespace candela
