#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/files.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/signals.h"
#include "base/text.h"
#include "driver/checkpoint_file.h"
#include "driver/console.h"
#include "driver/load_scene.h"
#include "driver/map_images.h"
#include "driver/picture_facts.h"
#include "driver/picture_files.h"
#include "driver/progress_reporter.h"
#include "driver/render_notes.h"
#include "driver/render_report.h"
#include "driver/render_request.h"
#include "film/encode_film.h"
#include "image/image_file.h"
#include "image/jpeg.h"
#include "render/render_first_hits.h"
#include "render/render_job.h"
#include "render/sample_placer.h"
#include "scene/input_files.h"

namespace candela {
namespace {

constexpr double kCheckpointSeconds = 300;

/// Adds the time that a step takes to the seconds of its phase.
template <class Step>
auto Timed(double* seconds, Step step) {
  const Stopwatch clock;
  auto result = step();
  *seconds += clock.Seconds();
  return result;
}

/// One run of a program that renders. Each step returns an error that ends it.
class RenderRun {
 public:
  RenderRun(const RenderRequest& request, const SettingsReader& read_settings)
      : request_(request), read_settings_(read_settings) {}

  Result<void> Run() {
    if (auto checked = CheckOutputs(); !checked) return checked;
    if (auto loaded = LoadScene(); !loaded) return loaded;
    auto integrator =
        FindIntegrator(request_.integrator)->create(*loaded_->scene, request_.integrator_options);
    if (!integrator) return integrator.error();
    if (auto fits = CheckMemory(**integrator); !fits) return fits;
    if (request_.explain) return Explain(**integrator);
    WarnOfUnseenLights();
    if (request_.output) {
      if (auto written = RenderImage(**integrator); !written) return written;
    }
    if (auto written = WriteMaps(); !written) return written;
    return Report();
  }

 private:
  std::vector<std::filesystem::path> Outputs() const {
    std::vector<std::filesystem::path> paths = request_.Pictures();
    if (request_.stats_json) paths.push_back(*request_.stats_json);
    if (request_.checkpoint) paths.push_back(*request_.checkpoint);
    return paths;
  }

  Result<void> CheckOutputs() const {
    for (const auto& path : request_.Pictures()) {
      if (auto checked = CheckPictureOutput(path); !checked) return checked;
    }
    for (const auto& path : {request_.stats_json, request_.checkpoint}) {
      if (!path) continue;
      if (auto checked = CheckOutput(*path); !checked) return checked;
    }
    return {};
  }

  Result<void> LoadScene() {
    const auto check = [this](const Scene& scene, Diagnostics* diagnostics) {
      CheckForIntegrator(request_.integrator, scene, diagnostics);
    };
    const auto read_settings = [this](const SceneSpec& spec,
                                      Diagnostics* diagnostics) -> Result<CompileOptions> {
      const Result<CompileOptions> options = read_settings_(spec, diagnostics);
      if (!options) return options;
      const Result<void> fits = CheckJpegSize();
      return fits ? options : fits.error();
    };
    auto loaded = LoadSceneForUser(request_.scene, read_settings, check);
    if (!loaded) return loaded.error();
    loaded_ = *std::move(loaded);
    statistics_.seconds.load = loaded_->load_seconds;
    statistics_.seconds.build = loaded_->build_seconds;
    for (const auto& input : InputFiles(loaded_->spec)) {
      for (const auto& output : Outputs()) {
        if (!IsSameFile(input, output)) continue;
        return Error{ErrorCode::kUsage,
                     fmt::format("{} is a part of the scene, which would be overwritten",
                                 Quote(output.string()))};
      }
    }
    return {};
  }

  /// The course's model has no light from surfaces; a picture that stays dark because of that
  /// should not puzzle anyone.
  void WarnOfUnseenLights() const {
    if (request_.integrator != "whitted") return;
    // What is gathered is light of all of them.
    if (request_.integrator_options.indirect_samples.value_or(0) > 0) return;
    for (const auto& light : loaded_->scene->lights()) {
      if (!light->IsSurface()) continue;
      const bool is_sampled = request_.integrator_options.light_samples.value_or(0) > 0;
      if (is_sampled && !light->IsFoundByHitsAlone()) continue;
      PrintWarning(request_.program,
                   is_sampled
                       ? "area lights of this shape shine but light nothing in 'whitted'; "
                         "'--integrator path' follows their light"
                       : "area lights shine but light nothing in 'whitted'; 'candela render "
                         "--light-samples N' samples them, and '--integrator path' follows their "
                         "light");
      return;
    }
  }

