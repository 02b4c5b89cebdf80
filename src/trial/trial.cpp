#include "trial/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "depth/instances.hpp"
#include "lesson/json_place.hpp"
#include "study/families.hpp"

namespace gjkscope::judging {
namespace {

using families::Family;
using families::Pair;
using json = nlohmann::ordered_json;

/// Relative errors beyond these count.
constexpr double kFloatLimit = 1e-3;
constexpr double kDoubleLimit = 1e-9;

constexpr double kFloatUnit = 0x1p-24;
constexpr double kDoubleUnit = 0x1p-53;

/// The smallest positive number of the scalar whose unit roundoff is that.
constexpr double smallest_of(double unit) { return unit == kFloatUnit ? 0x1p-149 : 0x1p-1074; }

constexpr std::string_view kLetters = ".mirpdngxsc";

/// A pair that stands in the world, and the truth about it.
template <int D>
struct Asked {
  Pair<double, D> pair;
  bool overlap = false;
  bool touching = false;
  double distance = 0;
  double scale = 0;
};

template <int D>
Asked<D> asked(Pair<double, D> pair) {
  Asked<D> out;
  const gjk::Result<double, D> truth = gjk::distance(pair.query());
  out.touching = truth.verdict == gjk::Verdict::touching;
  out.overlap = out.touching || truth.verdict == gjk::Verdict::overlapping;
  out.distance = truth.distance;
  out.scale = families::scale_of(pair);
  out.pair = std::move(pair);
  return out;
}

template <int D>
std::string text_of(const Pair<double, D>& pair) {
  std::string out = fmt::format("{{\"dimension\":{}", D);
  for (const auto& [key, points] : {std::pair{"a", &pair.x}, std::pair{"b", &pair.y}}) {
    out += fmt::format(",\"{}\":[", key);
    for (std::size_t i = 0; i < points->size(); ++i) {
      out += i == 0 ? "[" : ",[";
      for (int k = 0; k < D; ++k) out += fmt::format("{}{}", k == 0 ? "" : ",", (*points)[i][k]);
      out += ']';
    }
    out += ']';
  }
  return out + '}';
}

template <int D>
Pair<double, D> in_world(const Pair<double, D>& pair, bool floats) {
  Pair<double, D> out;
  for (const auto& p : pair.x) out.x.push_back(pair.x_pose.rotated(p) + pair.x_pose.translation);
  for (const auto& p : pair.y) out.y.push_back(pair.y_pose.rotated(p) + pair.y_pose.translation);
  return floats ? families::rounded_to_floats(out) : out;
}

/// NaN and infinity are no JSON, but what some writers of JSON print.
std::string quoted(std::string line) {
  for (const std::string_view word : {"-Infinity", "Infinity", "NaN", "nan", "-inf", "inf"}) {
    for (std::size_t at = 0; (at = line.find(word, at)) != std::string::npos;) {
      const auto letter = [&](std::size_t i) {
        return i < line.size() && (std::isalpha(static_cast<unsigned char>(line[i])) != 0 ||
                                   line[i] == '"' || line[i] == '-');
      };
      if ((at == 0 || !letter(at - 1)) && !letter(at + word.size())) {
        line.insert(at + word.size(), "\"");
        line.insert(at, "\"");
        at += 2;
      }
      at += word.size();
    }
  }
  return line;
}

json parsed(const std::string& line) {
  json value = json::parse(line, nullptr, false);
  if (value.is_discarded()) value = json::parse(quoted(line), nullptr, false);
  return value;
}

/// The coordinates of a point; NaNs stand for those that are no numbers.
template <int D>
std::optional<gjk::Vec<double, D>> point_of(const json& value) {
  if (!value.is_array() || value.size() != D) return std::nullopt;
  gjk::Vec<double, D> out;
  for (std::size_t k = 0; k < D; ++k)
    out[static_cast<int>(k)] =
        number_in(value[k]).value_or(std::numeric_limits<double>::quiet_NaN());
  return out;
}

/// Whether the closest points are as far apart as the shapes, if the answer has both.
template <int D>
bool points_fit(const json& answer, const Asked<D>& one, double limit, double unit) {
  gjk::Vec<double, D> between = gjk::Vec<double, D>::Zero();
  for (const auto& [key, sign] : {std::pair{"a", -1.0}, std::pair{"b", 1.0}}) {
    const auto point = answer.find(key);
    if (point == answer.end() || point->is_null()) return true;
    const auto at = point_of<D>(*point);
    if (!at) return false;
    between += sign * *at;
  }
  double largest = one.scale;  // points far from the world's origin stand on a coarse grid
  for (const auto* shape : {&one.pair.x, &one.pair.y}) {
    for (const auto& p : *shape) largest = std::max(largest, p.stableNorm());
  }
  return std::abs(between.stableNorm() - one.distance) <=
         limit * one.distance + 16 * unit * largest;
}

/// Whether `depth` and `translation` are right, if the answer has them.
template <int D>
bool depth_fits(const json& answer, const Asked<D>& one, double limit, double unit) {
  const auto given = [&](const char* key) {
    const auto found = answer.find(key);
    return found == answer.end() || found->is_null() ? nullptr : &*found;
  };
  const json* depth = given("depth");
  const json* translation = given("translation");
  if (depth == nullptr && translation == nullptr) return true;
  const double rounding = 16 * (unit * one.scale + smallest_of(unit));
  std::optional<double> number;
  if (depth != nullptr) {
    number = number_in(*depth);
    if (!number) return false;
    // Some programs answer a distance with the other sign.
    if (!one.overlap) return *number <= rounding;
  }
  if (!one.overlap) return true;
  const auto truth = depth::penetration<double>(one.pair.query());
  if (!std::isfinite(truth.upper)) return true;
  const double allowed = limit * truth.depth + rounding;
  const auto fits = [&](double length) {
    return truth.lower - allowed <= length && length <= truth.upper + allowed;
  };
  if (number && !fits(*number)) return false;
  if (translation == nullptr) return true;
  const auto t = point_of<D>(*translation);
  if (!t || !fits(t->stableNorm())) return false;
  Pair<double, D> moved = one.pair;
  moved.x_pose.translation += *t;
  return !(allowed < depth::penetration<double>(moved.query()).lower);
}

template <int D>
Fault fault_of(const Reply& reply, const Asked<D>& one, bool in_float, double* worst = nullptr) {
  switch (reply.kind) {
    case Reply::Kind::not_asked:
      return Fault::none;
    case Reply::Kind::silent:
      return Fault::silent;
    case Reply::Kind::crashed:
      return Fault::crashed;
    case Reply::Kind::answered:
      break;
  }
  json answer = parsed(reply.line);
  if (answer.is_number()) answer = json{{"distance", answer}};
  if (!answer.is_object()) return Fault::nonsense;
  const auto given = answer.find("distance");
  const auto overlap = answer.find("overlap");
  const bool tells_overlap = overlap != answer.end() && overlap->is_boolean();
  const bool tells_distance = given != answer.end() && !given->is_null();
  if (!tells_distance && !tells_overlap) {
    if (answer.contains("error")) return Fault::gave_up;
    return given != answer.end() ? Fault::not_finite : Fault::nonsense;
  }
  const double unit = in_float ? kFloatUnit : kDoubleUnit;
  const double limit = in_float ? kFloatLimit : kDoubleLimit;
  if (tells_overlap && !overlap->get<bool>() && one.overlap && !one.touching && !tells_distance)
    return Fault::missed;
  if (tells_overlap && overlap->get<bool>() && !one.overlap) {
    // Closer than its numbers tell apart.
    if (!(one.distance <= 4 * unit * one.scale)) return Fault::invented;
  }
  const Fault of_depth = depth_fits(answer, one, limit, unit) ? Fault::none : Fault::depth;
  if (!tells_distance) return of_depth;
  const std::optional<double> number = number_in(*given);
  if (!number) return Fault::nonsense;
  const double distance = *number;
  if (!std::isfinite(distance)) return Fault::not_finite;
  if (one.overlap) return distance > 4 * unit * one.scale ? Fault::missed : of_depth;
  if (std::abs(distance - one.distance) <= smallest_of(unit)) return of_depth;
  if (distance <= 0) return Fault::invented;
  const double relative = std::abs(distance - one.distance) / one.distance;
  if (worst != nullptr) *worst = std::max(*worst, relative);
  if (relative > limit) return Fault::inaccurate;
  return points_fit(answer, one, limit, unit) ? of_depth : Fault::points;
}

/// Takes vertices away and rounds numbers while the program fails in the same way.
template <int D>
class Reduction {
 public:
  Reduction(const TrialOptions& options, Asked<D> from, Fault fault)
      : options_(options), patience_(options.patience), best_(std::move(from)), fault_(fault) {
    patience_.is_loud = false;
  }

