#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "integrators/integrator.h"
#include "render/render_job.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

constexpr int kSide = NoiseBlock::kSide;

/// Light of the mean 3 + x + y in image points, whose noise grows to the right. One part in ten of
/// it comes in samples of which there are few.
class KnownLight final : public Integrator {
 public:
  /// The dice may be the same for all pixels of a block; then it has no more to say than a pixel.
  KnownLight(float rarity, bool has_dice_for_blocks)
      : rarity_(rarity), has_dice_for_blocks_(has_dice_for_blocks) {}

  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override {
    for (size_t i = 0; i < samples.size(); ++i) {
      const SampleRequest& request = samples[i];
      const Vec2 p = request.image_point;
      const uint32_t unit = has_dice_for_blocks_ ? kSide : 1;
      const Sampler sampler(9, request.x / unit, request.y / unit * unit, request.index,
                            SamplerKind::kIndependent);
      const float spread = 0.1f + 0.9f * (p.x + 1) / 2;
      const float even = 1 + spread * (2 * sampler.Get1D(20) - 1);
      const float rare = sampler.Get1D(21) < rarity_ ? 1 / rarity_ : 0.0f;
      const float light = Mean(p) * (0.9f * even + 0.1f * rare);
      output.radiance[i] = Spectrum(Rgb{light, light, light});
    }
    workspace->rays.camera += samples.size();
  }

  static float Mean(Vec2 p) { return 3 + p.x + p.y; }

 private:
  const float rarity_;
  const bool has_dice_for_blocks_;
};

RenderOptions Options(int width, int height, float target) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.crop = {0, 0, width, height};
  options.grid = PixelGrid::kCentres;
  options.pattern = SamplePattern::kFilter;
  options.samples = 1 << 20;
  options.noise_target = target;
  options.layers = LayerSet{Layer::kSampleCount, Layer::kStandardError};
  return options;
}

/// What a pixel differs from its mean, as a part of that.
double OffAt(const Film& film, const RenderOptions& options, int x, int y) {
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const auto place = [](int i, int count) {
    return (2 * static_cast<float>(i) + 1) / static_cast<float>(count) - 1;
  };
  const float mean =
      KnownLight::Mean({place(x, options.width) * aspect, -place(y, options.height)});
  return static_cast<double>(film.Pixel(x, y).x / mean - 1);
}

double ErrorAt(const Film& film, size_t pixel) {
  return static_cast<double>(
      std::bit_cast<float>(film.LayerWords(Layer::kStandardError)[3 * pixel]));
}

void RunToTheEnd(RenderJob* job) {
  ASSERT_TRUE(job->Run(CancelToken()));
}

// P11: of 10,000 intervals of 95 %, at least 93 % hold the truth.
TEST(NoiseTarget, TellsHowFarPixelsAreOff) {
  const KnownLight light(0.1f, false);
  for (const float target : {0.1f, 0.03f}) {
    const RenderOptions options = Options(100, 100, target);
    RenderJob job(light, options);
    RunToTheEnd(&job);
    int inside = 0, quiet = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const double value = static_cast<double>(job.film().Pixel(x, y).x);
        const double error = ErrorAt(job.film(), static_cast<size_t>(y * 100 + x));
        if (std::abs(OffAt(job.film(), options, x, y)) * value <= 1.96 * error) ++inside;
        if (error <= static_cast<double>(target) * value) ++quiet;
      }
    }
    EXPECT_GE(inside, 9300);
    EXPECT_GE(quiet, 9500);
    EXPECT_EQ(job.NoisyPart(), 0);
  }
}

// Blocks that stop when they look quiet by themselves would lose 7 % of the light here, 30 times
// the error of this test: they stop while what is rare has not come up.
TEST(NoiseTarget, LosesNoLight) {
  const KnownLight light(0.01f, true);
  const RenderOptions options = Options(1, 2048 * kSide, 0.1f);
  RenderJob job(light, options);
  RunToTheEnd(&job);
  double sum = 0, squares = 0;
  for (int y = 0; y < options.height; y += kSide) {
    for (int x = 0; x < options.width; x += kSide) {
      const double off = OffAt(job.film(), options, x, y);
      sum += off;
      squares += off * off;
    }
  }
  EXPECT_LE(std::abs(sum), 3 * std::sqrt(squares));
}

std::vector<float> ColoursOf(const RenderJob& job, const PixelWindow& window) {
  std::vector<float> colours;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const Rgb colour = job.film().Pixel(x, y);
      colours.insert(colours.end(), {colour.x, colour.y, colour.z});
    }
  }
  return colours;
}

