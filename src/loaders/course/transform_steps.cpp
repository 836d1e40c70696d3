#include "loaders/course/transform_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

#include "base/number.h"
#include "base/text.h"
#include "scene_spec/param_messages.h"

namespace candela {
namespace {

struct Step {
  std::string_view name;
  size_t count;  ///< Of its numbers.
  const char* expected;
  Mat4 (*matrix)(const double* numbers);
};

Vec3d VectorOf(const double* v) {
  return {v[0], v[1], v[2]};
}

/// Three rows of four numbers; the fourth row is that of all affine transforms.
Mat4 MatrixOf(const double* v) {
  Mat4 m = Mat4::Identity();
  for (size_t i = 0; i < 12; ++i) m.m[i / 4][i % 4] = v[i];
  return m;
}

constexpr const char* kThree = "three numbers";
constexpr const char* kAngle = "an angle in degrees";

constexpr Step kSteps[] = {
    {"translate", 3, kThree, [](const double* v) { return Mat4::Translate(VectorOf(v)); }},
    {"scale", 3, kThree, [](const double* v) { return Mat4::Scale(VectorOf(v)); }},
    {"x_rotate", 1, kAngle, [](const double* v) { return Mat4::Rotate(0, v[0]); }},
    {"y_rotate", 1, kAngle, [](const double* v) { return Mat4::Rotate(1, v[0]); }},
    {"z_rotate", 1, kAngle, [](const double* v) { return Mat4::Rotate(2, v[0]); }},
    {"matrix", 12, "three rows of four numbers", MatrixOf},
};

constexpr auto kNames = [] {
  std::array<std::string_view, std::size(kSteps)> names;
  std::transform(std::begin(kSteps), std::end(kSteps), names.begin(),
                 [](const Step& step) { return step.name; });
  return names;
}();

const Step* FindStep(std::string_view name) {
  const Step* found = std::find_if(std::begin(kSteps), std::end(kSteps),
                                   [&](const Step& step) { return step.name == name; });
  return found == std::end(kSteps) ? nullptr : found;
}

void ReportUnknown(const Param& param, Diagnostics* diagnostics) {
  diagnostics->Error(param.where, [&] {
    return fmt::format("{} is due, found {}{}", ListOf(kNames), Quote(param.name),
                       DidYouMean(param.name, kNames));
  });
}

bool HaveSameSteps(const TransformSteps& a, const TransformSteps& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const TransformStep& x, const TransformStep& y) { return x.kind == y.kind; });
}

}  // namespace

TransformSteps ReadSteps(const ParamSet& steps, Diagnostics* diagnostics) {
  TransformSteps read;
  const std::vector<Param>& params = steps.params;
  for (size_t i = 0; i < params.size(); ++i) {
    const Param& param = params[i];
    const Step* step = FindStep(param.name);
    if (!step) {
      ReportUnknown(param, diagnostics);
      continue;
    }
    std::array<double, TransformStep::kMostNumbers> numbers{};
    size_t count = 0;
    for (; count < std::min(step->count, param.words.size()); ++count) {
      const auto number = ParseDouble(param.words[count].text);
      if (!number) break;
      numbers[count] = *number;
    }
    if (count < param.words.size()) {
      const ParamWord& word = param.words[count];
      diagnostics->Error(
          word.where,
          count == step->count
              ? WrongCount(step->name, step->expected, param.words.size())
              : WrongWord(step->name, step->expected, word.text, IsTooLarge(word.text)));
    } else if (count == step->count) {
      read.push_back({static_cast<size_t>(step - kSteps), numbers});
    } else if (i + 1 == params.size() && steps.is_damaged) {
      // The rest of it may be what could not be read.
    } else if (const Param* word = WordBetweenNumbers(steps, i, kNames)) {
      ++i;
      diagnostics->Error(word->where, WrongWord(step->name, step->expected, word->name));
    } else {
      diagnostics->Error(param.where, WrongCount(step->name, step->expected, count));
    }
  }
  return read;
}

Mat4 Product(const TransformSteps& steps) {
  // A matrix alone stays as it is, to the sign of its zeros.
  if (steps.size() == 1 && kSteps[steps[0].kind].matrix == MatrixOf) {
    return MatrixOf(steps[0].numbers.data());
  }
  Mat4 product = Mat4::Identity();
  for (const TransformStep& step : steps) {
    product = product * kSteps[step.kind].matrix(step.numbers.data());
  }
  return product;
}

size_t PartsOfKeyframes(std::span<const TransformSteps> frames) {
  double parts = 1;
  for (size_t i = 1; i < frames.size(); ++i) {
    const TransformSteps &before = frames[i - 1], &after = frames[i];
    if (!HaveSameSteps(before, after)) return 1;
    for (size_t k = 0; k < after.size(); ++k) {
      if (kSteps[after[k].kind].expected != kAngle) continue;
      const double turn = std::abs(after[k].numbers[0] - before[k].numbers[0]);
      parts = std::max(parts, std::ceil(turn / kDegreesOfPart));
    }
  }
  constexpr double kTooMany = 1 << 30;
  return std::bit_ceil(static_cast<size_t>(std::min(parts, kTooMany)));
}

std::vector<Mat4> MatricesOfKeyframes(std::span<const TransformSteps> frames, size_t parts) {
  std::vector<Mat4> matrices = {Product(frames[0])};
  for (size_t i = 1; i < frames.size(); ++i) {
    for (size_t part = 1; part < parts; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      TransformSteps between = frames[i];
      for (size_t k = 0; k < between.size(); ++k) {
        for (size_t n = 0; n < TransformStep::kMostNumbers; ++n) {
          double& number = between[k].numbers[n];
          number = frames[i - 1][k].numbers[n] * (1 - share) + number * share;
        }
      }
      matrices.push_back(Product(between));
    }
    matrices.push_back(Product(frames[i]));
  }
  return matrices;
}

}  // namespace candela
