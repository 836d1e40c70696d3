#include "driver/common_options.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "driver/find_scene.h"

namespace candela {
namespace {

/// A side of a picture. One that is too large is no mistake of spelling but one of size, which has
/// an exit status of its own; so it is let through here, however many digits it has.
ArgValue Side(std::string label, int64_t* target) {
  const auto store = [=](std::string_view text) {
    const bool is_long =
        text.size() > 18 && text.find_first_not_of("0123456789") == std::string_view::npos;
    const auto value = is_long ? std::numeric_limits<int64_t>::max() : ParseInteger(text);
    if (!value || *value < 1) return false;
    *target = *value;
    return true;
  };
  const auto show = [=] { return std::to_string(*target); };
  return {std::move(label), DescribeRange(1, kLargestCount), store, {}, show};
}

/// The block of a scene that may set an option: the course's program keeps to its command line.
ArgTraits InBlock(const ArgParser& parser, std::string_view block) {
  if (parser.style() == ArgStyle::kCourse) return {};
  return {.block = block};
}

/// A file that is written, and the option that asks for it.
struct NamedOutput {
  std::string option;
  std::filesystem::path path;
};

std::vector<NamedOutput> Outputs(const RenderRequest& request, const ArgParser& parser) {
  std::vector<NamedOutput> outputs;
  if (request.output) outputs.push_back({parser.Spell("output"), *request.output});
  if (request.normals) outputs.push_back({parser.Spell("normals"), *request.normals});
  if (request.depth) outputs.push_back({parser.Spell("depth"), request.depth->path});
  if (request.stats_json) outputs.push_back({parser.Spell("stats-json"), *request.stats_json});
  if (request.checkpoint) outputs.push_back({parser.Spell("checkpoint"), *request.checkpoint});
  return outputs;
}

Result<void> CheckDistinct(const std::vector<NamedOutput>& outputs,
                           const std::filesystem::path& scene) {
  for (size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, path] = outputs[i];
    if (IsSameFile(path, scene)) {
      return Error{ErrorCode::kUsage, fmt::format("{}: {} is the scene, which would be overwritten",
                                                  option, Quote(path.string()))};
    }
    for (size_t j = 0; j < i; ++j) {
      if (!IsSameFile(path, outputs[j].path)) continue;
      return Error{ErrorCode::kUsage, fmt::format("{} and {} both write {}", outputs[j].option,
                                                  option, Quote(path.string()))};
    }
  }
  return {};
}

}  // namespace

CommonOptions::CommonOptions(RenderRequest* request)
    : request_(*request), width_(request->render.width), height_(request->render.height) {}

void CommonOptions::AddPictures(ArgParser* parser) {
  const bool course = parser->style() == ArgStyle::kCourse;
  parser->Option(
      "output", {File("FILE", &request_.output)},
      "colour picture; .png and .jpg hold values from 0 to 1, .exr, .hdr and .pfm hold them all",
      {.letter = course ? '\0' : 'o'});
  parser->Option("normals", {File("FILE", &request_.normals)},
                 "picture of the surface normals, in the same formats");
  parser->Option("depth",
                 {Real("MIN", &depth_.min), Real("MAX", &depth_.max), File("FILE", &depth_.path)},
                 "picture of the distances: MIN is black and MAX is white (MIN may be the larger "
                 "one); formats other than .png and .jpg hold the distances "
                 "themselves");
}

void CommonOptions::AddFrame(ArgParser* parser) {
  parser->Option("size", {Side("W", &width_), Side("H", &height_)},
                 fmt::format("pixels of the picture (default {} {})", width_, height_),
                 InBlock(*parser, "Film"));
  parser->Flag("stretch", &request_.render.stretch,
               "show the field of view of the scene in both directions, with pixels that are not "
               "square, instead of vertically",
               InBlock(*parser, "Film"));
}

void CommonOptions::AddLight(ArgParser* parser, std::string_view default_bounces) {
  parser->Option("bounces", {Whole("N", &request_.integrator_options.bounces, 0)},
                 fmt::format("reflections after the camera ray (default {})", default_bounces),
                 InBlock(*parser, "Render"));
  // The course's program knows no other integrator.
  const bool course = parser->style() == ArgStyle::kCourse;
  parser->Flag("shadows", &request_.integrator_options.shadows,
               course ? "let objects block lights" : "with whitted: let objects block lights",
               InBlock(*parser, "Render"));
}

Result<void> CommonOptions::Finish(const ArgParser& parser) {
  if (const auto done = FinishSize(parser); !done) return done;
  if (const auto done = FinishDepth(parser); !done) return done;
  const bool has_picture = request_.output || request_.normals || request_.depth;
  if (!has_picture && !request_.explain) {
    return Error{ErrorCode::kUsage,
                 fmt::format("nothing to do: give {0}, {1} or {2}", parser.Spell("output FILE"),
                             parser.Spell("normals FILE"), parser.Spell("depth MIN MAX FILE"))};
  }
  return {};
}

Result<void> CommonOptions::FinishFiles(const ArgParser& parser) {
  const auto scene = FindScene(request_.scene, SceneFolders());
  if (!scene) return scene.error();
  request_.scene = *scene;
  return CheckDistinct(Outputs(request_, parser), request_.scene);
}

Result<void> CommonOptions::FinishSize(const ArgParser& parser) {
  if (width_ > kLargestCount || height_ > kLargestCount) {
    return Error{ErrorCode::kResources, fmt::format("{}: a side can have at most {} pixels",
                                                    parser.Spell("size"), kLargestCount)};
  }
  request_.render.width = static_cast<int>(width_);
  request_.render.height = static_cast<int>(height_);
  request_.render.crop = {0, 0, request_.render.width, request_.render.height};
  return {};
}

Result<void> CommonOptions::FinishDepth(const ArgParser& parser) {
  if (!parser.Has("depth")) return {};
  if (depth_.min == depth_.max) {
    return Error{ErrorCode::kUsage, parser.Spell("depth") + ": MIN and MAX have to differ"};
  }
  request_.depth = depth_;
  return {};
}

}  // namespace candela
