#include "render/render_first_hits.h"

#include "base/parallel.h"
#include "render/sample_placer.h"
#include "render/tiles.h"

namespace candela {

std::vector<FirstHit> RenderFirstHits(const Scene& scene, const RenderOptions& options) {
  const SamplePlacer placer(options);
  const PixelWindow& crop = options.crop;
  std::vector<FirstHit> hits(PixelCount(crop));
  ParallelFor(crop.Height(), [&](int64_t row) {
    const int y = crop.y0 + static_cast<int>(row);
    FirstHit* out = &hits[static_cast<size_t>(row) * static_cast<size_t>(crop.Width())];
    for (int x = crop.x0; x < crop.x1; ++x) {
      *out++ = FindFirstHit(scene, placer.Centre(x, y).image_point);
    }
  });
  return hits;
}

}  // namespace candela
