// Results as CSV and JSON, by one list of fields.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>

#include "study/report.hpp"

namespace gjkscope::study {
namespace {

using Json = nlohmann::ordered_json;

struct Field {
  const char* name;
  std::variant<std::string& (*)(Row&), int& (*)(Row&), double& (*)(Row&), bool& (*)(Row&)> of;
};

template <class T, class Function>
Field field(const char* name, Function function) {
  return {name, static_cast<T& (*)(Row&)>(function)};
}

const std::vector<Field>& fields() {
  static const std::vector<Field> all = {
      field<std::string>(
          "family", [](Row & row) -> auto& { return row.family; }),
      field<int>(
          "vertices", [](Row & row) -> auto& { return row.vertices; }),
      field<std::string>(
          "configuration", [](Row & row) -> auto& { return row.configuration; }),
      field<std::string>(
          "axis", [](Row & row) -> auto& { return row.axis; }),
      field<std::string>(
          "proof", [](Row & row) -> auto& { return row.proof; }),
      field<bool>(
          "front", [](Row & row) -> auto& { return row.on_front; }),
      field<int>(
          "pairs", [](Row & row) -> auto& { return row.pairs; }),
      field<int>(
          "timed_pairs", [](Row & row) -> auto& { return row.timed_pairs; }),
      field<int>(
          "repetitions", [](Row & row) -> auto& { return row.repetitions; }),
      field<double>(
          "ns", [](Row & row) -> auto& { return row.ns.median; }),
      field<double>(
          "ns_low", [](Row & row) -> auto& { return row.ns.low; }),
      field<double>(
          "ns_high", [](Row & row) -> auto& { return row.ns.high; }),
      field<double>(
          "ratio", [](Row & row) -> auto& { return row.ratio.median; }),
      field<double>(
          "ratio_low", [](Row & row) -> auto& { return row.ratio.low; }),
      field<double>(
          "ratio_high", [](Row & row) -> auto& { return row.ratio.high; }),
      field<double>(
          "instructions", [](Row & row) -> auto& { return row.instructions; }),
      field<double>(
          "iterations", [](Row & row) -> auto& { return row.iterations; }),
      field<int>(
          "most_iterations", [](Row & row) -> auto& { return row.most_iterations; }),
      field<int>(
          "settled", [](Row & row) -> auto& { return row.settled; }),
      field<int>(
          "failed", [](Row & row) -> auto& { return row.failed; }),
      field<int>(
          "undecided", [](Row & row) -> auto& { return row.undecided; }),
      field<int>(
          "wrong", [](Row & row) -> auto& { return row.wrong; }),
      field<int>(
          "wrong_as_kept", [](Row & row) -> auto& { return row.wrong_as_kept; }),
      field<int>(
          "broken_bounds", [](Row & row) -> auto& { return row.broken_bounds; }),
      field<double>(
          "error", [](Row & row) -> auto& { return row.error; }),
      field<double>(
          "error_scale", [](Row & row) -> auto& { return row.error_scale; }),
      field<double>(
          "middle_error_scale", [](Row & row) -> auto& { return row.middle_error_scale; }),
      field<double>(
          "error_units", [](Row & row) -> auto& { return row.error_units; }),
      field<double>(
          "error_as_kept", [](Row & row) -> auto& { return row.error_as_kept; }),
      field<double>(
          "witness_scale", [](Row & row) -> auto& { return row.witness_scale; }),
      field<double>(
          "width_scale", [](Row & row) -> auto& { return row.width_scale; }),
  };
  return all;
}

template <class Visitor>
decltype(auto) visit(const Field& field, Row& row, Visitor visitor) {
  return std::visit([&](auto of) { return visitor(of(row)); }, field.of);
}

struct CsvText {
  std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text); }
  std::string operator()(int number) const { return std::to_string(number); }
  std::string operator()(bool yes) const { return yes ? "1" : "0"; }
  std::string operator()(double number) const {
    return std::isnan(number) ? "" : fmt::format("{}", number);
  }
};

/// One of the lines that begin with #.
struct Note {
  const char* name;
  std::string value;
};
std::vector<Note> notes(const Study& study) {
  std::vector<Note> out = {{"processor", study.machine.processor},
                           {"threads", std::to_string(study.machine.threads)},
                           {"compiler", study.machine.compiler},
                           {"flags", study.machine.flags},
                           {"commit", study.machine.commit},
                           {"seed", std::to_string(study.seed)},
                           {"quick", study.quick ? "1" : "0"},
                           {"complete", study.complete ? "1" : "0"},
                           {"families_planned", std::to_string(study.families_planned)},
                           {"seconds", fmt::format("{:.1f}", study.seconds)},
                           {"compared", std::to_string(study.compared)}};
  for (const Costlier& pair : study.costlier) {
    out.push_back({"costlier",
                   fmt::format(R"("{}","{}","{}",{},{},{},"{}")", pair.family, pair.less, pair.more,
                               pair.ratio.low, pair.ratio.median, pair.ratio.high, pair.reason)});
  }
  return out;
}

template <class Number>
bool read(std::string_view text, Number& out) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && stop == text.data() + text.size();
}

struct CsvReader {
  std::string_view text;

  bool operator()(std::string& out) const {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return false;
    out = text.substr(1, text.size() - 2);
    return true;
  }
  bool operator()(int& out) const { return read(text, out); }
  bool operator()(bool& out) const {
    out = text == "1";
    return text == "0" || text == "1";
  }
  bool operator()(double& out) const {
    if (text.empty()) out = std::numeric_limits<double>::quiet_NaN();
    return text.empty() || read(text, out);
  }
};

