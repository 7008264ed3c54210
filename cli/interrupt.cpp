#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace terrview {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "used in a signal handler");

extern "C" void remember_interrupt(int /*signal*/) { interrupted = true; }

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // What the parent had ignored (nohup, a shell's background jobs) stays ignored.
    if (std::signal(signal, remember_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void check_interrupt() {
  if (interrupted) throw Interrupted{};
}

}  // namespace terrview
