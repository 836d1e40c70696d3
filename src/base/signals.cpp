#include "base/signals.h"

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

/// A signal that the parent chose to ignore (nohup) stays ignored.
void EndProcessOn(int signal) {
  if (std::signal(signal, EndProcess) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

void ExitOnStopSignals() {
  EndProcessOn(SIGINT);
  EndProcessOn(SIGTERM);
  // Standard C++ and Windows know only those two.
#ifdef SIGHUP
  EndProcessOn(SIGHUP);
#endif
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

}  // namespace candela
