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
  std::signal(SIGINT, remember_interrupt);
  std::signal(SIGTERM, remember_interrupt);
}

void check_interrupt() {
  if (interrupted) throw Interrupted{};
}

}  // namespace terrview
