// Proofs of an answer: bounds around the exact distance, no wider than rounding explains, and exact
// arithmetic where they leave the verdict open.

#include "gjk/proof/certificate.hpp"

#include "check.hpp"
#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace certificate_test {

using families::Family;
using families::Pair;
using gjk::Vec;
using gjk::Verdict;

constexpr std::uint64_t kSeed = 45;
constexpr float kFloatU = 0x1p-24f;
constexpr double kDoubleU = 0x1p-53;

template <class R>
gjk::Simplex<R, 2> simplex_of(const std::vector<Vec<R, 2>>& points) {
  gjk::Simplex<R, 2> simplex;
  for (const Vec<R, 2>& point : points) {
    simplex.vertices[simplex.count].w = point;
    simplex.vertices[simplex.count].pair = {0, simplex.count};
    simplex.weights[simplex.count] = R(1) / static_cast<R>(points.size());
    ++simplex.count;
  }
  return simplex;
}

template <class R>
struct Proved : gjk::Bounds<R> {
  bool tight = true;
};
/// The proved bounds of a run that `ended` by itself.
template <class R, class S>
Proved<R> proved(const gjk::State<R, 2>& state, const gjk::Query<S, 2>& query,
                 const gjk::Prepared<R, 2>& prepared, bool ended = true) {
  if (state.evidence.best.count == 3) {
    const bool inside = gjk::surely_inside(state.evidence.best, prepared);
    return {{R(0), R(0), inside ? R(0) : gjk::weights_bound<R, 2>(state.evidence.best, prepared)}};
  }
  gjk::Simplex<R, 2> simplex = state.evidence.best;
  gjk::OutsideBounds<R, S, 2> outside(state, query, prepared, simplex);
  const gjk::Bounds<R> bounds = outside.prove(ended);
  return {bounds, outside.is_tight()};
}

/// O against some points of Z = Y, and the state of a run that found them all.
template <class R>
struct Case {
  std::vector<Vec<R, 2>> x = {{R(0), R(0)}};
  std::vector<Vec<R, 2>> y;
  gjk::State<R, 2> state;

  Case(std::vector<Vec<R, 2>> points, int in_simplex) : y(std::move(points)) {
    state.evidence.best = simplex_of<R>({y.begin(), y.begin() + in_simplex});
  }
  [[nodiscard]] gjk::Query<R, 2> query() const { return {{x}, {y}}; }
  [[nodiscard]] gjk::Prepared<R, 2> prepared() const { return gjk::prepare<R>(query(), {}); }
  [[nodiscard]] Proved<R> bounds() const { return proved(state, query(), prepared()); }
};

TEST(inside, "O is surely inside when every area is larger than its rounding can be") {
  for (const double size : {1.0, 2.0}) {
    const gjk::Prepared<double, 2> exact_vertices;
    gjk::Prepared<double, 2> prepared;
    prepared.vertex_error = 100 * kDoubleU;
    // The area of O and the lower edge is 2 t size^2.
    const auto simplex = [&](double t) {
      return simplex_of<double>({{-size, -t * size}, {size, -t * size}, {0, size}});
    };
    const double least = 4 * 1.42 * 1.42 / 2 * kDoubleU;  // 4 u r^2 of an area of 2 t size^2
    CHECK(gjk::surely_inside(simplex(0.1), prepared));
    CHECK(gjk::surely_inside(simplex(1.01 * least), exact_vertices));
    CHECK(!gjk::surely_inside(simplex(0.99 * least), exact_vertices));
    const double least_in_doubt = least + 100 * 1.42 * kDoubleU / size;  // 2 r vertex_error
    CHECK(gjk::surely_inside(simplex(1.01 * least_in_doubt), prepared));
    CHECK(!gjk::surely_inside(simplex(0.99 * least_in_doubt), prepared));
    CHECK(!gjk::surely_inside(simplex(0.0), prepared));
    CHECK(!gjk::surely_inside(simplex(-0.1), prepared));
  }
}

