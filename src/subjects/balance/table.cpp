#include "subjects/balance/table.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "lesson/settings_kind.hpp"
#include "subjects/balance/subject.hpp"

namespace gjkscope {
namespace {

using toml_file::Field;

constexpr int kMoments = 500;  // at all positions together
constexpr double kLongestSimulation = 3600.0;

void time_keys(KeyPass& keys, LessonTime& time) {
  keys("seconds", kRequired, "length of the simulation; with `frames` the last frame is at its end",
       fmt::format("number above 0, up to {}", kLongestSimulation))
      .number(time.seconds, 0.0, kLongestSimulation);
  keys("frames", "`moments`", "moments at equal steps, for each position of X")
      .whole_number(time.frames, 2, kMoments);
  std::vector<std::string> lists;
  for (const std::vector<double>& moments : time.moments) lists.push_back(in_brackets(moments));
  keys("moments", "`frames`", "seconds of the frames, a list for each position of X",
       "list of lists of ascending numbers from 0 to `seconds`")
      .other_list(lists);
}

std::vector<std::vector<double>> read_moments(const TableSource& source, const Field& field,
                                              double last, std::size_t positions) {
  std::vector<std::vector<double>> all;
  std::size_t count = 0;
  for (const Field& list : source.reader.entries(field, "list of seconds")) {
    std::vector<double>& moments = all.emplace_back();
    const std::vector<Field> entries =
        source.reader.entries(list, fmt::format("number from 0 to {:g}", last));
    for (const Field& entry : entries) {
      const std::optional<double> moment = source.reader.number(entry, 0.0, last);
      if (!moment) continue;
      if (!moments.empty() && *moment <= moments.back()) {
        source.problems.add(entry.place(), entry.label + " does not come later",
                            "ascending moments");
      }
      moments.push_back(*moment);
    }
    if (list.node->is_array() && entries.empty())
      source.problems.add(list.place(), list.label + " is empty", "at least one moment");
    count += moments.size();
  }
  if (!field.node->is_array()) return all;
  if (all.size() != positions) {
    source.problems.add(field.place(),
                        fmt::format("{} lists for {} positions", all.size(), positions),
                        "a list for each position of X");
  }
  if (count > kMoments) {
    source.problems.add(field.place(), fmt::format("{} moments", count),
                        fmt::format("at most {} in all", kMoments));
  }
  return all;
}

TourSettings read_time(const TableSource& source) {
  LessonTime time;
  const Field seconds = source.table["seconds"];
  source.read_keys(source.table, time_keys, time);
  if (time.seconds == 0.0) source.problems.add(seconds, "'seconds' is 0");
  const Field frames = source.table["frames"];
  const Field moments = source.table["moments"];
  const std::size_t positions =
      source.lesson.path_of_shapes ? source.lesson.path_of_shapes->positions() : 1;
  if (moments && !frames) {
    time.frames = 0;
    time.moments = read_moments(source, moments, time.seconds, positions);
    return TourSettings(std::move(time));
  }
  if (moments) source.problems.add(moments.place(), "'moments' besides 'frames'", "one of the two");
  if (!frames)
    source.problems.add(source.place, "a simulation without frames", "'frames' or 'moments'");
  if (frames && positions * time.frames > kMoments) {
    source.problems.add(frames.place(),
                        fmt::format("{} frames at each of {} positions", time.frames, positions),
                        fmt::format("a product of at most {}", kMoments));
  }
  return TourSettings(std::move(time));
}

void write_time(const TourSettings& table, TomlText& out) {
  out.table("[time]");
  out.lines(written_keys(*table.as<LessonTime>(), time_keys, 2, {.frames = 0}));
}

}  // namespace

const SettingsKind LessonTime::kKind = {"time", "the moments that frames show",
                                        [] { return listed_keys<LessonTime>("time", time_keys); },
                                        read_time, write_time};

}  // namespace gjkscope
