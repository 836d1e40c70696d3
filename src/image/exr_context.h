#pragma once

#include <openexr.h>

#include <string>

#include "base/result.h"

namespace candela {

/// Owns one file that OpenEXRCore has open. That library is C, throws nothing, and loads in a tenth
/// of the time of the C++ one, which every start of a program would pay.
struct ExrContext {
  exr_context_t handle = nullptr;

  ExrContext() = default;
  ~ExrContext() { exr_finish(&handle); }
  ExrContext(const ExrContext&) = delete;
  ExrContext& operator=(const ExrContext&) = delete;
};

/// The library prints errors unless somebody takes them; its result codes say enough.
inline void IgnoreExrMessage(exr_const_context_t, exr_result_t, const char*) {}

/// The library's words for a result code. They hold nothing from the file.
inline std::string ExrMessage(exr_result_t code) {
  return exr_get_default_error_message(code);
}

}  // namespace candela
