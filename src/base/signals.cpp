#include "base/signals.h"

#include <atomic>
#include <csignal>
#include <cstdlib>

#include "base/files.h"
#include "base/terminal.h"

namespace candela {
namespace {

extern "C" void EndProcess(int signal) {
  // Only async-signal-safe calls: unlink, write and _Exit.
  RemoveUnfinishedOutput();
  EndOpenLine();
  std::_Exit(128 + signal);
}

std::atomic<CancelToken*> token_to_cancel = nullptr;
static_assert(std::atomic<CancelToken*>::is_always_lock_free);

extern "C" void CancelOnce(int signal) {
  std::signal(signal, EndProcess);
  if (CancelToken* token = token_to_cancel.load(std::memory_order_relaxed)) token->Cancel();
}

using Handler = void (*)(int);

/// A signal that the parent chose to ignore (nohup) stays ignored.
void Handle(int signal, Handler handler) {
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void HandleStopSignals(Handler handler) {
  Handle(SIGINT, handler);
  Handle(SIGTERM, handler);
  // Standard C++ and Windows know only those two.
#ifdef SIGHUP
  Handle(SIGHUP, handler);
#endif
}

}  // namespace

CancelOnStopSignals::CancelOnStopSignals(CancelToken* token) {
  token_to_cancel.store(token, std::memory_order_relaxed);
  HandleStopSignals(CancelOnce);
}

CancelOnStopSignals::~CancelOnStopSignals() {
  HandleStopSignals(EndProcess);
  token_to_cancel.store(nullptr, std::memory_order_relaxed);
}

void ExitOnStopSignals() {
  HandleStopSignals(EndProcess);
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

}  // namespace candela
