#include "tests/cli/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "cli/run.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::dup2(file, stream) < 0) ::_exit(126);
  ::close(file);
}

void break_stream(int stream) {
  int ends[2];
  if (::pipe(ends) != 0 || ::dup2(ends[1], stream) < 0) ::_exit(126);
  ::close(ends[0]);
  ::close(ends[1]);
}

// Sends a stream to a file while it lives.
class Redirection {
 public:
  Redirection(std::FILE* stream, const std::string& path) : stream_(::fileno(stream)) {
    std::fflush(stream);
    before_ = ::dup(stream_);
    redirect(stream_, path);
  }
  ~Redirection() {
    ::dup2(before_, stream_);
    ::close(before_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

 private:
  int stream_;
  int before_;
};

}  // namespace

Program::Program(const std::vector<std::string>& args, const std::string& folder,
                 const RunOptions& options) {
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("no process");
  if (pid_ == 0) become(args, folder, options);
}

void Program::become(const std::vector<std::string>& args, const std::string& folder,
                     const RunOptions& options) const {
  redirect(STDOUT_FILENO, streams_ / "out");
  redirect(STDERR_FILENO, streams_ / "err");
  if (options.unread_messages) break_stream(STDERR_FILENO);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  // Whoever runs the tests may have these ignored.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
  if (options.ignored_signal) std::signal(*options.ignored_signal, SIG_IGN);
  ::alarm(options.patience_s);
  std::vector<char*> words{const_cast<char*>(TERRVIEW_PROGRAM)};
  for (const std::string& arg : args) words.push_back(const_cast<char*>(arg.c_str()));
  words.push_back(nullptr);
  ::execv(TERRVIEW_PROGRAM, words.data());
  ::_exit(127);
}

Program::~Program() {
  if (pid_ < 0) return;
  send(SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

Finished Program::wait() {
  int status = 0;
  if (::waitpid(pid_, &status, 0) != pid_) throw std::runtime_error("the program is lost");
  pid_ = -1;
  const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return {code, read_text(streams_ / "out"), read_text(streams_ / "err")};
}

FullDisk::FullDisk(std::uint64_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);  // so that writing fails instead
  ::getrlimit(RLIMIT_FSIZE, &before_);
  const rlimit limit{bytes, before_.rlim_max};
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("no limit to files");
}

FullDisk::~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

Finished run_here(const std::vector<std::string>& args, const std::string& folder) {
  const TemporaryFolder streams;
  const Redirection out(stdout, streams / "out");
  const Redirection err(stderr, streams / "err");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  const int code = run(args);
  std::filesystem::current_path(before);
  std::fflush(nullptr);
  return {code, read_text(streams / "out"), read_text(streams / "err")};
}

Finished run_program(const std::vector<std::string>& args, const std::string& folder,
                     const RunOptions& options) {
  return Program(args, folder, options).wait();
}

}  // namespace terrview
