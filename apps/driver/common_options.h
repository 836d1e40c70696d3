#pragma once

#include <cstdint>
#include <string_view>

#include "base/result.h"
#include "driver/arg_parser.h"
#include "driver/render_request.h"

namespace candela {

/// The options that both programs have, and what has to hold for all of a request. Lives as long as
/// the parser that it adds options to.
class CommonOptions {
 public:
  explicit CommonOptions(RenderRequest* request);

  /// output, normals, depth
  void AddPictures(ArgParser* parser);
  /// size, stretch
  void AddFrame(ArgParser* parser);
  /// bounces, shadows
  void AddLight(ArgParser* parser, std::string_view default_bounces);

  /// Completes the request after a command line was read: size, window (the whole picture), depth.
  /// Checks that there is something to do.
  Result<void> Finish(const ArgParser& parser);
  /// The size and the window alone, when the size has changed since.
  Result<void> FinishSize(const ArgParser& parser);
  /// Finds the scene. Checks that no file is written twice or is the scene. Comes last, so that a
  /// wrong command line shows as one wherever it is used.
  Result<void> FinishFiles(const ArgParser& parser);

 private:
  Result<void> FinishDepth(const ArgParser& parser);

  RenderRequest& request_;
  int64_t width_, height_;
  DepthOutput depth_;
};

}  // namespace candela