  Asked<D> reduced() {
    if (fault_ == Fault::silent) return best_;  // each try would take all patience
    while (rounds_ < kMostRounds && (fewer_vertices() || rounder())) {
    }
    return best_;
  }

 private:
  static constexpr int kMostRounds = 100;

  bool fewer_vertices() {
    std::vector<Pair<double, D>> tries;
    for (const bool of_x : {true, false}) {
      const auto& points = of_x ? best_.pair.x : best_.pair.y;
      for (std::size_t i = 0; i < points.size() && points.size() > 1; ++i) {
        Pair<double, D> next = best_.pair;
        auto& fewer = of_x ? next.x : next.y;
        fewer.erase(fewer.begin() + static_cast<long>(i));
        tries.push_back(std::move(next));
      }
    }
    return take(std::move(tries));
  }
  /// All numbers to few digits; then one by one.
  bool rounder() {
    std::vector<Pair<double, D>> tries;
    const auto add = [&](Pair<double, D> next) {
      if (next.x != best_.pair.x || next.y != best_.pair.y) tries.push_back(std::move(next));
    };
    const auto digits = [](double value, int count) {
      return std::strtod(fmt::format("{:.{}g}", value, count).c_str(), nullptr);
    };
    for (const int count : {1, 2, 3, 5, 8, 12}) {
      Pair<double, D> next = best_.pair;
      for (auto* points : {&next.x, &next.y}) {
        for (auto& p : *points) {
          for (double& c : p) c = digits(c, count);
        }
      }
      add(std::move(next));
    }
    for (const bool of_x : {true, false}) {
      const std::size_t size = (of_x ? best_.pair.x : best_.pair.y).size();
      for (std::size_t i = 0; i < size; ++i) {
        for (int k = 0; k < D; ++k) {
          for (const int count : {0, 1, 2, 4}) {
            Pair<double, D> next = best_.pair;
            double& c = (of_x ? next.x : next.y)[i][k];
            const double to = count == 0 ? 0 : digits(c, count);
            if (fmt::format("{}", to).size() >= fmt::format("{}", c).size()) continue;
            c = to;
            add(std::move(next));
          }
        }
      }
    }
    return take(std::move(tries));
  }

