#include "subjects/two_runs/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/table_kind.hpp"
#include "mistakes/mistakes.hpp"

namespace gjkscope {
namespace {

using toml_file::Field;

constexpr int kLogBytes = 1 << 21;
constexpr int kPathLength = 1000;

std::vector<std::string> mistake_names() {
  std::vector<std::string> out;
  for (const Mistake& each : mistakes()) out.emplace_back(each.name);
  return out;
}

std::vector<LessonKey> second_keys() {
  const std::string otherwise = "one of the three";
  return {
      {"second", "mistake", one_of(mistake_names()), otherwise,
       "the second run is that of the textbook's loop with this line changed (src/mistakes)"},
      {"second", "scalar", one_of(names_of<ScalarKind>()), otherwise,
       "the second run is GJK in this scalar"},
      {"second", "log", text_up_to(kPathLength), otherwise,
       "the second run is that of this log (docs/log-format.md), as seen from the folder of the "
       "lesson; the shapes are those of the log"},
  };
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

ActTable read_second(const TableSource& source) {
  LessonSecond second;
  const Field mistake = source.table["mistake"];
  const Field scalar = source.table["scalar"];
  const Field log = source.table["log"];
  if ((mistake ? 1 : 0) + (scalar ? 1 : 0) + (log ? 1 : 0) != 1)
    source.problems.add(source.place, "[second] does not say which run it is",
                        "one of mistake, scalar and log");
  if (mistake)
    second.mistake = source.reader.name(mistake, "mistake", mistake_names()).value_or("");
  if (scalar) second.scalar = source.reader.choice<ScalarKind>(scalar, "scalar");
  std::optional<NamedFile> file;
  if (log) file = read_log_file(source, log, second);
  ActTable read(std::move(second));
  read.file = std::move(file);
  return read;
}

void write_second(const ActTable& table, TomlText& out) {
  const LessonSecond& second = *table.as<LessonSecond>();
  out.table("[second]");
  out.text("mistake", second.mistake, "");
  out.text("scalar", second.scalar ? name_of(*second.scalar) : "", "");
  if (table.file) out.text("log", table.file->path, "");
}

}  // namespace

const TableKind LessonSecond::kKind = {"second", "the run that is set beside the lesson's own",
                                       second_keys, read_second, write_second};

}  // namespace gjkscope
