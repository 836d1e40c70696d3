#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/diagnostics.h"
#include "base/files.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "driver/map_images.h"
#include "driver/render_request.h"
#include "image/image_file.h"
#include "loaders/course/scene_parser.h"
#include "render/render_first_hits.h"
#include "render/render_job.h"
#include "render/sample_placer.h"
#include "render/tiles.h"
#include "scene/compile_scene.h"

namespace candela {
namespace {

void PrintError(const std::string& text) {
  fmt::print(stderr, "error: {}\n", text);
}

int ExitCode(const Error& error) {
  return static_cast<int>(error.code);
}

/// One run of a program that renders. Each step returns an error that ends it.
class RenderRun {
 public:
  explicit RenderRun(const RenderRequest& request) : request_(request) {}

  int Run() {
    const Result<void> done = Steps();
    if (done) return 0;
    if (!done.error().message.empty()) PrintError(done.error().message);
    return ExitCode(done.error());
  }

 private:
  Result<void> Steps() {
    if (auto checked = CheckOutputs(); !checked) return checked;
    if (auto loaded = LoadScene(); !loaded) return loaded;
    if (auto fits = CheckMemory(); !fits) return fits;
    auto integrator = CreateIntegrator(request_.integrator, *scene_, request_.integrator_options);
    if (!integrator) return integrator.error();
    if (request_.explain) return Explain(**integrator);
    if (request_.output) {
      if (auto written = RenderImage(**integrator); !written) return written;
    }
    return WriteMaps();
  }

  std::vector<std::filesystem::path> OutputPaths() const {
    std::vector<std::filesystem::path> paths;
    if (request_.output) paths.push_back(*request_.output);
    if (request_.normals) paths.push_back(*request_.normals);
    if (request_.depth) paths.push_back(request_.depth->path);
    return paths;
  }

  Result<void> CheckOutputs() {
    for (const auto& path : OutputPaths()) {
      if (!FormatOf(path)) {
        return Error{
            ErrorCode::kUsage,
            fmt::format("'{}': the name has to end in .png, .exr, .hdr or .pfm", path.string())};
      }
      if (auto writable = CheckWritable(path); !writable) {
        return Error{ErrorCode::kOutput,
                     fmt::format("'{}': {}", path.string(), writable.error().message)};
      }
    }
    return {};
  }

  Result<void> LoadScene() {
    Diagnostics diagnostics;
    const SceneSpec spec = candela::LoadScene(request_.scene, &diagnostics);
    if (!diagnostics.HasErrors()) scene_ = CompileScene(spec, &diagnostics);
    for (const std::string& line : diagnostics.Lines()) fmt::print(stderr, "{}\n", line);
    if (!scene_) return Error{ErrorCode::kInput, {}};
    return {};
  }

  Result<void> CheckMemory() {
    const uint64_t need = EstimateMemory(request_.render, request_.normals || request_.depth);
    const uint64_t available = AvailableMemory();
    if (need <= available) return {};
    return Error{
        ErrorCode::kResources,
        fmt::format(
            "a picture of {} x {} pixels needs about {:.1f} GiB of memory, {:.1f} GiB are free",
            request_.render.crop.Width(), request_.render.crop.Height(),
            static_cast<double>(need) / (1 << 30), static_cast<double>(available) / (1 << 30))};
  }

  Result<void> Explain(const Integrator& integrator) {
    const auto lines = integrator.Explain(
        SamplePlacer(request_.render).Centre(request_.explain->x, request_.explain->y));
    if (lines.empty()) {
      return Error{ErrorCode::kUsage,
                   fmt::format("the integrator '{}' cannot explain a pixel", request_.integrator)};
    }
    for (const std::string& line : lines) fmt::print("{}\n", line);
    return {};
  }

  Result<void> RenderImage(const Integrator& integrator) {
    RenderJob job(integrator, request_.render);
    const CancelToken never;
    if (auto done = job.Run(never); !done) return done;
    return Write(*request_.output, ToImage(job.film()));
  }

  static Image ToImage(const Film& film) {
    const PixelWindow& window = film.Window();
    Image image(window.Width(), window.Height(), 3);
    for (int y = 0; y < window.Height(); ++y) {
      std::ranges::copy(film.Row(window.y0 + y), image.Row(y).begin());
    }
    return image;
  }

  Result<void> WriteMaps() {
    if (!request_.normals && !request_.depth) return {};
    const PixelWindow& crop = request_.render.crop;
    const std::vector<FirstHit> hits = RenderFirstHits(*scene_, request_.render);
    if (request_.normals) {
      const Image image = NormalImage(hits, crop, *FormatOf(*request_.normals));
      if (auto written = Write(*request_.normals, image); !written) return written;
    }
    if (request_.depth) {
      const Image image = DepthImage(hits, crop, *request_.depth, *FormatOf(request_.depth->path));
      if (auto written = Write(request_.depth->path, image); !written) return written;
    }
    return {};
  }

  Result<void> Write(const std::filesystem::path& path, const Image& image) {
    EncodeOptions options;
    options.png_bits = request_.output_options.png_bits;
    const Result<std::string> bytes = EncodeImage(image, *FormatOf(path), options);
    if (!bytes) return bytes.error();
    auto written = WriteFileAtomically(path, std::as_bytes(std::span(*bytes)));
    if (written) return written;
    return Error{ErrorCode::kOutput,
                 fmt::format("'{}': {}", path.string(), written.error().message)};
  }

  const RenderRequest& request_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace

int RunRender(const RenderRequest& request) {
  const ThreadLimit threads(request.threads);
  return RenderRun(request).Run();
}

}  // namespace candela