  /// Comes after the settings of the scene, which may say the size.
  Result<void> CheckJpegSize() const {
    const PixelWindow& crop = request_.render.crop;
    if (std::max(crop.Width(), crop.Height()) <= kMostJpegSide) return {};
    for (const auto& path : request_.Pictures()) {
      if (FormatOf(path) != ImageFormat::kJpeg) continue;
      return Error{ErrorCode::kUsage,
                   fmt::format("{}: a side of a JPEG picture has at most {} pixels",
                               Quote(path.string()), kMostJpegSide)};
    }
    return {};
  }

  /// With what the scene alone knows.
  RenderOptions OptionsForScene() const {
    RenderOptions options = request_.render;
    if (options.layers.Has(Layer::kLightGroups)) {
      options.light_groups = loaded_->scene->light_groups();
    }
    return options;
  }

  Result<void> CheckMemory(const Integrator& integrator) const {
    // Where the picture alone is too much the rest does not matter.
    const uint64_t picture =
        EstimateMemory(OptionsForScene(), integrator, request_.normals || request_.depth,
                       request_.checkpoint.has_value());
    const uint64_t lens =
        request_.output_options.lens.BytesPerPixel() * request_.render.crop.PixelCount();
    const uint64_t need = picture + std::min(lens, std::numeric_limits<uint64_t>::max() - picture);
    const uint64_t available = AvailableMemory();
    if (need <= available) return {};
    const double gibibyte = 1 << 30;
    return Error{
        ErrorCode::kResources,
        fmt::format("a picture of {} x {} pixels needs about {:.1f} GiB of memory, {:.1f} GiB are "
                    "free",
                    request_.render.crop.Width(), request_.render.crop.Height(),
                    static_cast<double>(need) / gibibyte,
                    static_cast<double>(available) / gibibyte)};
  }

  Result<void> Explain(const Integrator& integrator) const {
    const auto lines = integrator.Explain(
        SamplePlacer(request_.render).Centre(request_.explain->x, request_.explain->y));
    if (lines.empty()) {
      return Error{
          ErrorCode::kUsage,
          fmt::format("the integrator '{}' cannot explain a pixel{}", request_.integrator,
                      request_.integrator == "whitted" ? " where it takes several rays" : "")};
    }
    return WriteResult(fmt::format("{}\n", fmt::join(lines, "\n")));
  }

  Result<void> RenderImage(const Integrator& integrator) {
    const RenderOptions render = OptionsForScene();
    const bool keeps_sums = request_.checkpoint || (render.time_limit && !render.noise_target);
    RenderJob job(integrator, render, keeps_sums ? Film::Keep::kSums : Film::Keep::kColours);
    EncodeOptions encoding = Encoding();
    encoding.tone = request_.output_options.tone;
    const ImageFormat format = *FormatOf(*request_.output);
    const bool has_facts = format == ImageFormat::kExr && request_.output_options.has_facts;
    std::string hash;
    if (has_facts || request_.checkpoint) {
      Result<std::string> hashed = HashScene(loaded_->spec);
      if (!hashed) return hashed.error();
      hash = *std::move(hashed);
    }
    if (has_facts) encoding.attributes = PictureAttributes(request_, hash);
    FilmEncoder encoder(
        job.film(), format, encoding,
        request_.output_options.lens.Finishing(loaded_->scene->camera(), request_.render));
    std::optional<CheckpointFile> checkpoint;
    if (request_.checkpoint) {
      checkpoint.emplace(*request_.checkpoint, OwnerOfCheckpoint(request_, hash),
                         request_.checkpoint_seconds.value_or(kCheckpointSeconds), &job);
      if (auto loaded = checkpoint->Load(); !loaded) return loaded;
    }
    Result<void> saved;
    auto done = Timed(&statistics_.seconds.render, [&] {
      return checkpoint ? RunStoppable(&job, &encoder, &*checkpoint, &saved) : Run(&job, &encoder);
    });
    if (!done) return done;
    statistics_.rays += job.Rays();
    statistics_.samples_per_pixel =
        static_cast<double>(job.SamplesInFilm()) / static_cast<double>(render.crop.PixelCount());
    statistics_.dropped_samples = job.Dropped().Count() + job.DroppedSplats();
    PrintRenderNotes(request_.program, job);
    // The picture is not lost because the checkpoint cannot be written.
    auto written = Write(*request_.output, [&](ImageFormat) { return encoder.Finish(); });
    return written ? saved : written;
  }