TEST(at_origin, "weights put P at O when it is as close as two roundings of the vertices") {
  const double most = 4 * kDoubleU;
  const auto is_at_origin = [](const std::vector<Vec<double, 2>>& points) {
    const gjk::Simplex<double, 2> simplex = simplex_of<double>(points);
    return gjk::is_at_origin(simplex, simplex.weights, 2);
  };
  CHECK(is_at_origin({{-1, 2}, {1, -2}}));
  CHECK(is_at_origin({{-1, 2 + 2 * most}, {1, -2}}));
  CHECK(!is_at_origin({{-1, 2 + 4 * most}, {1, -2}}));
  CHECK(is_at_origin({{-2, 2 * most}, {2, 0}}));
  CHECK(!is_at_origin({{-2, 2.0001 * most}, {2, 0}}));
}

TEST(room,
     "in double exact products would have room from 2^-457 to 2^457 of the unit; under poses to "
     "2^-202; in long double nothing is too small or large") {
  const auto has_room = [](double number, int place, bool same_frame) {
    Pair<double> pair{{{1, 1}}, {{1, 1}, {2, 0}}};
    if (place < 2) pair.x[0][place] = std::ldexp(number, 7);
    if (place == 2 || place == 3) pair.y[1][place - 2] = std::ldexp(number, 7);
    if (place == 4) pair.x_pose.translation[0] = std::ldexp(number, 7);
    if (place == 5) pair.y_pose.translation[1] = std::ldexp(number, 7);
    if (place == 6) pair.x_pose.rotation = Eigen::Matrix2d{{1, number}, {0, 1}};
    if (place == 7) pair.y_pose.rotation = Eigen::Matrix2d{{number, 0}, {0, 1}};
    const bool in_wide = gjk::has_exact_products(pair.query(), same_frame, 7);
    constexpr bool kIsWide =
        std::numeric_limits<double>::max_exponent < std::numeric_limits<long double>::max_exponent;
    const bool in_double = gjk::has_exact_products<double>(pair.query(), same_frame, 7);
    CHECK(in_wide == (in_double || kIsWide));
    return in_double;
  };
  for (int place = 0; place < 8; ++place) {
    for (const bool same_frame : {true, false}) {
      const check::Context context("place", place, "same frame", same_frame);
      const int most = same_frame ? 457 : 202;
      CHECK(has_room(0, place, same_frame));
      for (const int sign : {1, -1}) {
        CHECK(has_room(sign * std::ldexp(1.0, -most), place, same_frame));
        CHECK(!has_room(sign * std::ldexp(0.99, -most), place, same_frame));
        CHECK(has_room(sign * std::ldexp(1.99, most), place, same_frame));
        CHECK(!has_room(sign * std::ldexp(2.0, most), place, same_frame));
      }
    }
  }
}

