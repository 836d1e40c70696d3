// What a ray hits, and what a sample sees, does not depend on the list in which it is asked for.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "render/sample_placer.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

constexpr int kWidth = 48, kHeight = 48;

std::vector<SampleRequest> Requests() {
  const RenderOptions options = testing_support::WholePicture(kWidth, kHeight);
  const SamplePlacer placer(options);
  std::vector<SampleRequest> requests;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) requests.push_back(placer.Centre(x, y));
  }
  return requests;
}

std::vector<Spectrum> TraceInLists(const Integrator& integrator,
                                   const std::vector<SampleRequest>& requests, size_t length) {
  std::vector<Spectrum> radiance(requests.size());
  const auto workspace = integrator.MakeWorkspace();
  const std::span<const SampleRequest> all = requests;
  for (size_t begin = 0; begin < all.size(); begin += length) {
    const size_t count = std::min(length, all.size() - begin);
    integrator.Trace(all.subspan(begin, count), workspace.get(),
                     {std::span(radiance).subspan(begin, count)});
  }
  EXPECT_EQ(workspace->rays.camera, requests.size());
  return radiance;
}

class Lists : public testing::TestWithParam<const char*> {};

TEST_P(Lists, OfAnyLengthGiveTheSameRadiance) {
  const std::vector<SampleRequest> requests = Requests();
  for (uint32_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Subject subject = MakeMeshSubject(GetParam(), seed);
    ASSERT_TRUE(subject.integrator);
    const auto alone = TraceInLists(*subject.integrator, requests, 1);
    for (const size_t length : {size_t{7}, size_t{1024}, requests.size()}) {
      EXPECT_TRUE(TraceInLists(*subject.integrator, requests, length) == alone) << length;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Lists,
                         testing::Values("whitted", "path", "light_trace", "direct",
                                         "ambient_occlusion", "debug"),
                         [](const auto& test) { return std::string(test.param); });

bool AreSame(const HitRecord& a, const HitRecord& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(ListsOfRays, GiveTheHitsOfSingleRays) {
  const Subject subject = MakeMeshSubject("whitted", 5);
  ASSERT_TRUE(subject.scene);
  std::vector<Ray> rays;
  for (const SampleRequest& request : Requests()) {
    rays.push_back(subject.scene->camera().GenerateRay(request.image_point));
  }
  for (const RayOrder order : {RayOrder::kCoherent, RayOrder::kScattered}) {
    std::vector<HitRecord> hits(rays.size());
    std::vector<uint8_t> occluded(rays.size());
    subject.scene->Intersect(order, rays, hits);
    subject.scene->Occluded(order, rays, occluded);
    for (size_t i = 0; i < rays.size(); ++i) {
      HitRecord alone;
      EXPECT_EQ(subject.scene->Intersect(rays[i], &alone), hits[i].IsHit());
      EXPECT_TRUE(AreSame(alone, hits[i]));
      EXPECT_EQ(subject.scene->Occluded(rays[i]), occluded[i] != 0);
      EXPECT_EQ(occluded[i] != 0, hits[i].IsHit());
    }
  }
}

}  // namespace
}  // namespace candela::determinism