  Result<void> Run(RenderJob* job, FilmEncoder* encoder) const {
    const ProgressReporter progress(*job, request_.quiet);
    return job->Run(CancelToken(), encoder);
  }

  /// Keeps the samples at the end, also when it is stopped; `saved` tells whether it could.
  Result<void> RunStoppable(RenderJob* job, FilmEncoder* encoder, CheckpointFile* file,
                            Result<void>* saved) const {
    CancelToken stop;
    const CancelOnStopSignals on_signals(&stop);
    const auto run = [&] {
      const ProgressReporter progress(*job, request_.quiet);
      return job->Run(stop, encoder, [&] { return file->SaveWhenDue(); });
    };
    Result<void> done = run();
    const bool is_stopped = !done && done.error().code == ErrorCode::kStopped;
    if (!done && !is_stopped) return done;
    *saved = file->Save();
    if (!is_stopped) return done;
    if (!*saved) return *saved;
    PrintWarning(request_.program,
                 fmt::format("stopped; {} of {} samples are kept in {}, and the same command line "
                             "goes on from there",
                             job->SamplesInFilm(), job->SamplesTotal(),
                             Quote(request_.checkpoint->string())));
    return Error{ErrorCode::kStopped, {}};
  }

  Result<void> WriteMaps() {
    if (!request_.normals && !request_.depth) return {};
    const PixelWindow& crop = request_.render.crop;
    const auto hits = Timed(&statistics_.seconds.render,
                            [&] { return RenderFirstHits(*loaded_->scene, request_.render); });
    statistics_.rays.camera += hits.size();
    if (request_.normals) {
      const auto encode = [&](ImageFormat format) {
        return EncodeImage(NormalImage(hits, crop, format), format, Encoding());
      };
      if (auto written = Write(*request_.normals, encode); !written) return written;
    }
    if (request_.depth) {
      const auto encode = [&](ImageFormat format) {
        return EncodeImage(DepthImage(hits, crop, *request_.depth, format), format, Encoding());
      };
      if (auto written = Write(request_.depth->path, encode); !written) return written;
    }
    return {};
  }

  EncodeOptions Encoding() const {
    EncodeOptions options;
    options.png_bits = request_.output_options.png_bits;
    return options;
  }

  /// `encode` gives the bytes of the file for its format.
  template <class Encode>
  Result<void> Write(const std::filesystem::path& path, Encode encode) {
    const Result<std::string> bytes =
        Timed(&statistics_.seconds.encode, [&] { return encode(*FormatOf(path)); });
    if (!bytes) return WithPath(path, bytes.error());
    return Timed(&statistics_.seconds.write, [&] { return WriteOutput(path, *bytes); });
  }

  Result<void> Report() {
    if (!request_.print_stats && !request_.stats_json) return {};
    statistics_.scene = request_.scene.string();
    statistics_.integrator = request_.integrator;
    statistics_.width = request_.render.crop.Width();
    statistics_.height = request_.render.crop.Height();
    if (!request_.output) statistics_.samples_per_pixel = request_.render.samples;
    statistics_.threads = ThreadCount();
    statistics_.accelerator = AcceleratorName(loaded_->scene->tree().group->accelerator());
    statistics_.isa = IsaName(loaded_->scene->tree().group->isa());
    statistics_.scene_bytes = loaded_->scene->MemoryBytes();
    statistics_.peak_bytes = PeakMemory();
    if (request_.print_stats) fmt::print(stderr, "{}", StatisticsToText(statistics_));
    if (!request_.stats_json) return {};
    return WriteOutput(*request_.stats_json, StatisticsToJson(statistics_));
  }

  const RenderRequest& request_;
  const SettingsReader& read_settings_;
  std::optional<LoadedScene> loaded_;
  RenderStatistics statistics_;
};

}  // namespace

int RunRender(const RenderRequest& request, const SettingsReader& read_settings) {
  const ThreadLimit threads(request.threads);
  if (request.isa) ForceIsa(*request.isa);
  const Result<void> done = RenderRun(request, read_settings).Run();
  if (done) return 0;
  // Without a message everything has been said.
  if (done.error().message.empty()) return static_cast<int>(done.error().code);
  return PrintError(request.program, done.error());
}

}  // namespace candela