TEST(room_in_space, "in space products are of twice as many numbers") {
  const auto has_room = [](double number, bool turned) {
    const std::vector<Vec<double, 3>> x = {{1, 1, number}};
    gjk::Pose<double, 3> pose;
    if (turned) pose.rotation = Eigen::Matrix3d{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    const gjk::Query<double, 3> query{{x, pose}, {x}};
    return gjk::has_exact_products<double>(query, !turned, 0);
  };
  for (const bool turned : {false, true}) {
    const int most = turned ? 74 : 202;
    CHECK(has_room(std::ldexp(1.0, -most), turned) && has_room(std::ldexp(1.0, most), turned));
    CHECK(!has_room(std::ldexp(0.99, -most), turned) && !has_room(std::ldexp(2.0, most), turned));
  }
}

TEST(alone, "vertices are alone when no other lies less than the error nearer") {
  const Case<double> points({{0, 0}, {4, 0}, {4, 1}, {3, 7}}, 1);
  const auto alone = [&](int i, int j, double error) {
    const gjk::Query<double, 2> query = points.query();
    const auto prepared = points.prepared();
    gjk::Simplex<double, 2> simplex;
    simplex.count = 2;
    simplex.vertices[0].pair.y = i;
    simplex.vertices[1].pair.y = j;
    const gjk::Corners corners(simplex, &gjk::VertexPair::y);
    CHECK_EQ(i == j ? 1 : 2, corners.count);
    return gjk::are_alone(Vec<double, 2>(1, 0), query.y, prepared, prepared.y, corners, error);
  };
  CHECK(alone(1, 2, 0.0));
  CHECK(alone(1, 2, 0.99));
  CHECK(!alone(1, 2, 1.0));
  CHECK(!alone(1, 1, 0.0));
  CHECK(!alone(1, 3, 0.5));
  CHECK(!alone(3, 1, 0.5));
  CHECK(!alone(0, 1, 0.5));
}

TEST(full, "around O all bounds are 0, unless an area could be a rounding error") {
  const Case<double> sure({{-1, -1}, {1, -1}, {0, 1}}, 3);
  CHECK_EQ(0.0, sure.bounds().lower);
  CHECK_EQ(0.0, sure.bounds().distance);
  CHECK_EQ(0.0, sure.bounds().upper);
  CHECK(sure.bounds().tight);
  Case<double> unsure({{-1, 0}, {1, 0}, {0, 1}}, 3);
  unsure.state.evidence.best.weights = {0.5, 0.5, 0.0};
  CHECK_EQ(0.0, unsure.bounds().lower);
  CHECK_EQ(0.0, unsure.bounds().distance);
  CHECK_EQ(12 * kDoubleU, unsure.bounds().upper);
  CHECK(unsure.bounds().tight);
}

TEST(near_plane, "close to O a plane through the simplex proves more than that of the run") {
  const double height = 1e-4;
  const Case<double> edge({{-1, height}, {1, height}, {0, 2}}, 2);
  CHECK(edge.bounds().tight);
  CHECK_NEAR(height, edge.bounds().lower, 7 * kDoubleU * height);
  CHECK_NEAR(height, edge.bounds().upper, 7 * kDoubleU * height);
  const Case<double> below({{-1, -height}, {1, -height}, {0, -2}}, 2);
  CHECK(below.bounds().tight);
  CHECK_NEAR(height, below.bounds().lower, 7 * kDoubleU * height);
  const Case<double> vertex({{height, height}, {4, 5}}, 1);
  CHECK(vertex.bounds().tight);
  CHECK_NEAR(height * std::sqrt(2.0), vertex.bounds().lower, 10 * kDoubleU * height);
  // Another vertex as near, whose side of the edge rounding cannot tell.
  const Case<double> third({{-1, height}, {1, height}, {0, height}}, 2);
  CHECK(!third.bounds().tight);
  CHECK_EQ(0.0, third.bounds().lower);
  CHECK_NEAR(height, third.bounds().upper, 7 * kDoubleU * height);
}

TEST(far_edge, "far from a short edge the bounds along a trace hold, though |P|^2 rounds by more") {
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "edge", i);
    const double angle = random.between(0, 6.3);
    const Vec<double, 2> away(1000 * std::cos(angle), 1000 * std::sin(angle));
    const Vec<double, 2> along(-std::sin(angle), std::cos(angle));
    const std::vector<Vec<double, 2>> edge = {away - 0.3 * along, away + 0.4 * along};
    const std::vector<Vec<double, 2>> origin = {{0, 0}};
    const auto a = edge[0].cast<long double>().eval();
    const auto b = edge[1].cast<long double>().eval();
    const long double exact = std::abs(a[0] * b[1] - a[1] * b[0]) / (b - a).norm();
    for (const auto& step : gjk::trace(gjk::Query<double, 2>{{origin}, {edge}}).steps) {
      CHECK(static_cast<long double>(step.bounds.lower) <= exact);
      CHECK(exact <= static_cast<long double>(step.bounds.upper));
    }
  }
}

TEST(far_plane, "farther off the plane of the run is what proves the lower bound") {
  // Rounding cannot tell on which side of the edge the third vertex lies, so that the edge proves
  // nothing.
  Case<double> edge({{30, -1}, {30, 1}, {30, 0}}, 2);
  CHECK(!edge.bounds().tight);
  CHECK_EQ(0.0, edge.bounds().lower);
  edge.state.evidence.plane_distance_sq = 900;
  edge.state.evidence.plane_reach_sq = 901;
  CHECK(edge.bounds().tight);
  CHECK_NEAR(30.0, edge.bounds().lower, 8 * kDoubleU * 30);
  CHECK(edge.bounds().lower < 30.0 - 2 * kDoubleU * 30);
  CHECK_NEAR(30.0, edge.bounds().upper, 9 * kDoubleU * 30);
  CHECK(edge.bounds().upper > 30.0 + 2 * kDoubleU * 30);
}

