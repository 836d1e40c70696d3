#include "image/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "image/channels.h"

namespace candela {
namespace {

/// The weights of the old pixels that one new pixel covers; they add up to 1.
struct Coverage {
  int first;
  std::vector<double> weights;
};

/// One direction at a time: the box is the product of a horizontal and a vertical one.
std::vector<Coverage> CoverageOf(int old_size, int new_size) {
  std::vector<Coverage> result;
  for (int64_t i = 0; i < new_size; ++i) {
    // In units of 1 / new_size of an old pixel all borders are whole numbers.
    const int64_t begin = i * old_size, end = begin + old_size;
    Coverage coverage{static_cast<int>(begin / new_size), {}};
    for (int64_t pixel = coverage.first; pixel * new_size < end; ++pixel) {
      const int64_t overlap =
          std::min(end, (pixel + 1) * new_size) - std::max(begin, pixel * new_size);
      coverage.weights.push_back(static_cast<double>(overlap) / old_size);
    }
    result.push_back(std::move(coverage));
  }
  return result;
}

/// The size with the same shape that fits the cell.
std::pair<int, int> FittedSize(const Image& image, const SheetLayout& layout) {
  const double scale = std::min({1.0, static_cast<double>(layout.cell_width) / image.Width(),
                                 static_cast<double>(layout.cell_height) / image.Height()});
  const auto side = [&](int old) {
    return std::max(1, static_cast<int>(std::floor(old * scale + 0.5)));
  };
  return {side(image.Width()), side(image.Height())};
}

}  // namespace

Image ShrinkImage(const Image& image, int width, int height) {
  CHECK(width >= 1 && height >= 1 && width <= image.Width() && height <= image.Height());
  const std::vector<Coverage> columns = CoverageOf(image.Width(), width);
  const std::vector<Coverage> rows = CoverageOf(image.Height(), height);
  Image result(width, height, image.Channels());
  std::vector<double> sum(image.RowSize());
  for (int y = 0; y < height; ++y) {
    const Coverage& row = rows[static_cast<size_t>(y)];
    std::fill(sum.begin(), sum.end(), 0.0);
    for (size_t j = 0; j < row.weights.size(); ++j) {
      const std::span<const float> from = image.Row(row.first + static_cast<int>(j));
      for (size_t i = 0; i < sum.size(); ++i) sum[i] += row.weights[j] * double{from[i]};
    }
    for (int x = 0; x < width; ++x) {
      const Coverage& column = columns[static_cast<size_t>(x)];
      for (int c = 0; c < image.Channels(); ++c) {
        double value = 0;
        for (size_t i = 0; i < column.weights.size(); ++i) {
          const size_t pixel = static_cast<size_t>(column.first) + i;
          value += column.weights[i] *
                   sum[pixel * static_cast<size_t>(image.Channels()) + static_cast<size_t>(c)];
        }
        result.At(x, y, c) = static_cast<float>(value);
      }
    }
  }
  return result;
}

Image MakeContactSheet(std::span<const Image> images, const SheetLayout& layout) {
  CHECK(!images.empty() && layout.columns >= 1 && layout.margin >= 0);
  CHECK(layout.cell_width >= 1 && layout.cell_height >= 1);
  const int columns = std::min(layout.columns, static_cast<int>(images.size()));
  const int rows = (static_cast<int>(images.size()) + columns - 1) / columns;
  const int pitch_x = layout.cell_width + layout.margin;
  const int pitch_y = layout.cell_height + layout.margin;
  Image sheet(columns * pitch_x + layout.margin, rows * pitch_y + layout.margin, 3);
  for (int y = 0; y < sheet.Height(); ++y) {
    for (int x = 0; x < sheet.Width(); ++x) {
      for (int c = 0; c < 3; ++c) sheet.At(x, y, c) = layout.background[c];
    }
  }

  for (size_t i = 0; i < images.size(); ++i) {
    CHECK(!images[i].IsEmpty());
    const auto [width, height] = FittedSize(images[i], layout);
    const Image small = ShrinkImage(WithChannels(images[i], 3), width, height);
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    const int left = layout.margin + column * pitch_x + (layout.cell_width - small.Width()) / 2;
    const int top = layout.margin + row * pitch_y + (layout.cell_height - small.Height()) / 2;
    for (int y = 0; y < small.Height(); ++y) {
      std::copy(small.Row(y).begin(), small.Row(y).end(), sheet.Pixel(left, top + y).data());
    }
  }
  return sheet;
}

}  // namespace candela
