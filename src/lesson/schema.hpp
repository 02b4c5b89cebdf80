#pragma once
// The keys of a lesson file: the loader reads from them which there are, which are required and
// what a message says was expected; lessons/README.md lists them.

#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

/// One key. Tables are called as in the file: "" is the file itself, "shapes.X" stands for both
/// shapes, "views" for each of its entries, "views.camera" for the camera of a view.
struct LessonKey {
  std::string table;
  std::string key;
  std::string type;       ///< The expected type, as a message calls it.
  std::string otherwise;  ///< Holds when the key is missing; kRequired: it must be there.
  std::string meaning;
};

inline constexpr std::string_view kRequired = "required";

struct Tour;

/// All keys, in the order in which README.md lists them: those of every lesson, then those of the
/// tables that tours take.
[[nodiscard]] std::vector<LessonKey> lesson_keys(const std::vector<const Tour*>& tours);

// Types of keys, as messages say them.

/// "text of 1 to 80 characters"
[[nodiscard]] std::string text_up_to(int length);
/// "one of: boxes, circles"
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);

/// Limits of what a lesson may hold: what a frame can show, and what a run should have to compute.
namespace limits {
inline constexpr int kFileBytes = 1 << 21;  ///< Room for the largest shapes, all digits written.
inline constexpr int kTitleLength = 80;
inline constexpr int kSourceLength = 120;
inline constexpr int kProseLength = 300;  ///< Two lines of a frame.
inline constexpr int kOpeningLength = 200;
inline constexpr int kNextLength = 160;
inline constexpr int kLessonIdLength = 60;
inline constexpr int kViewTitleLength = 60;
inline constexpr int kMostViews = 3;
inline constexpr int kShapeNameLength = 12;
inline constexpr int kVertexNameLength = 3;
inline constexpr int kLastChapter = 99;
inline constexpr int kLastOrder = 99;
inline constexpr int kVertices = 10000;       ///< In one shape: a limit of drawing, not of GJK.
inline constexpr int kDifferences = 1000000;  ///< y - x, where an effect is made of all of them.
inline constexpr int kPositions = 500;        ///< On a path.
inline constexpr double kShortest = 0.001;    ///< The shortest motion, in seconds.
inline constexpr double kLongest = 3600.0;
inline constexpr double kTurn = 360.0;          ///< Degrees.
inline constexpr double kUpright = 90.0;        ///< Degrees that an eye is raised or lowered.
inline constexpr int kScannedVertices = 20000;  ///< Vertices of both shapes times positions.
inline constexpr int kCap = 100;                ///< The steps of all positions are kept in memory.
inline constexpr int kSimplexVertices = 3;
inline constexpr int kOutlineVertices = 3;  ///< At least, of each of several outlines.
/// Coordinates: doubles of this size still differ by less than a frame shows of a world as large;
/// their products stay far from overflow in single precision, too.
inline constexpr double kLargest = 1e18;
inline constexpr double kLargestHalf = 65504.0;  ///< The largest finite half.
inline constexpr double kSmallestCameraHeight = 1e-18;
inline constexpr double kMostStretch = 1e9;
}  // namespace limits

}  // namespace gjkscope
