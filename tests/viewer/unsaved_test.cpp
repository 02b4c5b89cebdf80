// Work that a window left, however it ended.

#include "unsaved.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "lessons.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace {

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
    work.forget_left();
    EXPECT_TRUE(UnsavedWork(folder.path()).left().empty());
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
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

}  // namespace
}  // namespace gjkscope
