#include "subjects/second_run/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/settings_kind.hpp"
#include "mistakes/mistakes.hpp"

namespace gjkscope {
namespace {

using toml_file::Field;

constexpr std::string_view kSideBySide = "two-runs";
constexpr int kLogBytes = 1 << 21;
constexpr int kPathLength = 1000;

std::vector<std::string> mistake_names() {
  std::vector<std::string> out;
  for (const Mistake& each : mistakes()) out.emplace_back(each.name);
  return out;
}

void second_keys(KeyPass& keys, LessonSecond& second) {
  constexpr std::string_view kOneOf = "one of the table's keys";
  constexpr std::string_view kAsFirst = "that of the lesson's run";
  std::optional<std::string> mistake;
  if (!second.mistake.empty()) mistake = second.mistake;
  keys("mistake", kOneOf,
       "the second run is that of the textbook's loop with this line changed (src/mistakes)")
      .name(mistake, "mistake", mistake_names());
  second.mistake = mistake.value_or("");
  keys("log", kOneOf,
       "the second run is that of this log (docs/log-format.md), as seen from the folder of the "
       "lesson; the shapes are those of the log",
       text_up_to(kPathLength))
      .other();
  keys("scalar", kAsFirst, "the second run is GJK in this scalar, from the same vertices")
      .choice<ScalarKind>(second.scalar, "scalar");
  keys("direction", kAsFirst, "the second run is GJK with this search direction")
      .choice<gjk::DirectionRule>(second.direction, "direction rule");
  keys("regions", kAsFirst, "the second run is GJK with this order of the region tests")
      .choice<gjk::RegionOrder>(second.regions, "region order");
  keys("stop", kAsFirst, "the second run is GJK with these stop tests").stop_tests(second.stop);
}

std::optional<NamedFile> read_log_file(const TableSource& source, const Field& field,
                                       LessonSecond& second) {
  const std::optional<std::string> path = source.reader.text(field, kPathLength);
  if (!path) return std::nullopt;
  const std::filesystem::path file = source.folder / *path;
  FileText read = source.read_file(file, kLogBytes);
  if (!read.text || read.text->size() > kLogBytes) {
    source.problems.add(
        field.place(),
        fmt::format("{}: {}", file.string(), read.text ? "the file is too large" : read.problem),
        fmt::format("a log of at most {} bytes", kLogBytes));
    return std::nullopt;
  }
  judging::ReadLog log = judging::read_log(*read.text, file.string());
  if (!log.log || log.log->dimension != 2) {
    source.problems.add(
        field.place(), log.log ? file.string() + ": the log is in space" : to_string(log.problems));
    return std::nullopt;
  }
  second.log = std::make_shared<const judging::Log>(*std::move(log.log));
  return NamedFile{*path, std::make_shared<const std::string>(*std::move(read.text))};
}

/// A half cannot hold all that a double can.
void check_halves(const TableSource& source, const Field& scalar) {
  double largest = 0.0;
  const auto take = [&](const std::vector<Eigen::Vector3d>& points) {
    for (const Eigen::Vector3d& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  };
  for (const LessonShape& shape : source.lesson.bodies) {
    largest = std::max(largest, shape.radius);
    take({shape.translate});
    take(shape.vertices);
  }
  if (const auto& path = source.lesson.path_of_shapes) {
    for (const LessonMotion& motion : path->motions) take(motion.points);
  }
  if (largest > limits::kLargestHalf) {
    source.problems.add(scalar.place(), fmt::format("half precision cannot hold {}", largest),
                        fmt::format("coordinates from -{0} to {0}", limits::kLargestHalf));
  }
}

TourSettings read_second(const TableSource& source) {
  LessonSecond second;
  const Field mistake = source.table["mistake"];
  const Field log = source.table["log"];
  const Field scalar = source.table["scalar"];
  const bool by_gjk =
      scalar || source.table["direction"] || source.table["regions"] || source.table["stop"];
  const auto refuse = [&](const Place& place, std::string what, std::string expected) {
    source.problems.add(place, std::move(what), std::move(expected));
  };
  source.read_keys(source.table, second_keys, second);
  if (second.scalar == source.lesson.scalar && !second.has_rules()) {
    refuse(scalar.place(), "the second run has the scalar of the first",
           fmt::format("another one than '{}'", name_of(source.lesson.scalar)));
  }
  if (second.scalar == ScalarKind::half) check_halves(source, scalar);
  if ((mistake ? 1 : 0) + (log ? 1 : 0) + (by_gjk ? 1 : 0) != 1) {
    refuse(source.place, "[second] does not say which run it is",
           "a mistake, a log, or what differs in a run of GJK: scalar, direction, regions, stop");
  } else if (mistake && source.lesson.dimension == 3) {
    refuse(mistake.place(), "a mistake in a loop in space",
           "points [x, y]: the textbook's page is of the plane");
  } else if (source.lesson.tour != kSideBySide && (!second.is_gjk() || second.has_rules() || log)) {
    refuse(source.place, "a second run that differs from the first in more than its scalar",
           fmt::format("tour = \"{}\" in [steps], which shows them side by side", kSideBySide));
  }
  std::optional<NamedFile> file;
  if (log) file = read_log_file(source, log, second);
  TourSettings read(std::move(second));
  read.file = std::move(file);
  return read;
}

void write_second(const TourSettings& table, TomlText& out) {
  out.table("[second]");
  if (table.file) out.key("log", as_text(table.file->path));
  out.lines(written_keys(*table.as<LessonSecond>(), second_keys));
}

}  // namespace

gjk::Options LessonSecond::options(gjk::Options first) const {
  first.direction_rule = direction.value_or(first.direction_rule);
  first.region_order = regions.value_or(first.region_order);
  if (stop) {
    first.stop_on_repeated_support = (*stop)[0];
    first.stop_on_no_progress = (*stop)[1];
  }
  return first;
}

std::string LessonSecond::rules() const {
  std::vector<std::string> out;
  if (direction)
    out.emplace_back(*direction == gjk::DirectionRule::towards_origin ? "d = O − P"
                                                                      : "d across the edge");
  if (regions) out.push_back(fmt::format("regions {}", name_of(*regions)));
  if (stop && !(*stop)[0]) out.emplace_back("no test for a repeated support point");
  if (stop && !(*stop)[1]) out.emplace_back("no test for progress");
  if (stop && (*stop)[0] && (*stop)[1]) out.emplace_back("all stop tests");
  return fmt::format("{}", fmt::join(out, " and "));
}

const LessonSecond* second_of(const Lesson& lesson) { return lesson.settings.as<LessonSecond>(); }

const SettingsKind LessonSecond::kKind = {
    kTable, "the run that is set beside the lesson's own",
    [] { return listed_keys<LessonSecond>(kTable, second_keys); }, read_second, write_second};

}  // namespace gjkscope
