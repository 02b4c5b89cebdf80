#include "picture/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "gjk/regions.hpp"
#include "lesson/names.hpp"

namespace gjkscope {
namespace {

constexpr std::string_view kMinus = "−";

/// From here on numbers have a power of ten.
constexpr double kLarge = 1e5;

constexpr std::string_view kTimesTen = "·10";
constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::string_view kRaisedMinus = "⁻";

/// As it is printed: "-2.5e-09" is "−2.5·10⁻⁹".
std::string printed(std::string digits) {
  std::string power;
  if (const std::size_t e = digits.find('e'); e != std::string::npos) {
    power = std::string(kTimesTen) + raised(std::stoi(digits.substr(e + 1)));
    digits.resize(e);
  }
  if (digits.starts_with('-')) digits.replace(0, 1, kMinus);
  return digits + power;
}

bool is_all_zero(const std::string& digits) {
  return digits.find_first_of("123456789") == std::string::npos;
}

}  // namespace

std::string significant(double value, int digits) {
  if (value == 0.0) return "0";
  return printed(fmt::format("{:.{}g}", value, digits));
}

std::string fixed(double value, int decimals) {
  std::string digits = fmt::format("{:.{}f}", value, decimals);
  if (digits.front() == '-' && is_all_zero(digits)) digits.erase(0, 1);
  return printed(digits);
}

std::string signed_fixed(double value, int decimals) {
  std::string digits = fixed(value, decimals);
  const bool positive = value > 0.0 && !is_all_zero(digits);
  return positive ? "+" + digits : digits;
}

namespace {

/// The value of a text that `fixed` or a `Numbers` has written.
double as_written(std::string_view text) {
  std::string digits;
  const auto take = [&](std::string_view printed, std::string_view read) {
    if (!text.starts_with(printed)) return false;
    digits += read;
    text.remove_prefix(printed.size());
    return true;
  };
  while (!text.empty()) {
    if (take(kMinus, "-") || take(kRaisedMinus, "-") || take(kTimesTen, "e")) continue;
    bool is_raised = false;
    for (std::size_t i = 0; i < kRaised.size() && !is_raised; ++i)
      is_raised = take(kRaised[i], std::to_string(i));
    if (!is_raised) take(text.substr(0, 1), text.substr(0, 1));
  }
  return std::stod(digits);
}

}  // namespace

bool adds_up(const std::vector<std::string>& terms, const std::string& sum) {
  double rest = -as_written(sum);
  double size = std::abs(rest);
  for (const std::string& term : terms) {
    rest += as_written(term);
    size = std::max(size, std::abs(as_written(term)));
  }
  constexpr double kOfDecimals = 1e-12;  // how far binary numbers are from those that are written
  return std::abs(rest) <= kOfDecimals * size;
}

std::string difference_as_written(const std::string& from, const std::string& minus,
                                  const std::string& difference) {
  return fmt::format("{} − {} = {}{}", from, minus, difference,
                     adds_up({minus, difference}, from) ? "" : " up to rounding");
}

std::string raised(int exponent) {
  std::string out(exponent < 0 ? kRaisedMinus : "");
  for (const char digit : std::to_string(std::abs(exponent))) out += kRaised[digit - '0'];
  return out;
}

std::string power_text(double value, int digits) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 0.01 && size < 1000.0) return fmt::format("{:.{}g}", value, digits);
  return printed(fmt::format("{:.{}e}", value, digits - 1));
}

