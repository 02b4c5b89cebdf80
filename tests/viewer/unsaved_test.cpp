// Work that a window left, however it ended.

#include "unsaved.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>

#include "lessons.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace unsaved_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// GJKSCOPE_KILLS asks for another number of killed windows.
int kill_count() {
  const char* asked = std::getenv("GJKSCOPE_KILLS");
  return asked ? std::atoi(asked) : 20;
}

/// A process that keeps a lesson with this title, and is killed.
void keep_and_be_killed(const fs::path& folder, Lesson lesson, const std::string& title) {
  const pid_t child = ::fork();
  if (child == 0) {
    lesson.title = title;
    const fs::path file = "/tmp/mine.toml";
    UnsavedWork(folder).keep({{lesson, file}});
    UnsavedWork* const never_ends = new UnsavedWork(folder);
    never_ends->keep({{lesson, file}});
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(UnsavedWork, OfKilledWindowsIsLeftOnce) {
  const TemporaryFolder folder;
  const Lesson lesson = testing::shipped_lesson("polygons-gjk");
  for (int i = 0; i < kill_count(); ++i) {
    const std::string title = "work " + std::to_string(i);
    keep_and_be_killed(folder.path(), lesson, title);
    UnsavedWork work(folder.path());
    // One window that was killed, and one that was closed.
    const std::vector<UnsavedWork::Left> left = work.left();
    ASSERT_EQ(2u, left.size());
    for (const UnsavedWork::Left& each : left) {
      EXPECT_NE(std::string::npos, each.text.find(title));
      EXPECT_EQ("/tmp/mine.toml", each.file);
    }
    EXPECT_TRUE(UnsavedWork(folder.path()).left().empty()) << "offered twice";
    for (const UnsavedWork::Left& each : left) work.forget(each);
    EXPECT_TRUE(UnsavedWork(folder.path()).left().empty());
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// Runs `content` as the first process of a container of its own, whose number is 1, and kills it
/// when it has ended. Gives what `content` gave; nothing where the system allows no containers.
std::optional<int> in_container(const std::function<int()>& content) {
  constexpr int kNoContainer = 255;
  const uid_t user = ::getuid();
  const gid_t group = ::getgid();
  const pid_t outside = ::fork();
  if (outside == 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0) ::_exit(kNoContainer);
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << user << ' ' << user << " 1";
    std::ofstream("/proc/self/gid_map") << group << ' ' << group << " 1";
    std::array<int, 2> pipe = {};
    if (::pipe(pipe.data()) != 0) ::_exit(kNoContainer);
    const pid_t first = ::fork();
    if (first < 0) ::_exit(kNoContainer);
    if (first == 0) {
      const auto given = static_cast<unsigned char>(::getpid() == 1 ? content() : kNoContainer);
      if (::write(pipe[1], &given, 1) != 1) ::_exit(1);
      while (true) ::pause();
    }
    unsigned char given = kNoContainer;
    const bool has_ended = ::read(pipe[0], &given, 1) == 1;
    ::kill(first, SIGKILL);
    ::waitpid(first, nullptr, 0);
    ::_exit(has_ended ? given : kNoContainer);
  }
  int status = 0;
  ::waitpid(outside, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) == kNoContainer) return std::nullopt;
  return WEXITSTATUS(status);
}

TEST(UnsavedWork, WhereThereAreContainersIsLeftToTheNextOneThoughBothAreProcess1) {
  const TemporaryFolder folder;
  const Lesson lesson = testing::shipped_lesson("polygons-gjk");
  const fs::path file = "/tmp/mine.toml";
  const std::optional<int> kept = in_container([&] {
    auto* const killed = new UnsavedWork(folder.path());
    killed->keep({{lesson, file}});
    return killed->keeps() ? 1 : 0;
  });
  if (!kept) GTEST_SKIP() << "no containers here";
  ASSERT_EQ(1, *kept);
  const auto count = [&] { return static_cast<int>(UnsavedWork(folder.path()).left().size()); };
  EXPECT_EQ(1, in_container(count));
  EXPECT_EQ(1, in_container(count)) << "a look takes nothing away";
  UnsavedWork outside(folder.path());
  ASSERT_EQ(1u, outside.left().size());
  EXPECT_EQ(0, in_container(count)) << "now it is offered outside";
}

TEST(UnsavedWork, OfAWindowThatLivesIsNobodysButItsOwn) {
  const TemporaryFolder folder;
  const Lesson lesson = testing::shipped_lesson("polygons-gjk");
  const fs::path file = "mine.toml";
  UnsavedWork one(folder.path());
  one.keep({{lesson, file}, {lesson, file}});
  EXPECT_TRUE(UnsavedWork(folder.path()).left().empty());
  one.keep({{lesson, file}});
  {
    UnsavedWork gone(folder.path());
    gone.keep({{lesson, file}});
  }
  UnsavedWork other(folder.path());
  EXPECT_EQ(1u, other.left().size());
}

TEST(UnsavedWork, NothingIsKeptWithoutAFolder) {
  UnsavedWork work{fs::path()};
  EXPECT_FALSE(work.keeps());
  const Lesson lesson;
  const fs::path file;
  work.keep({{lesson, file}});
  EXPECT_TRUE(work.left().empty());
}

}  // namespace unsaved_test
}  // namespace gjkscope
