#include "loaders/course/transform_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

constexpr size_t kMostNumbers = 12;

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

}  // namespace

Mat4 ComposeSteps(const ParamSet& steps, Diagnostics* diagnostics) {
  Mat4 product = Mat4::Identity();
  const std::vector<Param>& params = steps.params;
  for (size_t i = 0; i < params.size(); ++i) {
    const Param& param = params[i];
    const Step* step = FindStep(param.name);
    if (!step) {
      ReportUnknown(param, diagnostics);
      continue;
    }
    std::array<double, kMostNumbers> numbers{};
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
      // Each further step acts on the object before the ones written so far. A matrix alone stays
      // as it is, to the sign of its zeros.
      const Mat4 matrix = step->matrix(numbers.data());
      product = params.size() == 1 && step->count == kMostNumbers ? matrix : product * matrix;
    } else if (i + 1 == params.size() && steps.is_damaged) {
      // The rest of it may be what could not be read.
    } else if (const Param* word = WordBetweenNumbers(steps, i, kNames)) {
      ++i;
      diagnostics->Error(word->where, WrongWord(step->name, step->expected, word->name));
    } else {
      diagnostics->Error(param.where, WrongCount(step->name, step->expected, count));
    }
  }
  return product;
}

}  // namespace candela
