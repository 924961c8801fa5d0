#include "io/interrupt.h"

#include <atomic>
#include <csignal>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa::app {
namespace {

// Whether a signal has arrived. The flag is set in one thread and read in any, which sig_atomic_t does not allow.
std::atomic<bool> signal_came = false;
static_assert(std::atomic<bool>::is_always_lock_free, "else no handler may set it");

thread_local const std::function<bool()>* goes_on = nullptr;  // go_on_ of an Interruption

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { signal_came = true; };
  sigemptyset(&action.sa_mask);
  action.sa_flags = 0;  // no SA_RESTART: a waiting read or write must return
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // leave SIGHUP ignored under nohup
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

Interruption::Interruption(std::function<bool()> go_on) : go_on_(std::move(go_on)) { goes_on = &go_on_; }
Interruption::~Interruption() { goes_on = nullptr; }

bool interrupted() { return signal_came || (goes_on != nullptr && !(*goes_on)()); }

std::function<bool()> until_interrupted() {
  return [] { return !interrupted(); };
}

void stop_if_interrupted() {
  if (interrupted()) throw Cancelled();
}

}  // namespace rbpa::app