  /// The first of them on which the program fails alike.
  bool take(std::vector<Pair<double, D>> tries) {
    if (tries.empty()) return false;
    ++rounds_;
    std::vector<std::string> texts;
    for (auto& pair : tries) {
      if (options_.in_float) pair = families::rounded_to_floats(pair);
      texts.push_back(text_of(pair));
    }
    const std::vector<Reply> replies = ask(options_.command, texts, patience_);
    for (std::size_t i = 0; i < tries.size(); ++i) {
      if (replies[i].kind == Reply::Kind::not_asked) continue;
      if (tries[i].x == best_.pair.x && tries[i].y == best_.pair.y) continue;
      Asked<D> one = asked(std::move(tries[i]));
      if (fault_of(replies[i], one, options_.in_float) != fault_) continue;
      best_ = std::move(one);
      return true;
    }
    return false;
  }

  const TrialOptions& options_;
  Patience patience_;
  Asked<D> best_;
  Fault fault_;
  int rounds_ = 0;
};

template <int D>
FamilyTrial trial_of(Family family, const TrialOptions& options, std::string& last) {
  FamilyTrial out;
  out.family = families::kFamilyNames[static_cast<std::size_t>(family)];
  out.dimension = D;
  families::Source random(options.seed + static_cast<std::uint64_t>(family));
  std::vector<Asked<D>> cases;
  std::vector<std::string> texts;
  for (int i = 0; i < options.pairs; ++i) {
    const auto as = options.in_float ? families::Representation::float_values
                                     : families::Representation::full_doubles;
    Pair<double, D> pair = in_world(random.pair<double, D>(family, as), options.in_float);
    texts.push_back(text_of(pair));
    cases.push_back(asked(std::move(pair)));
  }
  const std::vector<Reply> replies = ask(options.command, texts, options.patience);
  std::optional<std::size_t> smallest;
  const auto size = [&](std::size_t i) { return cases[i].pair.x.size() + cases[i].pair.y.size(); };
  Fault of_smallest = Fault::none;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (replies[i].kind == Reply::Kind::not_asked) continue;
    ++out.asked;
    const Fault fault = fault_of(replies[i], cases[i], options.in_float, &out.worst);
    ++out.faults[static_cast<std::size_t>(fault)];
    if (replies[i].kind == Reply::Kind::crashed) last = replies[i].line;
    if (fault == Fault::none || (smallest && size(*smallest) <= size(i))) continue;
    smallest = i;
    of_smallest = fault;
  }
  if (!smallest || !options.reduces) return out;
  const bool is_heard = std::any_of(replies.begin(), replies.end(), [](const Reply& reply) {
    return reply.kind == Reply::Kind::answered;
  });
  if (!is_heard) return out;
  const Asked<D> reduced = Reduction<D>(options, cases[*smallest], of_smallest).reduced();
  Patience quiet = options.patience;
  quiet.is_loud = false;
  FailingCase& failing = out.smallest.emplace();
  failing.fault = of_smallest;
  failing.text = text_of(reduced.pair);
  failing.distance = reduced.distance;
  if (of_smallest == Fault::depth && reduced.overlap)
    failing.depth = depth::penetration<double>(reduced.pair.query()).depth;
  failing.answer = of_smallest == Fault::silent
                       ? "silence"
                       : ask(options.command, {failing.text}, quiet).front().line;
  return out;
}

}  // namespace

