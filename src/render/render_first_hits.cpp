#include "render/render_first_hits.h"

#include "base/parallel.h"
#include "render/pixel_order.h"
#include "render/sample_placer.h"
#include "render/tiles.h"

namespace candela {

std::vector<FirstHit> RenderFirstHits(const Scene& scene, const RenderOptions& options) {
  const SamplePlacer placer(options);
  const PixelWindow& crop = options.crop;
  std::vector<FirstHit> map(crop.PixelCount());
  const Tiles tiles(crop, static_cast<int>(options.tile_size));
  ParallelFor(tiles.Count(), [&](int64_t tile) {
    const PixelWindow window = tiles.Window(tile);
    std::vector<Vec2> image_points;
    image_points.reserve(window.PixelCount());
    ForEachPixel(window, [&](int x, int y) {
      image_points.push_back(placer.Centre(x, y).image_point);
      return true;
    });
    std::vector<FirstHit> hits(image_points.size());
    FindFirstHits(scene, image_points, hits);
    auto hit = hits.begin();
    ForEachPixel(window, [&](int x, int y) {
      const auto row = static_cast<size_t>(y - crop.y0), column = static_cast<size_t>(x - crop.x0);
      map[row * static_cast<size_t>(crop.Width()) + column] = *hit++;
      return true;
    });
  });
  return map;
}

}  // namespace candela
