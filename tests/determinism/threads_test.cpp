// A picture does not depend on how many threads render it, nor on the tiles that they take.
#include <gtest/gtest.h>

#include <atomic>

#include "base/parallel.h"
#include "driver/map_images.h"
#include "render/render_first_hits.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/effort.h"
#include "tests/support/meeting.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

using testing_support::Meeting;
using testing_support::RenderImage;
using testing_support::WholePicture;

// Sides that no tile size divides.
constexpr int kWidth = testing_support::kIsSanitized ? 31 : 61;
constexpr int kHeight = testing_support::kIsSanitized ? 23 : 47;

Image RenderWith(int threads, uint32_t tile_size, const Integrator& integrator,
                 RenderOptions options) {
  const ThreadLimit limit(threads);
  options.tile_size = tile_size;
  return RenderImage(integrator, options);
}

class Picture : public testing::TestWithParam<std::tuple<const char*, Placement>> {};

TEST_P(Picture, IsTheSameForAnyThreadsAndTiles) {
  const auto& [name, placement] = GetParam();
  const Subject subject = MakeSubject(name, 1);
  ASSERT_TRUE(subject.integrator);
  const RenderOptions options = OptionsFor(placement, kWidth, kHeight);
  const Image expected = RenderWith(1, 32, *subject.integrator, options);
  struct Workers {
    int threads;
    uint32_t tile_size;
  };
  for (const auto& [threads, tile_size] :
       {Workers{1, 5}, Workers{2, 1000}, Workers{7, 5}, Workers{7, 16}}) {
    EXPECT_TRUE(RenderWith(threads, tile_size, *subject.integrator, options) == expected)
        << threads << " threads, tiles of " << tile_size;
  }
}

TEST_P(Picture, OfWhatMovesIsTheSameForAnyThreadsAndTiles) {
  const auto& [name, placement] = GetParam();
  const Subject subject = MakeMovingSubject(name, 1);
  ASSERT_TRUE(subject.integrator);
  const RenderOptions options = OptionsFor(placement, kWidth, kHeight);
  EXPECT_TRUE(RenderWith(7, 5, *subject.integrator, options) ==
              RenderWith(1, 1000, *subject.integrator, options));
}

INSTANTIATE_TEST_SUITE_P(All, Picture,
                         testing::Combine(testing::Values("whitted", "path", "light_trace",
                                                          "distribution"),
                                          testing::ValuesIn(ComparedPlacements())),
                         [](const auto& test) {
                           return std::get<0>(test.param) + ("_" + std::get<1>(test.param).name);
                         });

TEST(Picture, DependsOnTheSeedWhereSamplesAreDrawn) {
  // Else the tests above could compare pictures in which chance has no part.
  const Subject subject = MakeSubject("path", 1);
  ASSERT_TRUE(subject.integrator);
  RenderOptions options = OptionsFor(AllPlacements().back(), kWidth, kHeight);
  const Image one = RenderImage(*subject.integrator, options);
  options.seed = 2;
  EXPECT_FALSE(RenderImage(*subject.integrator, options) == one);
}

/// Does its work only once seven threads have come to do it.
class Gathering final : public Integrator {
 public:
  explicit Gathering(const Integrator& inner) : inner_(inner) {}

  std::unique_ptr<Workspace> MakeWorkspace() const override { return inner_.MakeWorkspace(); }
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override {
    if (!meeting_.Join()) has_failed_ = true;
    inner_.Trace(samples, workspace, output);
  }

  bool HasFailed() const { return has_failed_; }

 private:
  const Integrator& inner_;
  mutable Meeting meeting_{7};
  mutable std::atomic<bool> has_failed_ = false;
};

TEST(Picture, OfSevenThreadsComesFromSeven) {
  const Subject subject = MakeSubject("whitted", 1);
  ASSERT_TRUE(subject.integrator);
  const RenderOptions options = WholePicture(kWidth, kHeight);
  const Gathering gathering(*subject.integrator);
  const Image gathered = RenderWith(7, 4, gathering, options);
  EXPECT_FALSE(gathering.HasFailed()) << "fewer than seven threads took part";
  EXPECT_TRUE(gathered == RenderWith(1, 4, *subject.integrator, options));
}

TEST(FirstHits, AreTheSameForAnyThreads) {
  const Subject subject = MakeSubject("whitted", 3);
  ASSERT_TRUE(subject.scene);
  const RenderOptions options = WholePicture(kWidth, kHeight);
  const auto maps = [&](int threads) {
    const ThreadLimit limit(threads);
    const auto hits = RenderFirstHits(*subject.scene, options);
    return std::pair(NormalImage(hits, options.crop, ImageFormat::kPfm),
                     DepthImage(hits, options.crop, {}, ImageFormat::kPfm));
  };
  const auto expected = maps(1);
  EXPECT_TRUE(maps(2) == expected);
  EXPECT_TRUE(maps(7) == expected);
}

}  // namespace
}  // namespace candela::determinism
