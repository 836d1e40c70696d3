#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace candela {

/// What kind of trouble ended an operation. The values are the exit codes of the programs.
enum class ErrorCode {
  kInput = 1,      ///< A file that was read is wrong or missing.
  kUsage = 2,      ///< The command line (or the caller's options) is wrong.
  kOutput = 3,     ///< An output cannot be written.
  kResources = 4,  ///< It would not fit: memory or size.
  kStopped = 5,    ///< Stopped on request before the end.
};

/// Why an operation failed, in words for the user.
struct Error {
  ErrorCode code;
  std::string message;
};

/// The value of an operation that can fail, or the reason why it did.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return CHECK(ok()), std::get<0>(state_); }
  const T& value() const& { return CHECK(ok()), std::get<0>(state_); }
  T&& value() && { return CHECK(ok()), std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const { return CHECK(!ok()), std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or the reason of the failure.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}

  bool ok() const { return !failed_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return CHECK(failed_), error_; }

 private:
  bool failed_ = false;
  Error error_{ErrorCode::kInput, {}};
};

}  // namespace candela
