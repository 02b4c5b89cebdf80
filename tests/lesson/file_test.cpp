// Files appear whole or not at all.

#include "base/file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <stdexcept>
#include <string>

#include "lesson_texts.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace file_test {

namespace fs = std::filesystem;
using testing::file_text;

class WriteWhole : public ::testing::Test {
 protected:
  /// Name and bytes of every file of the folder.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_))
      files[entry.path().filename().string()] = file_text(entry.path());
    return files;
  }

  test::TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

using Files = std::map<std::string, std::string>;

TEST_F(WriteWhole, ReplacesAFile) {
  write_whole(folder_ / "a", std::string_view("one"));
  write_whole(folder_ / "a", std::string_view("two"));
  EXPECT_EQ(contents(), (Files{{"a", "two"}}));
}

TEST_F(WriteWhole, SaysWhyItCannotAndLeavesNothingBehind) {
  const fs::path missing = folder_ / "none" / "b";
  try {
    write_whole(missing, std::string_view("x"));
    ADD_FAILURE() << "there is no such folder";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot write " + missing.string() + ": No such file or directory");
  }
  fs::create_directory(folder_ / "c");
  try {
    write_whole(folder_ / "c", std::string_view("x"));
    ADD_FAILURE() << "this is a folder";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot write " + (folder_ / "c").string() + ": Is a directory");
  }
  fs::remove(folder_ / "c");
  EXPECT_EQ(contents(), Files{});
}

TEST_F(WriteWhole, KeepsPermissionsAndLinks) {
  write_whole(folder_ / "a", std::string_view("one"));
  fs::permissions(folder_ / "a", fs::perms(0640));
  fs::create_symlink("a", folder_ / "link");
  write_whole(folder_ / "link", std::string_view("two"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_FALSE(fs::is_symlink(folder_ / "a"));
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms(0640));
  EXPECT_EQ(contents(), (Files{{"a", "two"}, {"link", "two"}}));
}

TEST_F(WriteWhole, LeavesTheOldFileOrTheNewOneWhenItIsKilled) {
  const std::string old_text(3'000'000, 'o');
  const std::string new_text(2'000'000, 'n');
  write_whole(folder_ / "a", old_text);
  for (int i = 0; i < 20; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (;;) {
        write_whole(folder_ / "a", new_text);
        write_whole(folder_ / "a", old_text);
      }
    }
    ::usleep(static_cast<useconds_t>(2000 + 1700 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string text = file_text(folder_ / "a");
    ASSERT_TRUE(text == old_text || text == new_text) << text.size();
  }
  remove_leftovers(folder_);
  EXPECT_EQ(contents().size(), 1u);
}

}  // namespace file_test
}  // namespace gjkscope