TEST(beyond_end, "an upper bound is the distance of a point of the edge, not of its line") {
  for (int k = -40; k <= 16; ++k) {  // the foot lies so far beyond the end, in u times the edge
    for (const float height : {0x1p-24f, 0x1p-12f, 1.0f, 30.0f}) {
      const float beside = static_cast<float>(k) * 2 * kFloatU;
      Case<float> edge({{beside, height}, {beside + 2, height}, {beside + 1, 80}}, 2);
      const double exact = std::hypot(std::max(double{beside}, 0.0), double{height});
      const float weight = std::max(-beside / 2, 0.0f);
      for (const float rounding : {0.0f, kFloatU, 4 * kFloatU}) {
        const check::Context context("beside", k, "height", height, "rounding", rounding);
        edge.state.evidence.best.weights = {1 - (weight + rounding), weight + rounding, 0};
        const auto bounds = edge.bounds();
        CHECK(exact <= double{bounds.upper});
        CHECK(double{bounds.upper} <= exact + 64 * kFloatU * (1 + exact));
      }
    }
  }
}

/// An edge of Z as a run has it, and as its vertices are.
template <class R>
struct Rounded {
  std::vector<Vec<R, 2>> x = {{R(0), R(0)}};
  std::vector<Vec<R, 2>> y;
  gjk::State<R, 2> state;
  gjk::Prepared<R, 2> prepared;

  Rounded(const std::vector<Vec<R, 2>>& seen, std::vector<Vec<R, 2>> vertices, const R& reach)
      : y(std::move(vertices)) {
    state.evidence.best = simplex_of<R>(seen);
    prepared.reach = reach;
  }
  [[nodiscard]] Proved<R> bounds(bool ended) const {
    return proved(state, gjk::Query<R, 2>{{x}, {y}}, prepared, ended);
  }
};

TEST(edges, "the line of an edge whose ends have rounded lies as far as said") {
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> share(0, 1);
  double most_beside = 0;
  for (int i = 0; i < 400000; ++i) {
    const check::Context context("seed", kSeed, "edge", i);
    using Exact = Vec<double, 2>;
    // O lies across from some point between the ends.
    const double direction = 6.283185307179586 * share(random);
    const Exact across(std::cos(direction), std::sin(direction));
    const Exact along(-across[1], across[0]);
    const auto length = [&] { return std::exp2(-6 * share(random)); };
    const Exact foot = across * length();
    const Exact a = foot - along * length();
    const Exact b = foot + along * length();
    const std::vector<Vec<float, 2>> ends = {a.cast<float>(), b.cast<float>()};
    const Exact edge = b - a;
    const double exact = std::abs(a[0] * edge[1] - a[1] * edge[0]) / edge.norm();
    const auto bounds = Rounded<float>(ends, ends, 3.0f).bounds(false);
    const double error = double{bounds.upper} - double{bounds.distance};
    const double beside = std::abs(exact - double{bounds.distance});
    CHECK(beside <= error);
    most_beside = std::max(most_beside, beside / error);
  }
  std::printf("  beside up to %.2f of the bound\n", most_beside);
  CHECK(most_beside > 0.5);
}

TEST(anew,
     "a distance is computed anew close to O in one frame, and from an edge about as far as Z "
     "goes") {
  constexpr float kAnew = 1 + 0x1p-10f;
  const auto is_anew = [=](bool same_frame, bool on_edge, float reach) {
    const std::vector<Vec<float, 2>> seen = {{on_edge ? -1.0f : 0.0f, 1.0f}, {1.0f, 1.0f}};
    const std::vector<Vec<float, 2>> given = {{on_edge ? -1.0f : 0.0f, kAnew}, {1.0f, kAnew}};
    Rounded<float> rounded(seen, given, reach);
    rounded.state.evidence.best.count = on_edge ? 2 : 1;
    rounded.prepared.same_frame = same_frame;
    const float distance = rounded.bounds(false).distance;
    CHECK(distance == 1 || distance == kAnew);
    return distance == kAnew;
  };
  for (const bool same_frame : {false, true}) {
    CHECK(is_anew(same_frame, true, 1.9f));
    CHECK(!is_anew(same_frame, true, 2.1f));
    CHECK(!is_anew(same_frame, false, 1.9f));
    for (const bool on_edge : {false, true}) {
      CHECK(!is_anew(same_frame, on_edge, 15.9f));
      CHECK_EQ(same_frame, is_anew(same_frame, on_edge, 16.1f));
      CHECK(!is_anew(false, on_edge, 4095.0f));
      CHECK(is_anew(false, on_edge, 4097.0f));
    }
  }
}

