#include "support/child.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace apps_test {

Child::Child(const Command& command, const std::function<void()>& prepare) {
  std::vector<std::string> words = command;
  // A signal that comes before the handlers of the test are removed would be handled by them.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  id_ = fork();
  if (id_ != 0) pthread_sigmask(SIG_SETMASK, &before, nullptr);
  REQUIRE(id_ >= 0);
  if (id_ > 0) return;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
  sigemptyset(&before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  redirect(STDERR_FILENO, "/dev/null", O_WRONLY);
  prepare();
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

Child::~Child() {
  if (ended_) return;
  kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

void Child::send(int signal) const { REQUIRE(kill(id_, signal) == 0); }

Ending Child::wait() {
  if (ended_) return ending_;
  int status = 0;
  REQUIRE(waitpid(id_, &status, 0) == id_);
  take(status);
  return ending_;
}

bool Child::has_ended() {
  int status = 0;
  if (!ended_ && waitpid(id_, &status, WNOHANG) == id_) take(status);
  return ended_;
}

void Child::take(int status) {
  ended_ = true;
  if (WIFEXITED(status)) ending_ = {WEXITSTATUS(status), 0};
  if (WIFSIGNALED(status)) ending_ = {-1, WTERMSIG(status)};
}

void redirect(int number, int descriptor) {
  if (dup2(descriptor, number) < 0) _exit(126);
}

void redirect(int number, const std::string& path, int flags) {
  const int descriptor = open(path.c_str(), flags, 0600);
  redirect(number, descriptor);
  if (descriptor != number) close(descriptor);
}

}  // namespace apps_test