TEST(NoiseTarget, GivesTheSameForAnyThreadsAndCrop) {
  const KnownLight light(0.1f, false);
  RenderOptions options = Options(70, 50, 0.1f);
  const PixelWindow part{13, 18, 51, 50};
  std::vector<float> colours;
  {
    const ThreadLimit threads(1);
    RenderJob job(light, options);
    RunToTheEnd(&job);
    colours = ColoursOf(job, part);
  }
  const ThreadLimit threads(4);
  options.crop = part;
  RenderJob job(light, options);
  RunToTheEnd(&job);
  EXPECT_EQ(ColoursOf(job, part), colours);
}

TEST(NoiseTarget, EndsWithAsManySamplesAsThereMayBe) {
  const KnownLight light(0.1f, false);
  for (const uint32_t samples : {1u, 7u, 50u}) {
    RenderOptions options = Options(20, 20, 1e-6f);
    options.samples = samples;
    RenderJob job(light, options);
    RunToTheEnd(&job);
    EXPECT_EQ(job.NoisyPart(), 1) << samples;
    const uint32_t even = samples + samples % 2;
    EXPECT_EQ(job.SamplesInFilm(), 400 * even);
    for (const uint32_t count : job.film().LayerWords(Layer::kSampleCount)) {
      ASSERT_EQ(count, even);
    }
  }
}

TEST(NoiseTarget, CountsTheSamplesOfEachPixel) {
  const KnownLight light(0.1f, false);
  const RenderOptions options = Options(64, 64, 0.05f);
  RenderJob job(light, options);
  RunToTheEnd(&job);
  const auto counts = job.film().LayerWords(Layer::kSampleCount);
  EXPECT_LT(2 * counts[0], counts[63]);  // The noise grows to the right.
  uint64_t sum = 0;
  for (const uint32_t count : counts) sum += count;
  EXPECT_EQ(job.SamplesInFilm(), sum);
}

// Without time there are still the first samples, and all blocks have as many.
TEST(NoiseTarget, WithATimeLimitShowsWhatThereIs) {
  const KnownLight light(0.1f, false);
  RenderOptions options = Options(40, 40, 1e-6f);
  options.time_limit = 0;
  RenderJob short_job(light, options);
  RunToTheEnd(&short_job);
  EXPECT_EQ(short_job.NoisyPart(), 1);
  EXPECT_EQ(short_job.SamplesInFilm(), 32 * 1600u);
  options.noise_target = 0.1f;
  options.time_limit = 1e6;
  RenderJob job(light, options);
  RunToTheEnd(&job);
  options.time_limit.reset();
  RenderJob unlimited(light, options);
  RunToTheEnd(&unlimited);
  EXPECT_EQ(ColoursOf(job, options.crop), ColoursOf(unlimited, options.crop));
  EXPECT_EQ(job.SamplesInFilm(), unlimited.SamplesInFilm());
  EXPECT_EQ(job.Progress(), 1);
}

TEST(TimeLimit, LeavesEveryPixelASample) {
  const KnownLight light(0.1f, false);
  RenderOptions options = Options(40, 40, 1);
  options.noise_target.reset();
  options.time_limit = 0;
  RenderJob short_job(light, options, Film::Keep::kSums);
  RunToTheEnd(&short_job);
  EXPECT_EQ(short_job.SamplesInFilm(), 1600u);
  options.samples = 1;
  options.time_limit.reset();
  RenderJob one(light, options);
  RunToTheEnd(&one);
  EXPECT_EQ(ColoursOf(short_job, options.crop), ColoursOf(one, options.crop));
}

// Also of layers, which are sums in passes then.
TEST(TimeLimit, ThatIsNotReachedChangesNothing) {
  const KnownLight light(0.1f, false);
  RenderOptions options = Options(40, 40, 1);
  options.noise_target.reset();
  options.samples = 77;
  RenderJob plain(light, options);
  RunToTheEnd(&plain);
  options.time_limit = 1e6;
  RenderJob job(light, options, Film::Keep::kSums);
  RunToTheEnd(&job);
  EXPECT_EQ(ColoursOf(job, options.crop), ColoursOf(plain, options.crop));
  for (const Layer layer : {Layer::kSampleCount, Layer::kStandardError}) {
    const auto a = job.film().LayerWords(layer), b = plain.film().LayerWords(layer);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  }
}

}  // namespace
}  // namespace candela
