#include "base/signals.h"

#include <unistd.h>

#include <csignal>

#include "base/files.h"
#include "base/terminal.h"

namespace candela {
namespace {

extern "C" void EndProcess(int signal) {
  // Only async-signal-safe calls: unlink, write and _exit.
  RemoveUnfinishedOutput();
  EndOpenLine();
  _exit(128 + signal);
}

}  // namespace

void ExitOnStopSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A signal that the parent chose to ignore (nohup) stays ignored.
    if (std::signal(signal, EndProcess) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace candela
