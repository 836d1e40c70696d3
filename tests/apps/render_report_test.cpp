#include "driver/render_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace candela {
namespace {

RenderStatistics Example() {
  RenderStatistics statistics;
  statistics.scene = "arch\xff\".txt";
  statistics.integrator = "whitted";
  statistics.width = 30;
  statistics.height = 20;
  statistics.samples_per_pixel = 4;
  statistics.threads = 2;
  statistics.accelerator = "bvh";
  statistics.isa = "avx2";
  statistics.seconds = {0.25, 0.5, 2, 0.125, 0.0625};
  statistics.rays = {2000000, 1500000, 500000};
  statistics.dropped_samples = 3;
  statistics.scene_bytes = 3 << 20;
  statistics.peak_bytes = 50 << 20;
  return statistics;
}

TEST(StatisticsToText, ShowsPhasesRaysRateAndMemory) {
  const std::string text = StatisticsToText(Example());
  for (const char* line :
       {"30 x 20 pixels, 4 samples each, whitted, 2 threads, bvh, avx2\n",
        "load                 0.250 s\n", "build                0.500 s\n",
        "render               2.000 s\n", "encode               0.125 s\n",
        "write                0.062 s\n", "total                2.938 s\n",
        "camera             2000000\n", "reflection         1500000\n",
        "shadow              500000\n", "total              4000000\n",
        "rate                 2.000 Mrays/s\n", "scene                3.000 MiB\n",
        "peak                50.000 MiB\n", "dropped                  3\n"}) {
    EXPECT_THAT(text, testing::HasSubstr(line));
  }
}

TEST(StatisticsToText, LeavesOutAPeakThatTheSystemDoesNotTell) {
  RenderStatistics statistics = Example();
  statistics.peak_bytes = 0;
  EXPECT_THAT(StatisticsToText(statistics), testing::Not(testing::HasSubstr("peak")));
}

TEST(StatisticsToJson, HoldsTheSame) {
  const auto json = nlohmann::json::parse(StatisticsToJson(Example()));
  EXPECT_EQ(json["scene"], "arch\xEF\xBF\xBD\".txt");  // What is not UTF-8 is replaced.
  EXPECT_EQ(json["integrator"], "whitted");
  EXPECT_EQ(json["width"], 30);
  EXPECT_EQ(json["height"], 20);
  EXPECT_EQ(json["samples_per_pixel"], 4);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["accelerator"], "bvh");
  EXPECT_EQ(json["isa"], "avx2");
  EXPECT_EQ(json["seconds"]["load"], 0.25);
  EXPECT_EQ(json["seconds"]["build"], 0.5);
  EXPECT_EQ(json["seconds"]["render"], 2);
  EXPECT_EQ(json["seconds"]["encode"], 0.125);
  EXPECT_EQ(json["seconds"]["write"], 0.0625);
  EXPECT_EQ(json["seconds"]["total"], 2.9375);
  EXPECT_EQ(json["rays"]["camera"], 2000000);
  EXPECT_EQ(json["rays"]["reflection"], 1500000);
  EXPECT_EQ(json["rays"]["shadow"], 500000);
  EXPECT_EQ(json["rays"]["total"], 4000000);
  EXPECT_EQ(json["rays_per_second"], 2e6);
  EXPECT_EQ(json["dropped_samples"], 3);
  EXPECT_EQ(json["scene_bytes"], 3 << 20);
  EXPECT_EQ(json["peak_bytes"], 50 << 20);
}

// Nothing was rendered, so there is no rate, but still a number.
TEST(RenderStatistics, RateOfNoTimeIsZero) {
  EXPECT_EQ(RenderStatistics().RaysPerSecond(), 0);
}

}  // namespace
}  // namespace candela
