#pragma once
// Small pictures of lessons for the list beside the stage.

#include <filesystem>
#include <future>
#include <map>

#include "lesson/lesson.hpp"
#include "picture/picture.hpp"
#include "picture/type.hpp"

namespace gjkscope {

/// The first view of a lesson's last frame, without words: of thumbnails::kWidth x kHeight frame
/// pixels. Throws what loading throws.
[[nodiscard]] Picture thumbnail(Lesson lesson, const Fonts& fonts);

namespace thumbnails {
inline constexpr double kWidth = 150.0;
inline constexpr double kHeight = 100.0;
}  // namespace thumbnails

/// Each is made when it is first looked at, one after the other in a thread of its own.
class Thumbnails {
 public:
  /// `fonts` must outlive this.
  explicit Thumbnails(const Fonts& fonts) : fonts_(fonts) {}
  /// Null until it is made. Without marks where the file has no lesson, or is gone.
  [[nodiscard]] const Picture* of(const std::filesystem::path& file);
  /// The file has changed.
  void forget(const std::filesystem::path& file);
  /// Takes what was made.
  void tick();
  [[nodiscard]] bool is_making() const { return making_.valid(); }

 private:
  const Fonts& fonts_;
  std::map<std::filesystem::path, Picture> made_;
  std::filesystem::path being_made_;  ///< Empty when it was forgotten meanwhile.
  std::future<Picture> making_;
};

}  // namespace gjkscope