std::string grouped(double value) {
  std::string digits = fixed(value, 0);
  const std::size_t begin = digits.find_first_of("0123456789");
  for (std::size_t at = digits.size(); at > begin + 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string and_list(std::vector<std::string> names) {
  constexpr std::size_t kMost = 6;  // that a sentence can take
  if (names.size() > kMost) {
    const std::size_t rest = names.size() - (kMost - 2);
    names.resize(kMost - 2);
    names.push_back(fmt::format("{} more", rest));
  }
  const std::string last = names.back();
  names.pop_back();
  return names.empty() ? last : fmt::format("{} and {}", fmt::join(names, ", "), last);
}

std::string listed_choices(const std::vector<std::string>& choices) {
  return fmt::format("{}", fmt::join(choices, "  ·  "));
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

std::string Numbers::operator()(double value) const {
  if (scalar_ == ScalarKind::single) return significant(value, 8);
  if (scalar_ == ScalarKind::half) return significant(value, 5);
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-3 || size >= kLarge)) return printed(fmt::format("{:.3e}", value));
  return fixed(value, 3);
}

std::string Numbers::point_text(const Eigen::Vector3d& value, int decimals) const {
  const auto listed = [&](const auto& text) {
    std::vector<std::string> numbers;
    for (int i = 0; i < dimension_; ++i) numbers.push_back(text(value[i]));
    return fmt::format("({})", fmt::join(numbers, ", "));
  };
  if (scalar_ == ScalarKind::single || scalar_ == ScalarKind::half) return listed(*this);
  // A point that would be zeros alone, or digits without end, has a power of ten of its own.
  const double size = value.head(dimension_).cwiseAbs().maxCoeff();
  const bool is_ordinary = size == 0.0 || (size >= std::pow(0.1, decimals) && size < kLarge);
  const int exponent = is_ordinary ? 0 : static_cast<int>(std::floor(std::log10(size)));
  const double unit = is_ordinary ? 1.0 : std::pow(10.0, -exponent);
  return listed([&](double number) { return fixed(number * unit, decimals); }) +
         (is_ordinary ? "" : std::string(kTimesTen) + raised(exponent));
}

std::string Numbers::weight(double value) const {
  const bool digits_matter = scalar_ == ScalarKind::single || scalar_ == ScalarKind::half;
  if (digits_matter) return (*this)(value);
  const std::string text = fixed(value, 3);
  return value != 0.0 && is_all_zero(text) ? power_text(value, 2) : text;
}

SimplexWords::SimplexWords(const LessonRun& run, const WideSimplex& simplex)
    : run_(run), simplex_(simplex) {
  cyclic_ = run.point_query() && simplex.count == static_cast<int>(run.lesson.y().vertices.size());
  for (int i = 0; i < simplex.count; ++i) cyclic_ = cyclic_ && simplex.vertices[i].pair.y == i;
}

std::string SimplexWords::vertex(int i) const { return run_.pair_name(simplex_.vertices[i].pair); }

std::vector<int> SimplexWords::order(gjk::Face face) const {
  std::vector<int> out;
  for (int i = 0; i < simplex_.count; ++i) {
    if (gjk::contains(face, i)) out.push_back(i);
  }
  const auto of_y = [&](int i) { return simplex_.vertices[i].pair.y; };
  if (run_.point_query() && run_.lesson.y().vertices.size() == 3) {
    // The last edge of the triangle ABC is CA, as on the slides, whatever else is in the simplex.
    std::sort(out.begin(), out.end(), [&](int a, int b) { return of_y(a) < of_y(b); });
    if (out.size() == 2 && of_y(out[0]) == 0 && of_y(out[1]) == 2) std::swap(out[0], out[1]);
    return out;
  }
  if (cyclic_) return out;
  // A lesson that starts with the edge DC has reasons not to call it CD.
  const WideSimplex& initial = run_.runs.front().trace.initial.simplex;
  const auto place = [&](int i) {
    const auto* end = initial.vertices.data() + initial.count;
    return std::find_if(
               initial.vertices.data(), end,
               [&](const auto& other) { return other.pair == simplex_.vertices[i].pair; }) -
           initial.vertices.data();
  };
  const bool of_start =
      out.size() == 2 && place(out[0]) < initial.count && place(out[1]) < initial.count;
  std::sort(out.begin(), out.end(),
            [&](int a, int b) { return of_start ? place(a) < place(b) : vertex(a) < vertex(b); });
  return out;
}

std::string SimplexWords::face(gjk::Face face) const {
  std::string out;
  for (const int i : order(face)) {
    if (!run_.point_query() && !out.empty()) out += ", ";
    out += vertex(i);
  }
  return out;
}

std::string SimplexWords::kind_and_face(gjk::Face face) const {
  const int size = gjk::vertex_count(face);
  const std::string_view kind = size == 1                ? "vertex"
                                : size == 4              ? "tetrahedron"
                                : size == 3              ? "triangle"
                                : simplex_.count == size ? "segment"
                                                         : "edge";
  if (size == 2 && !run_.point_query()) {
    return fmt::format("{} from {} to {}", kind, vertex(order(face)[0]), vertex(order(face)[1]));
  }
  return fmt::format("{} {}", kind, this->face(face));
}

std::string SimplexWords::coordinate(gjk::Face face, int vertex) const {
  if (!run_.point_query()) return "weight of " + this->vertex(vertex);
  const std::vector<int> named = order(face);
  const auto position = std::find(named.begin(), named.end(), vertex) - named.begin();
  std::string out(1, "uvwt"[position]);
  if (simplex_.count > 2) out += this->face(face);
  return out;
}

std::vector<gjk::RegionTerm<double>> SimplexWords::terms(
    const gjk::RegionTest<double>& test) const {
  std::vector<gjk::RegionTerm<double>> out = test.terms;
  const gjk::FaceList order = gjk::tested_faces(simplex_.count, gjk::RegionOrder::vertices_first);
  const auto place = [&](const gjk::RegionTerm<double>& term) {
    int i = 0;
    while (order[i] != term.face) ++i;
    const std::vector<int> named = this->order(term.face);
    return std::pair(i, std::find(named.begin(), named.end(), term.vertex) - named.begin());
  };
  std::stable_sort(out.begin(), out.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return out;
}

std::string SimplexWords::combination(gjk::Face face, const Numbers& numbers) const {
  std::string out;
  for (const int i : order(face)) {
    if (!out.empty()) out += " + ";
    if (gjk::vertex_count(face) > 1) out += numbers.weight(simplex_.weights[i]) + " ";
    const bool plain = run_.point_query() || gjk::vertex_count(face) == 1;
    out += plain ? vertex(i) : fmt::format("({})", vertex(i));
  }
  return out;
}

std::string feature_name(const LessonRun& run, const WideSimplex& simplex, bool of_x) {
  std::set<int> indices;
  for (int i = 0; i < simplex.count; ++i) {
    const gjk::VertexPair pair = simplex.vertices[i].pair;
    indices.insert(of_x ? pair.x : pair.y);
  }
  constexpr std::array<std::string_view, 5> kKinds = {"nothing", "vertex", "edge", "triangle",
                                                      "tetrahedron"};
  std::string out(kKinds[indices.size()]);
  out += ' ';
  for (const int i : indices) out += (of_x ? run.lesson.x() : run.lesson.y()).vertex_names[i];
  return out;
}

std::string stop_test(const LessonRun& run, const Frame& frame) {
  const gjk::StopReason stop = run.state(frame).stop;
  switch (stop) {
    case gjk::StopReason::running:
      return "no";
    case gjk::StopReason::repeated_support:
      return "V in S";
    case gjk::StopReason::not_nearer:
      return "P no closer";
    case gjk::StopReason::no_progress:
      return "V not in S, no farther";
    case gjk::StopReason::origin_inside:
      return query_name(run) + " inside S";
    case gjk::StopReason::zero_direction:
      return "d = 0";
    default:
      return std::string(name_of(stop));
  }
}

std::vector<std::string> stop_tests(const LessonRun& run) {
  return {"V in S", "V not in S, no farther", "P no closer", query_name(run) + " inside S",
          "d = 0"};
}

std::string query_name(const LessonRun& run) {
  return run.point_query() ? run.lesson.x().vertex_names[0] : "O";
}

}  // namespace gjkscope
