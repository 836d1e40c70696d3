#pragma once

#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/source_location.h"

namespace candela {

enum class Severity { kError, kWarning };

/// One thing that is wrong (or odd) in the input.
struct Diagnostic {
  Severity severity;
  SourceLocation where;
  std::string text;
};

/// Collects what is wrong in the input, so that one run shows all of it. Of each file the first 20
/// errors and 20 warnings are kept in order of arrival; further ones are only counted.
/// Not safe for concurrent use: give each task its own and `Append` them in a fixed order.
class Diagnostics {
 public:
  static constexpr size_t kMostPerFile = 20;

  void Error(SourceLocation where, std::string text, ErrorCode code = ErrorCode::kInput);
  void Warning(SourceLocation where, std::string text);
  void Append(const Diagnostics& other);

  /// An error whose text is only made when it is going to be shown: a file may hold a million.
  template <std::invocable MakeText>
  void Error(SourceLocation where, const MakeText& make_text) {
    std::string text = IsFull(where) ? std::string() : make_text();
    Error(std::move(where), std::move(text));
  }

  bool HasErrors() const { return error_count_ > 0; }
  /// What the errors are about, as the exit code of a program: the input, unless a later one of the
  /// list of codes is among them.
  ErrorCode Code() const { return code_; }
  /// Fails with the error that was found first, for those who can pass on only one.
  Result<void> FirstError() const;
  size_t ErrorCount() const { return error_count_; }
  size_t WarningCount() const { return warning_count_; }
  const std::vector<Diagnostic>& All() const { return kept_; }

  /// True once a file has shown its share of errors: readers may then stop looking for more.
  bool IsFull(const SourceLocation& file) const;

  /// One line each, "file:line:column: error: text", each under 500 characters and free of control
  /// characters, followed by a line for each file that has more than is shown. File by file in the
  /// order of their first trouble; in each by place, what concerns the whole file at the end.
  std::vector<std::string> Lines() const;

 private:
  struct Counts {
    size_t errors = 0;
    size_t warnings = 0;
  };
  void Add(Severity severity, SourceLocation where, std::string text);

  std::vector<Diagnostic> kept_;
  std::map<std::string, Counts> counts_;  // by file name
  ErrorCode code_ = ErrorCode::kInput;
  size_t error_count_ = 0;
  size_t warning_count_ = 0;
};

}  // namespace candela