TEST(near_width, "close to O, bounds are tight that are no wider than four times their error") {
  constexpr float kHeight = 0x1p-10f;
  const auto is_tight = [&](float roundings) {  // between the edge and the plane that was found
    const float plane = kHeight * (1 - roundings * kFloatU);
    // A third vertex on the edge, so that the edge itself proves nothing.
    Rounded<float> rounded({{-1, kHeight}, {1, kHeight}},
                           {{-1, kHeight}, {1, kHeight}, {0, kHeight}}, 1e6f);
    rounded.state.evidence.plane_distance_sq = plane * plane;
    return rounded.bounds(true).tight;
  };
  // The plane's own error takes 4 of 24 roundings, and the upper bound 6.
  CHECK(is_tight(0));
  CHECK(is_tight(12));
  CHECK(!is_tight(16));
}

template <int D>
using Wide = Vec<long double, D>;
template <int D>
struct PosedPair {
  std::vector<Vec<float, D>> x;
  std::vector<Vec<float, D>> y;
  gjk::Pose<float, D> x_pose;
  gjk::Pose<float, D> y_pose;

  explicit PosedPair(families::Source& random) {
    const auto anywhere = [&](double size) {
      Vec<float, D> out;
      for (int k = 0; k < D; ++k) out[k] = static_cast<float>(size * random.between(-1, 1));
      return out;
    };
    const double size_of_y = random.magnitude(1e-3, 1);
    for (int i = 0; i < D; ++i) x.push_back(anywhere(1));
    for (int i = 0; i < D; ++i) y.push_back(anywhere(size_of_y));
    x_pose.translation = anywhere(random.magnitude(0.1, 100));
    y_pose.translation = anywhere(1) + x_pose.translation;
    Eigen::Matrix<float, D, D> turn;
    for (int k = 0; k < D; ++k) turn.col(k) = anywhere(1);
    y_pose.rotation = turn;
  }
  [[nodiscard]] gjk::Query<float, D> query() const { return {{x, x_pose}, {y, y_pose}}; }
  [[nodiscard]] Wide<D> vertex(gjk::VertexPair at) const {
    const Wide<D> turned = y_pose.rotation.matrix().template cast<long double>() *
                           y[at.y].template cast<long double>();
    return (turned - x[at.x].template cast<long double>()) +
           (y_pose.translation.template cast<long double>() -
            x_pose.translation.template cast<long double>());
  }
};
/// Any face of Z; that of a triangle in space at least so far from flat.
template <int D>
gjk::Simplex<float, D> any_face(const PosedPair<D>& pair, families::Source& random) {
  gjk::Simplex<float, D> face;
  face.count = random.among(1, D);
  for (int i = 0; i < face.count; ++i) {
    face.vertices[i].pair = {random.among(0, D - 1), random.among(0, D - 1)};
    face.vertices[i].w = pair.vertex(face.vertices[i].pair).template cast<float>();
  }
  return face;
}
template <int D>
long double exact_distance(const PosedPair<D>& pair, const gjk::Simplex<float, D>& face) {
  gjk::Simplex<long double, D> wide;
  wide.count = face.count;
  for (int i = 0; i < face.count; ++i) wide.vertices[i].w = pair.vertex(face.vertices[i].pair);
  return gjk::foot_of<long double>(wide).distance;
}

