#include "render/checkpoint.h"

#include <gtest/gtest.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "integrators/integrator.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

/// Noise, some of it bright and some of it no light at all. `on_sample` is told of each sample.
class NoisyIntegrator final : public Integrator {
 public:
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override {
    for (size_t i = 0; i < samples.size(); ++i) {
      const auto& [x, y, index, p, spacing] = samples[i];
      const Sampler sampler(0, x, y, index, SamplerKind::kIndependent);
      const float red = sampler.Get1D(4);
      const float scale = sampler.Get1D(5) < 0.01f ? 1000.0f : 1.0f;
      const bool is_broken = x == 3 && index % 7 == 5;
      output.radiance[i] = Spectrum(Rgb{red * scale, p.x, is_broken ? kNaN : p.y});
      if (on_sample) on_sample(samples[i]);
    }
    workspace->rays.camera += samples.size();
  }

  static constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  std::function<void(const SampleRequest&)> on_sample;
};

RenderOptions Options(uint32_t samples) {
  RenderOptions options;
  options.width = 50;
  options.height = 40;
  options.crop = {2, 3, 50, 37};
  options.pattern = SamplePattern::kFilter;
  options.filter = "mitchell";
  options.samples = samples;
  options.clamp = 100;
  return options;
}

const CheckpointOwner kOwner{"1.0", "scene", "options"};

struct Outcome {
  explicit Outcome(const RenderJob& job)
      : dropped(job.Dropped().Count()), share(job.Lost().Share()), clamped(job.Lost().samples) {
    const PixelWindow& window = job.film().Window();
    for (int y = window.y0; y < window.y1; ++y) {
      colours.insert(colours.end(), job.film().Row(y).begin(), job.film().Row(y).end());
    }
    if (!job.Dropped().First().empty()) first_dropped = job.Dropped().First()[0].index;
  }
  std::vector<float> colours;
  uint64_t dropped;
  uint32_t first_dropped = 0;
  double share;
  uint64_t clamped;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome AtOnce(uint32_t samples) {
  const NoisyIntegrator integrator;
  const RenderOptions options = Options(samples);
  RenderJob job(integrator, options);
  EXPECT_TRUE(job.Run(CancelToken()));
  return Outcome(job);
}

std::string SavedAfter(uint32_t samples) {
  const NoisyIntegrator integrator;
  const RenderOptions options = Options(samples);
  RenderJob job(integrator, options, Film::Keep::kSums);
  EXPECT_TRUE(job.Run(CancelToken()));
  return EncodeCheckpoint(job, kOwner);
}

Outcome Continued(const std::string& checkpoint, uint32_t samples) {
  NoisyIntegrator integrator;
  const RenderOptions options = Options(samples);
  RenderJob job(integrator, options, Film::Keep::kSums);
  const auto loaded = DecodeCheckpoint(checkpoint, kOwner, &job);
  EXPECT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(job.Run(CancelToken()));
  EXPECT_EQ(job.SamplesDone(), job.SamplesTotal());
  return Outcome(job);
}

TEST(Checkpoint, AHundredSamplesAndFourHundredMoreAreFiveHundred) {
  const Outcome expected = AtOnce(500);
  EXPECT_GT(expected.dropped, 0u);
  EXPECT_GT(expected.share, 0);
  EXPECT_EQ(Continued(SavedAfter(100), 500), expected);
}

TEST(Checkpoint, ASavedPictureThatIsDoneIsJustDeveloped) {
  EXPECT_EQ(Continued(SavedAfter(20), 20), AtOnce(20));
}

// Wherever it stops: in the middle of a pass some tiles are further than others.
TEST(Checkpoint, AStoppedRenderGoesOnWhereItWas) {
  const Outcome expected = AtOnce(40);
  for (const uint32_t stop_at : {1u, 700u, 30000u, 45000u}) {
    NoisyIntegrator integrator;
    std::atomic<uint32_t> samples = 0;
    CancelToken cancel;
    integrator.on_sample = [&](const SampleRequest&) {
      if (++samples == stop_at) cancel.Cancel();
    };
    const RenderOptions options = Options(40);
    RenderJob job(integrator, options, Film::Keep::kSums);
    const auto done = job.Run(cancel);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::kStopped);
    EXPECT_LT(job.SamplesInFilm(), job.SamplesTotal());
    EXPECT_EQ(Continued(EncodeCheckpoint(job, kOwner), 40), expected) << stop_at;
  }
}

