#include "base/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/text.h"

namespace candela {
namespace {

constexpr size_t kLongestLine = 499;

const std::string& FileName(const SourceLocation& where) {
  static const std::string kNone;
  return where.file ? *where.file : kNone;
}

void AddMoreLine(const std::string& file, size_t count, const char* what,
                 std::vector<std::string>* lines) {
  if (count <= Diagnostics::kMostPerFile) return;
  const size_t more = count - Diagnostics::kMostPerFile;
  const std::string place = file.empty() ? "" : DisplayName(file) + ": ";
  lines->push_back(fmt::format("{}{} more {}{}", place, more, what, more == 1 ? "" : "s"));
}

/// What is wrong is found in passes over a scene; readers of the report go through its file once.
std::vector<Diagnostic> InReadingOrder(std::vector<Diagnostic> all) {
  std::map<std::string_view, size_t> ranks;  // of files, by their first diagnostic
  for (const Diagnostic& each : all) ranks.emplace(FileName(each.where), ranks.size());
  const auto key = [&](const Diagnostic& each) {
    // Line 0 less one is the largest number: the file as a whole comes last.
    return std::tuple(ranks.at(FileName(each.where)), each.where.line - 1, each.where.column);
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  return all;
}

}  // namespace

void Diagnostics::Error(SourceLocation where, std::string text, ErrorCode code) {
  code_ = std::max(code_, code);
  Add(Severity::kError, std::move(where), std::move(text));
}

void Diagnostics::Warning(SourceLocation where, std::string text) {
  Add(Severity::kWarning, std::move(where), std::move(text));
}

void Diagnostics::Add(Severity severity, SourceLocation where, std::string text) {
  Counts& counts = counts_[FileName(where)];
  size_t& count = severity == Severity::kError ? counts.errors : counts.warnings;
  ++(severity == Severity::kError ? error_count_ : warning_count_);
  if (++count <= kMostPerFile) kept_.push_back({severity, std::move(where), std::move(text)});
}

void Diagnostics::Append(const Diagnostics& other) {
  for (const Diagnostic& each : other.kept_) Add(each.severity, each.where, each.text);
  code_ = std::max(code_, other.code_);
  // What the other one only counted still counts here.
  for (const auto& [file, counts] : other.counts_) {
    Counts& mine = counts_[file];
    const size_t errors = counts.errors > kMostPerFile ? counts.errors - kMostPerFile : 0;
    const size_t warnings = counts.warnings > kMostPerFile ? counts.warnings - kMostPerFile : 0;
    mine.errors += errors;
    mine.warnings += warnings;
    error_count_ += errors;
    warning_count_ += warnings;
  }
}

bool Diagnostics::IsFull(const SourceLocation& file) const {
  const auto found = counts_.find(FileName(file));
  return found != counts_.end() && found->second.errors >= kMostPerFile;
}

Result<void> Diagnostics::FirstError() const {
  const auto first = std::ranges::find(kept_, Severity::kError, &Diagnostic::severity);
  if (first == kept_.end()) return {};
  const std::string place = ToString(first->where);
  return candela::Error{code_, place.empty() ? first->text : place + ": " + first->text};
}

std::vector<std::string> Diagnostics::Lines() const {
  std::vector<std::string> lines;
  for (const Diagnostic& each : InReadingOrder(kept_)) {
    const std::string place = ToString(each.where);
    lines.push_back(
        CutTo(kLongestLine, fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ",
                                        each.severity == Severity::kError ? "error" : "warning",
                                        EscapeControl(each.text))));
  }
  for (const auto& [file, counts] : counts_) {
    AddMoreLine(file, counts.errors, "error", &lines);
    AddMoreLine(file, counts.warnings, "warning", &lines);
  }
  return lines;
}

}  // namespace candela