template <int D>
void check_careful_distances() {
  families::Source random(kSeed);
  std::array<int, D + 1> faces = {};
  long double most = 0;
  for (int i = 0; i < 40000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const PosedPair<D> pair(random);
    const auto prepared = gjk::prepare<float>(pair.query(), {});
    const auto face = any_face(pair, random);
    const auto careful = gjk::careful_simplex(face, pair.query(), prepared);
    const auto foot = gjk::foot_of<float>(careful);
    const float flatness = face.count == 1 ? 0 : foot.longest / foot.height;
    if (!(foot.height > 0x1p-10f) || !(flatness < 1024)) continue;  // some are one point
    const long double exact = exact_distance<D>(pair, face);
    const long double bound = gjk::kCarefulRoundings * kFloatU * exact +
                              prepared.careful_error() * (1 + flatness + 1 / foot.height);
    CHECK_NEAR(exact, static_cast<long double>(foot.distance), bound);
    most = std::max(most, std::abs(exact - foot.distance) / bound);
    ++faces[face.count];
    // d is normal to the face, and points from there to O.
    const Vec<long double, D> d = foot.d.template cast<long double>();
    const Wide<D> a = pair.vertex(face.vertices[0].pair);
    CHECK_NEAR(-exact, a.dot(d) / d.norm(), 16 * kFloatU * a.norm() * (1 + flatness));
    for (int k = 1; k < face.count; ++k) {
      const Wide<D> edge = pair.vertex(face.vertices[k].pair) - a;
      CHECK_NEAR(0.0L, edge.dot(d) / d.norm(), 16 * kFloatU * edge.norm());
    }
  }
  std::printf("  error up to %.2Lf of its bound\n", most);
  CHECK(most > 0.25L);
  for (int count = 1; count <= D; ++count) CHECK(faces[count] > 5000);
}
TEST(careful, "a careful distance errs by no more than a few u of itself and the careful error") {
  check_careful_distances<2>();
  check_careful_distances<3>();
}

TEST(careful_weights, "weights of a thin simplex have nearly all digits, and add up to 1") {
  families::Source random(kSeed);
  int around_origin = 0;
  for (int i = 0; i < 5000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    const auto width = static_cast<float>(random.magnitude(1e-6, 1));
    const auto x = static_cast<float>(random.between(-1, 1));
    const auto y = static_cast<float>(random.between(-1, 1));
    Case<float> thin({{-x, -y}, {x + width, y}, {x, y + width}}, 3);
    const auto weights = gjk::weights_of<float>(
        gjk::careful_simplex(thin.state.evidence.best, thin.query(), thin.prepared()));
    std::array<long double, 3> parts;
    for (int k = 0; k < 3; ++k) {
      const Wide<2> b = thin.y[(k + 1) % 3].cast<long double>();
      const Wide<2> c = thin.y[(k + 2) % 3].cast<long double>();
      parts[k] = b[0] * c[1] - b[1] * c[0];
    }
    const long double sum = parts[0] + parts[1] + parts[2];
    if (std::min({parts[0] / sum, parts[1] / sum, parts[2] / sum}) < 0) continue;
    ++around_origin;
    for (int k = 0; k < 3; ++k) {
      CHECK_NEAR(parts[k] / sum, static_cast<long double>(weights[k]), 8.0L * kFloatU);
    }
  }
  CHECK(around_origin > 1000);
}

TEST(witnesses,
     "witness points are means of vertices by weights, moved by the poses; shapes that meet share "
     "one, a vertex where it can be") {
  Pair<double> pair{{{0, 0}, {4, 0}}, {{1, 1}, {5, 9}, {9, 1}}};
  gjk::Result<double, 2> out;
  out.simplex.count = 3;
  out.simplex.weights = {0.25, 0.5, 0.25};
  const auto pairs = [&](std::array<gjk::VertexPair, 3> wanted) {
    for (int i = 0; i < 3; ++i) out.simplex.vertices[i].pair = wanted[i];
  };
  pairs({{{0, 0}, {1, 1}, {1, 2}}});
  const auto set = [&] {
    gjk::set_witness_points(out, pair.query(), gjk::prepare<double>(pair.query(), {}));
  };
  set();
  CHECK((out.x == Vec<double, 2>(3, 0)));
  CHECK((out.y == Vec<double, 2>(5, 5)));
  for (const Verdict verdict : {Verdict::touching, Verdict::overlapping}) {
    out.verdict = verdict;
    set();
    CHECK((out.x == Vec<double, 2>(4, 2.5)));
    CHECK((out.y == Vec<double, 2>(4, 2.5)));
  }
  pairs({{{1, 0}, {1, 1}, {1, 2}}});
  set();
  CHECK((out.x == Vec<double, 2>(4, 0)));
  CHECK((out.y == Vec<double, 2>(4, 0)));
  pairs({{{0, 1}, {1, 1}, {1, 1}}});
  set();
  CHECK((out.x == Vec<double, 2>(5, 9)));
  CHECK((out.y == Vec<double, 2>(5, 9)));
  pairs({{{0, 0}, {1, 1}, {1, 2}}});
  out.verdict = Verdict::separated;
  pair.x_pose.rotation = Eigen::Matrix2d{{0, -1}, {1, 0}};
  pair.y_pose.translation = {0, 100};
  set();
  CHECK((out.x == Vec<double, 2>(0, 3)));
  CHECK((out.y == Vec<double, 2>(5, 105)));
}

