#include "trial/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace gjkscope::judging {
namespace {

using Clock = std::chrono::steady_clock;

/// A line that is longer is no answer.
constexpr std::size_t kLongestLine = 1 << 20;
/// Cases that are asked one at a time after a program has ended early.
constexpr std::size_t kOneByOne = 64;

/// A shell's command with pipes to it, in a process group of its own.
class Child {
 public:
  Child(const std::string& command, bool is_loud) {
    std::array<int, 2> in = {};
    std::array<int, 2> out = {};
    if (pipe2(in.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a program");
    if (pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe from a program");
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no program can be started");
    if (pid_ == 0) {
      setpgid(0, 0);
      signal(SIGPIPE, SIG_DFL);
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      if (!is_loud) dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    setpgid(pid_, pid_);
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
    for (const int file : {to_, from_}) fcntl(file, F_SETFL, O_NONBLOCK);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    close_input();
    close(from_);
    if (pid_ < 0) return;
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }

  void close_input() {
    if (to_ >= 0) close(to_);
    to_ = -1;
  }
  [[nodiscard]] int input() const { return to_; }
  [[nodiscard]] int output() const { return from_; }

  /// How it ended, once its output has.
  std::string ended() {
    int status = 0;
    for (int i = 0; i < 100 && waitpid(pid_, &status, WNOHANG) == 0; ++i) {
      if (i == 99) return "closed its output";
      usleep(10000);
    }
    kill(-pid_, SIGKILL);  // what it left behind
    pid_ = -1;
    if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
    return fmt::format("ended with exit code {}", WEXITSTATUS(status));
  }

 private:
  pid_t pid_ = -1;
  int to_ = -1;
  int from_ = -1;
};

struct Round {
  std::vector<std::string> lines;  ///< At most as many as cases.
  bool silent = false;             ///< It still ran when patience ended.
  std::string how;                 ///< It ended.
};

/// The lines that are whole.
void split(std::string& text, std::vector<std::string>& lines, std::size_t most) {
  std::size_t begin = 0;
  for (std::size_t end = 0;
       lines.size() < most && (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  text.erase(0, begin);
}

Round run_once(const std::string& command, std::span<const std::string> cases, double seconds,
               bool is_loud) {
  Round out;
  Child child(command, is_loud);
  std::string unsent;
  std::size_t next = 0;
  std::string unread;
  auto moved = Clock::now();
  while (out.lines.size() < cases.size()) {
    while (unsent.size() < 65536 && next < cases.size()) unsent += cases[next++] + '\n';
    if (unsent.empty()) child.close_input();
    std::array<pollfd, 2> files = {pollfd{child.output(), POLLIN, 0},
                                   pollfd{child.input(), POLLOUT, 0}};
    const std::chrono::duration<double> waited = Clock::now() - moved;
    const int rest = static_cast<int>(1000 * (seconds - waited.count()));
    const int ready = poll(files.data(), files.size(), std::max(rest, 0));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) {
      out.silent = true;
      return out;
    }
    if ((files[1].revents & (POLLOUT | POLLERR | POLLHUP)) != 0) {
      const ssize_t sent = write(child.input(), unsent.data(), unsent.size());
      if (sent > 0) {
        unsent.erase(0, static_cast<std::size_t>(sent));
        moved = Clock::now();
      } else if (errno != EAGAIN && errno != EINTR) {  // it reads no more
        unsent.clear();
        next = cases.size();
      }
    }
    if ((files[0].revents & (POLLIN | POLLHUP | POLLERR)) == 0) continue;
    static thread_local std::array<char, 65536> buffer;
    const ssize_t got = read(child.output(), buffer.data(), buffer.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (got <= 0) {
      if (!unread.empty()) out.lines.push_back(unread);  // the last line, without its end
      out.how = child.ended();
      return out;
    }
    const std::size_t before = out.lines.size();
    unread.append(buffer.data(), static_cast<std::size_t>(got));
    split(unread, out.lines, cases.size());
    if (out.lines.size() > before) moved = Clock::now();
    if (unread.size() > kLongestLine && out.lines.size() < cases.size()) {
      out.lines.push_back("a line without an end");
      out.how = "wrote a line without an end";
      return out;
    }
  }
  return out;
}

/// A write to a program that has ended is an error, and no signal.
class IgnoredPipes {
 public:
  IgnoredPipes() : before_(signal(SIGPIPE, SIG_IGN)) {}
  IgnoredPipes(const IgnoredPipes&) = delete;
  IgnoredPipes& operator=(const IgnoredPipes&) = delete;
  ~IgnoredPipes() { signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
};

}  // namespace

std::vector<Reply> ask(const std::string& command, const std::vector<std::string>& cases,
                       const Patience& patience) {
  const IgnoredPipes ignored;
  std::vector<Reply> replies(cases.size());
  const std::span all(cases);
  std::size_t at = 0;
  bool is_loud = patience.is_loud;
  bool has_answered = false;
  const auto take = [&](Round& round) {
    has_answered = has_answered || !round.lines.empty();
    for (std::string& line : round.lines) replies[at++] = {Reply::Kind::answered, std::move(line)};
  };
  constexpr int kMostUnheard = 3;
  for (int faults = 0; at < cases.size() && faults < patience.most_faults &&
                       (has_answered || faults < kMostUnheard);) {
    Round round = run_once(command, all.subspan(at), patience.seconds, is_loud);
    is_loud = false;
    take(round);
    const std::size_t end = std::min(cases.size(), at + kOneByOne);
    while (at < end) {
      Round one = run_once(command, all.subspan(at, 1), patience.seconds, false);
      if (!one.lines.empty()) {
        take(one);
        continue;
      }
      replies[at++] = {one.silent ? Reply::Kind::silent : Reply::Kind::crashed, one.how};
      ++faults;
      break;
    }
  }
  return replies;
}

}  // namespace gjkscope::judging
