#include "driver/render_notes.h"

#include <fmt/format.h>

#include "driver/console.h"

namespace candela {

void PrintRenderNotes(const std::string& program, const RenderJob& job) {
  const DroppedSamples& dropped = job.Dropped();
  for (const DroppedSamples::Sample& sample : dropped.First()) {
    const Rgb c = sample.radiance;
    PrintWarning(program, fmt::format("pixel {} {}, sample {}: the light {} {} {} is not possible "
                                      "and is left out",
                                      sample.x, sample.y, sample.index, c.x, c.y, c.z));
  }
  if (dropped.Count() > dropped.First().size()) {
    PrintWarning(program, fmt::format("{} samples were left out in all", dropped.Count()));
  }
  if (job.DroppedSplats() > 0) {
    PrintWarning(program, fmt::format("{} times the light that a light path brings to a pixel is "
                                      "not possible and is left out",
                                      job.DroppedSplats()));
  }
  if (job.Rays().crowded > 0) {
    PrintWarning(program,
                 "in some places light is in more than four bodies that overlap; the others are "
                 "taken as if they were not there");
  }
  if (const double noisy = job.NoisyPart(); noisy > 0) {
    PrintWarning(program, fmt::format("{:.3g} % of the pixels are in blocks that are still noisier "
                                      "than the noise target",
                                      100 * noisy));
  }
  const ClampLoss& lost = job.Lost();
  if (lost.samples > 0) {
    PrintWarning(program, fmt::format("--clamp has taken {:.3g} % of the light, in {} samples",
                                      100 * lost.Share(), lost.samples));
  }
}

}  // namespace candela