TEST(denormal_gaps, "bounds hold where exact arithmetic settles a distance that is denormal") {
  std::mt19937_64 random(kSeed);
  const auto among = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  int settled = 0;
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    constexpr float kLeast = std::numeric_limits<float>::denorm_min();
    const auto place = [&](int low, int high) {
      return Vec<float, 2>(static_cast<float>(among(-1000, 1000)) / 1000,
                           static_cast<float>(among(low, high)) * kLeast);
    };
    const Pair<float> pair{{place(1, 9)}, {place(-9, 0), place(-9, 0), place(-9, 0)}};
    const auto result = gjk::distance<float>(pair.query());
    if (!result.settled || result.verdict != Verdict::separated) continue;
    if (std::numeric_limits<float>::min() <= result.distance) continue;
    ++settled;
    const auto exact = gjk::distance<long double>(families::converted<long double>(pair).query());
    CHECK(static_cast<long double>(result.lower) <= exact.upper);
    CHECK(exact.lower <= static_cast<long double>(result.upper));
    CHECK(result.lower <= result.distance && result.distance <= result.upper);
    CHECK(gjk::norm_max(Vec<float, 2>(result.y - result.x)) <= 4 * kFloatU);
  }
  CHECK(settled > 1000);
}

TEST(short_edge,
     "exact weights have all their digits on an edge whose length float cannot square") {
  constexpr float kHalf = 0x1p-80f;
  const std::vector<Vec<float, 2>> x = {{-kHalf, 0}, {kHalf, 0}, {0, -1}};
  const std::vector<Vec<float, 2>> y = {{kHalf / 2, 0}};
  const auto result = gjk::distance<float>(gjk::Query<float, 2>{{x}, {y}});
  CHECK(result.settled);
  CHECK(result.verdict == Verdict::touching);
  CHECK_EQ(2, result.simplex.count);
  for (int i = 0; i < 2; ++i) {
    CHECK_EQ(result.simplex.vertices[i].pair.x == 0 ? 0.25f : 0.75f, result.simplex.weights[i]);
  }
}

TEST(tolerance, "bounds as close as the tolerance asks are not settled") {
  families::Source random(kSeed);
  gjk::Options options;
  options.tolerance = 0.25;
  int within = 0;
  for (int i = 0; i < 5000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const auto pair = random.pair<double>(Family::clouds);
    const auto result = gjk::distance(pair.query(), options);
    if (result.stop != gjk::StopReason::within_tolerance) continue;
    CHECK(!result.settled);
    CHECK(result.upper - result.lower <= 0.25 * result.upper);
    within += 0.01 * result.upper < result.upper - result.lower ? 1 : 0;
  }
  CHECK(within > 100);
}

TEST(space, "in space the distance is that of the nearest point found, within its bounds") {
  const std::vector<Vec<double, 3>> x = {{0, 0, 0}};
  const std::vector<Vec<double, 3>> y = {{-1, 3, 4}, {1, 3, 4}, {0, 6, 8}};
  const auto result = gjk::distance(gjk::Query<double, 3>{{x}, {y}});
  CHECK_EQ(5.0, result.distance);
  CHECK(result.lower < 5 && 5 < result.upper);
}

}  // namespace certificate_test