/// The fields of a line; texts keep their quotes.
std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> out;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != ',')) continue;
    out.push_back(line.substr(begin, i - begin));
    begin = i + 1;
  }
  return out;
}

bool read_costlier(std::string_view value, Study& study) {
  const std::vector<std::string_view> values = split(value);
  Costlier pair;
  const bool good = values.size() == 7 && CsvReader{values[0]}(pair.family) &&
                    CsvReader{values[1]}(pair.less) && CsvReader{values[2]}(pair.more) &&
                    CsvReader{values[3]}(pair.ratio.low) &&
                    CsvReader{values[4]}(pair.ratio.median) &&
                    CsvReader{values[5]}(pair.ratio.high) && CsvReader{values[6]}(pair.reason);
  if (good) study.costlier.push_back(std::move(pair));
  return good;
}

bool read_note(std::string_view name, std::string_view value, Study& study) {
  const auto flag = [&](bool& out) { return CsvReader{value}(out); };
  const auto text = [&](std::string& out) {
    out = value;
    return true;
  };
  if (name == "processor") return text(study.machine.processor);
  if (name == "threads") return read(value, study.machine.threads);
  if (name == "compiler") return text(study.machine.compiler);
  if (name == "flags") return text(study.machine.flags);
  if (name == "commit") return text(study.machine.commit);
  if (name == "seed") return read(value, study.seed);
  if (name == "quick") return flag(study.quick);
  if (name == "complete") return flag(study.complete);
  if (name == "families_planned") return read(value, study.families_planned);
  if (name == "seconds") return read(value, study.seconds);
  if (name == "compared") return read(value, study.compared);
  if (name == "costlier") return read_costlier(value, study);
  return false;
}

std::string header() {
  std::string out;
  for (const Field& field : fields())
    out += fmt::format("{}{}", out.empty() ? "" : ",", field.name);
  return out;
}

/// JSON has no number that is none or infinite.
Json number_json(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

}  // namespace

std::string to_csv(const Study& study) {
  std::string out;
  for (const Note& note : notes(study)) out += fmt::format("# {}: {}\n", note.name, note.value);
  out += header() + "\n";
  for (Row row : study.rows) {  // fields can be set, so they need a row of their own
    std::string line;
    for (const Field& field : fields()) {
      line += fmt::format("{}{}", line.empty() ? "" : ",", visit(field, row, CsvText{}));
    }
    out += line + "\n";
  }
  return out;
}

Study from_csv(std::string_view text) {
  Study out;
  int number = 0;
  bool in_rows = false;
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(fmt::format("line {}: {}", number, what));
  };
  for (std::size_t begin = 0; begin < text.size();) {
    ++number;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with("# ")) {
      const std::size_t colon = std::min(line.find(": "), line.size() - 2);
      const std::string_view name = line.substr(2, colon - 2);
      if (!read_note(name, line.substr(colon + 2), out)) {
        fail(fmt::format("'{}' is not known, or has another value", name));
      }
    } else if (!in_rows) {
      in_rows = true;
      if (line != header()) fail("expected the names of the fields: " + header());
    } else {
      const std::vector<std::string_view> values = split(line);
      if (values.size() != fields().size()) {
        fail(fmt::format("{} fields, expected {}", values.size(), fields().size()));
      }
      Row row;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const Field& field = fields()[i];
        const bool good = visit(field, row, CsvReader{values[i]});
        if (!good) fail(fmt::format("'{}' is no value of {}", values[i], field.name));
      }
      out.rows.push_back(std::move(row));
    }
  }
  if (!in_rows) fail("there are no rows");
  return out;
}

std::string to_json(const Study& study) {
  Json out;
  const Machine& machine = study.machine;
  out["machine"] = {{"processor", machine.processor},
                    {"threads", machine.threads},
                    {"compiler", machine.compiler},
                    {"flags", machine.flags},
                    {"commit", machine.commit}};
  out["seed"] = study.seed;
  out["quick"] = study.quick;
  out["complete"] = study.complete;
  out["families_planned"] = study.families_planned;
  out["seconds"] = study.seconds;
  out["compared"] = study.compared;
  out["costlier"] = Json::array();
  for (const Costlier& pair : study.costlier) {
    out["costlier"].push_back({{"family", pair.family},
                               {"less", pair.less},
                               {"more", pair.more},
                               {"ratio_low", pair.ratio.low},
                               {"ratio", pair.ratio.median},
                               {"ratio_high", pair.ratio.high},
                               {"reason", pair.reason}});
  }
  std::string rows;  // one a line
  for (Row row : study.rows) {
    Json one;
    for (const Field& field : fields()) {
      one[field.name] = visit(field, row, [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
          return number_json(value);
        } else {
          return value;
        }
      });
    }
    one["worst"] = {{"answer", number_json(row.worst.answer)},
                    {"distance", number_json(row.worst.distance)},
                    {"case", row.worst.json.empty() ? Json(nullptr) : Json::parse(row.worst.json)}};
    rows += fmt::format("{}{}", rows.empty() ? "\n" : ",\n", one.dump());
  }
  std::string text = out.dump();
  text.insert(text.size() - 1, fmt::format(",\n\"rows\":[{}\n]", rows));
  return text + "\n";
}

}  // namespace gjkscope::study
