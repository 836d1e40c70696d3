// Checkpoints: one that is accepted has the bytes that its state is written with, and the render
// ends from there; one that is not leaves the job as it was. Changed bytes would seldom get past
// the checksum, so each input is tried with the right one as well.
#include <string>
#include <string_view>

#include "base/check.h"
#include "base/parallel.h"
#include "base/text.h"
#include "integrators/integrator.h"
#include "render/checkpoint.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace candela {
namespace {

const CheckpointOwner kOwner{"1", "scene", "options"};

class EvenLight final : public Integrator {
 public:
  void Trace(std::span<const SampleRequest> samples, Workspace*,
             const SampleOutput& output) const override {
    for (size_t i = 0; i < samples.size(); ++i) output.radiance[i] = Spectrum(Rgb{1, 2, 30});
  }
};

/// Six pixels in two tiles.
RenderOptions SmallPicture() {
  RenderOptions options;
  options.width = 3;
  options.height = 2;
  options.crop = {0, 0, 3, 2};
  options.tile_size = 2;
  options.pattern = SamplePattern::kFilter;
  options.samples = 4;
  options.clamp = 10;
  return options;
}

void TryToGoOn(std::string_view bytes) {
  const EvenLight integrator;
  const RenderOptions options = SmallPicture();
  RenderJob job(integrator, options, Film::Keep::kSums);
  static const std::string before = EncodeCheckpoint(job, kOwner);
  const auto loaded = DecodeCheckpoint(bytes, kOwner, &job);
  const std::string after = EncodeCheckpoint(job, kOwner);
  if (!loaded) {
    const std::string& message = loaded.error().message;
    CHECK(!message.empty() && message == EscapeControl(message));
    CHECK(after == before && job.SamplesDone() == 0);
    return;
  }
  CHECK(after == bytes && job.SamplesDone() == job.SamplesInFilm());
  CHECK(job.Run(CancelToken()));
  CHECK(job.SamplesDone() == job.SamplesTotal() && job.SamplesInFilm() == job.SamplesTotal());
}

/// With the last eight bytes that it should have.
std::string WithChecksum(std::string_view bytes) {
  std::string mended(bytes.substr(0, bytes.size() - 8));
  const uint64_t sum = XXH3_64bits(mended.data(), mended.size());
  for (int shift = 0; shift < 64; shift += 8) mended.push_back(static_cast<char>(sum >> shift));
  return mended;
}

}  // namespace
}  // namespace candela

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  static const ThreadLimit one_thread(1);
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  TryToGoOn(bytes);
  if (size >= 8) TryToGoOn(WithChecksum(bytes));
  return 0;
}
