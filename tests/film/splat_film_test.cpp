#include "film/splat_film.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <vector>

namespace candela {
namespace {

TEST(SplatFilm, GivesTheSumOverThePaths) {
  SplatFilm film({2, 3, 6, 5});
  film.Add(2, 3, {1, 2, 3});
  film.Add(2, 3, {0.5f, 0, 1});
  film.Add(5, 4, {8, 8, 8});
  EXPECT_EQ(film.Mean(2, 3, 4), (Rgb{0.375f, 0.5f, 1}));
  EXPECT_EQ(film.Mean(5, 4, 2), (Rgb{4, 4, 4}));
  EXPECT_EQ(film.Mean(3, 3, 4), (Rgb{0, 0, 0}));
}

TEST(SplatFilm, DropsAndCountsWhatIsNotFinite) {
  SplatFilm film({0, 0, 1, 1});
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  film.Add(0, 0, {1, kInfinity, 1});
  film.Add(0, 0, {1, 1, std::numeric_limits<float>::quiet_NaN()});
  film.Add(0, 0, {1, 1, 1});
  EXPECT_EQ(film.Mean(0, 0, 1), (Rgb{1, 1, 1}));
  EXPECT_EQ(film.DroppedSplats(), 2u);
}

// Numbers of sizes that floats could not add in any order.
TEST(SplatFilm, IsTheSameForAnyThreadsAndOrder) {
  constexpr int kCount = 20000;
  const auto add = [](SplatFilm* film, int i) {
    const float value = static_cast<float>(i % 7919) * (i % 3 == 0 ? 1e6f : 1e-3f);
    film->Add(i % 5, i % 3, {value, -value, 1 / (value + 1)});
  };
  SplatFilm alone({0, 0, 5, 3});
  for (int i = 0; i < kCount; ++i) add(&alone, i);
  SplatFilm together({0, 0, 5, 3});
  std::vector<std::thread> threads;
  for (int part = 0; part < 4; ++part) {
    threads.emplace_back([&, part] {
      for (int i = kCount - 1 - part; i >= 0; i -= 4) add(&together, i);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(together.Mean(x, y, 1), alone.Mean(x, y, 1));
  }
}

}  // namespace
}  // namespace candela