std::string try_program(const TrialOptions& options,
                        const std::function<void(const FamilyTrial&)>& each) {
  bool has_asked = false;
  for (const int dimension : {2, 3}) {
    if (options.dimension != 0 && options.dimension != dimension) continue;
    const int count = dimension == 2 ? families::kFamilyCount : families::kSpaceFamilyCount;
    for (int i = 0; i < count; ++i) {
      const std::string name(families::kFamilyNames[i]);
      const auto& wanted = options.families;
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end())
        continue;
      has_asked = true;
      std::string last;
      const auto family = static_cast<Family>(i);
      const FamilyTrial trial =
          dimension == 2 ? trial_of<2>(family, options, last) : trial_of<3>(family, options, last);
      each(trial);
      const int unanswered = trial.faults[static_cast<std::size_t>(Fault::silent)] +
                             trial.faults[static_cast<std::size_t>(Fault::crashed)];
      if (unanswered == trial.asked)
        return last.empty() ? "the program answers nothing"
                            : fmt::format("the program answers nothing: it {}", last);
    }
  }
  return has_asked
             ? ""
             : fmt::format("no family that was named has pairs of dimension {}", options.dimension);
}

std::string faults_text(const FamilyTrial& trial) {
  std::string out;
  for (std::size_t i = 1; i < trial.faults.size(); ++i) {
    if (trial.faults[i] > 0)
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", trial.faults[i], kLetters[i]);
  }
  return out.empty() ? "." : out;
}

std::vector<std::string> family_names() {
  return {families::kFamilyNames.begin(), families::kFamilyNames.end()};
}

}  // namespace gjkscope::judging