TEST(Checkpoint, IsTakenBetweenPasses) {
  const NoisyIntegrator integrator;
  const RenderOptions options = Options(40);
  RenderJob job(integrator, options, Film::Keep::kSums);
  std::vector<std::string> saved;
  ASSERT_TRUE(job.Run(CancelToken(), nullptr, [&] {
    saved.push_back(EncodeCheckpoint(job, kOwner));
    return Result<void>();
  }));
  ASSERT_EQ(saved.size(), 2u);
  for (const std::string& checkpoint : saved) EXPECT_EQ(Continued(checkpoint, 40), AtOnce(40));
}

std::string Refusal(const std::string& bytes, const CheckpointOwner& owner,
                    uint32_t samples = 100) {
  const NoisyIntegrator integrator;
  const RenderOptions options = Options(samples);
  RenderJob job(integrator, options, Film::Keep::kSums);
  const auto loaded = DecodeCheckpoint(bytes, owner, &job);
  EXPECT_FALSE(loaded);
  EXPECT_EQ(job.SamplesDone(), 0u);
  return loaded ? "" : loaded.error().message;
}

TEST(Checkpoint, OfSomebodyElseIsRefused) {
  const std::string saved = SavedAfter(20);
  EXPECT_EQ(Refusal(saved, {"1.1", "scene", "options"}),
            "was made by version 1.0, this is 1.1; both may draw other samples");
  EXPECT_EQ(Refusal(saved, {"1.0", "other", "options"}),
            "belongs to another scene, or one of the scene's files has changed since");
  EXPECT_EQ(Refusal(saved, {"1.0", "scene", "more"}),
            "was made with other options, options, where now there are more");
  EXPECT_EQ(Refusal(saved, kOwner, 16),
            "holds 20 samples of each pixel already, more than the 16 asked for");
}

TEST(Checkpoint, TruncatedOrDamagedIsRefused) {
  const std::string saved = SavedAfter(20);
  EXPECT_EQ(Refusal("", kOwner), "is not a checkpoint of this program");
  EXPECT_EQ(Refusal("PNG and so on, and on, and on", kOwner),
            "is not a checkpoint of this program");
  for (size_t size = 21; size < saved.size(); size += 997) {
    EXPECT_EQ(Refusal(saved.substr(0, size), kOwner), "is truncated or damaged") << size;
  }
  EXPECT_EQ(Refusal(saved + "x", kOwner), "is truncated or damaged");
  for (size_t i = 21; i < saved.size(); i += 1009) {
    std::string damaged = saved;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    EXPECT_EQ(Refusal(damaged, kOwner), "is truncated or damaged") << i;
  }
}

/// With the checksum of its bytes at the end, as a file that somebody has made up.
std::string WithChecksum(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const uint64_t sum = XXH3_64bits(bytes.data(), bytes.size());
  for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<char>(sum >> shift));
  return bytes;
}

TEST(Checkpoint, NumbersThatAreNeverWrittenAreRefused) {
  const std::string saved = SavedAfter(20);
  ASSERT_EQ(WithChecksum(saved), saved);
  constexpr size_t kMagicAndOwner = 21 + 3 * 8 + 3 + 5 + 7;
  constexpr size_t kFirstTile = kMagicAndOwner + 8;
  constexpr size_t kFirstSum = kFirstTile + 4 * 8 + 8;
  // Samples beyond 32 bits, a fraction of a sum that is 1 and more, more tiles than fit in.
  for (const size_t byte : {kFirstTile + 4, kFirstSum + 8 + 6, kMagicAndOwner + 5}) {
    std::string changed = saved;
    changed[byte] = 1;
    EXPECT_EQ(Refusal(WithChecksum(changed), kOwner), "is truncated or damaged") << byte;
  }
}

TEST(Checkpoint, WordsOfTheFileAreSafeToPrint) {
  const NoisyIntegrator integrator;
  const RenderOptions options = Options(20);
  const RenderJob job(integrator, options, Film::Keep::kSums);
  EXPECT_EQ(Refusal(EncodeCheckpoint(job, {"1\x1b[2J", "scene", "options"}), kOwner),
            "was made by version 1\\x1b[2J, this is 1.0; both may draw other samples");
}

}  // namespace
}  // namespace candela
