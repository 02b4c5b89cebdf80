#include "subjects/study/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "lesson/settings_kind.hpp"
#include "subjects/study/subject.hpp"

namespace gjkscope {
namespace {

using toml_file::Field;
using toml_file::Table;

constexpr int kResultsBytes = 1 << 24;
constexpr int kPathLength = 1000;
constexpr int kAboutLength = 60;
constexpr int kNoteLength = 200;

void study_keys(KeyPass& keys, LessonStudy& study) {
  keys("results", kRequired, "accuracy.json of a study, as seen from the folder of the lesson",
       text_up_to(kPathLength))
      .other();
  keys("family", kRequired, "family of pairs that is shown, one of the file's", "name of a family")
      .other(as_text(study.family));
  keys("marks", kRequired, "configurations that frames introduce, in this order",
       fmt::format("1 to {} tables [[study.marks]]", LessonStudy::kMostMarks))
      .other();
}

void mark_keys(KeyPass& keys, StudyMark& mark) {
  keys("configuration", kRequired, "one of the family's configurations", "name of a configuration")
      .other(as_text(mark.configuration));
  keys("beside", "the mark before", "an earlier mark, which it is compared with",
       "name of a configuration")
      .other(as_text(mark.beside));
  keys("about", "none", "what it does, for the panel `study`").text(mark.about, kAboutLength);
  keys("note", "none", "a sentence about it, for the frame that introduces it")
      .text(mark.note, kNoteLength);
}

/// The file that [study] names; nothing where it cannot be read.
std::optional<NamedFile> read_results(const TableSource& source, LessonStudy& study) {
  const Field results = source.table["results"];
  const std::optional<std::string> path = source.reader.text(results, kPathLength);
  if (!path) return std::nullopt;
  const std::filesystem::path file = source.folder / *path;
  FileText read = source.read_file(file, kResultsBytes);
  if (!read.text) {
    source.problems.add(results.place(), fmt::format("{}: {}", file.string(), read.problem),
                        "accuracy.json of `gjkscope study accuracy --out`");
  } else if (read.text->size() > kResultsBytes) {
    source.problems.add(results.place(), fmt::format("{}: the file is too large", file.string()),
                        fmt::format("at most {} bytes", kResultsBytes));
  } else {
    try {
      study.results = std::make_shared<const StudyResults>(parse_study_results(*read.text));
      return NamedFile{*path, std::make_shared<const std::string>(*std::move(read.text))};
    } catch (const std::runtime_error& error) {
      source.problems.add(results.place(), fmt::format("{}: {}", file.string(), error.what()));
    }
  }
  return std::nullopt;
}

void read_mark(const TableSource& source, const Table& table, LessonStudy& study) {
  std::vector<std::string> known;
  for (const StudyDot& dot : of_family(study.dots(), study.family))
    known.push_back(dot.configuration);
  std::vector<std::string> earlier;
  for (const StudyMark& other : study.marks) earlier.push_back(other.configuration);
  StudyMark mark;
  mark.beside = source.reader.name(table["beside"], "earlier mark", earlier).value_or("");
  source.read_keys(table, mark_keys, mark);
  const Field configuration = table["configuration"];
  const std::optional<std::string> name = source.reader.name(configuration, "configuration", known);
  if (!name) return;
  if (std::find(earlier.begin(), earlier.end(), *name) != earlier.end()) {
    source.problems.add(configuration.place(),
                        fmt::format("configuration '{}' is named twice", *name),
                        "each configuration once");
  }
  mark.configuration = *name;
  study.marks.push_back(std::move(mark));
}

TourSettings read_study(const TableSource& source) {
  LessonStudy study;
  std::optional<NamedFile> file = read_results(source, study);
  if (!file) return {};
  study.family =
      source.reader.name(source.table["family"], "family", families_in(study.dots())).value_or("");
  const Field marks = source.table["marks"];
  const std::vector<Field> entries = source.reader.entries(marks, "table [[study.marks]]");
  if (marks && marks.node->is_array() &&
      (entries.empty() || entries.size() > LessonStudy::kMostMarks))
    source.problems.add(marks, fmt::format("{} marks", entries.size()));
  for (const Field& entry : entries) {
    const std::optional<Table> mark = source.reader.table(entry, "study.marks");
    if (mark && !study.family.empty()) read_mark(source, *mark, study);
  }
  TourSettings read(std::move(study));
  read.file = std::move(file);
  return read;
}

void write_study(const TourSettings& table, TomlText& out) {
  const LessonStudy& study = *table.as<LessonStudy>();
  out.table("[study]");
  if (table.file) out.key("results", as_text(table.file->path));
  out.lines(written_keys(study, study_keys));
  for (const StudyMark& mark : study.marks) {
    out.table("[[study.marks]]");
    out.lines(written_keys(mark, mark_keys));
  }
}

}  // namespace

const SettingsKind LessonStudy::kKind = {"study", "results of `gjkscope study accuracy`",
                                         [] {
                                           return listed_keys<LessonStudy>(
                                               "study", study_keys,
                                               listed_keys<StudyMark>("study.marks", mark_keys));
                                         },
                                         read_study, write_study};

}  // namespace gjkscope
