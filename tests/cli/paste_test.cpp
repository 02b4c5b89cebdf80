#include "lesson/paste.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sstream>

#include "cli/commands.hpp"
#include "command_line.hpp"
#include "lesson/case.hpp"

namespace gjkscope {
namespace paste_test {

using nlohmann::json;

ReadCase read(const std::string& text,
              std::optional<models::Needs> needs = models::Needs::segments) {
  const std::vector<ReadCase> cases = parse_cases(text, "f", 3, needs);
  EXPECT_EQ(1u, cases.size()) << text;
  return cases.front();
}

std::string problem_of(const std::string& text) {
  const ReadCase found = read(text);
  EXPECT_EQ("", found.understood);
  return found.problems.empty() ? "" : to_string(found.problems.front());
}

json solved(const std::string& text) {
  std::istringstream in(text);
  std::ostringstream out;
  std::ostringstream err;
  (void)solve_command({GJKSCOPE_SOURCE_DIR, in, out, err}, {"-"}, {});
  return json::parse(out.str());
}

struct Report {
  std::string name;
  std::string text;
  std::string understood;
};

/// Shapes in the form in which people report them.
const std::vector<Report> kReports = {
    {"Box2D 2.4", R"(b2Vec2 va[4];
va[0].Set(-0.5f, -0.5f);
va[1].Set(0.5f, -0.5f);
va[2].Set(0.5f, 0.5f);
va[3].Set(-0.5f, 0.5f);
b2PolygonShape shapeA;
shapeA.Set(va, 4);

b2Vec2 vb[3];
vb[0].Set(1.0f, 0.0f);
vb[1].Set(2.0f, 0.5f);
vb[2].Set(1.0f, 1.0f);
b2PolygonShape shapeB;
shapeB.Set(vb, 3);
)",
     "X has 4 vertices, Y 3, in the plane"},
    {"Box2D 3", R"(// gap of 1e-5 between the edges
b2Vec2 pointsA[] = { { -1.0f, -1.0f }, { 1.0f, -1.0f }, { 0.0f, 1.0f } };
b2Hull hullA = b2ComputeHull( pointsA, 3 );
b2Vec2 pointsB[] = { { 1.00001f, -1.0f }, { 4.0f, -1.0f }, { 3.0f, 1.0f } };
b2Hull hullB = b2ComputeHull( pointsB, 3 );
)",
     "X has 3 vertices, Y 3, in the plane"},
    {"Bullet", R"(btConvexHullShape* a = new btConvexHullShape();
a->addPoint(btVector3(btScalar(-1.), btScalar(-1.), btScalar(-1.)));
a->addPoint(btVector3(btScalar(1.), btScalar(-1.), btScalar(-1.)));
a->addPoint(btVector3(btScalar(0.), btScalar(1.), btScalar(-1.)));
btConvexHullShape* b = new btConvexHullShape();
b->addPoint(btVector3(0.f, 0.f, 2.f), false);
b->addPoint(btVector3(1.f, 0.f, 2.5f), false);
)",
     "X has 3 vertices, Y 2, in space"},
    {"libccd",
     "static ccd_vec3_t tri[3] = { { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } } };\n"
     "static ccd_vec3_t pt[1] = { { { 0.25, 0.25, 1e-6 } } };\n",
     "X has 3 vertices, Y 1, in space"},
    {"FCL",
     "std::vector<fcl::Vector3<double>> a{{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0, 0.1, 0}};\n"
     "const fcl::Vector3<S> p1(0, 0, 1), p2(0.5, 0, 1);\n",
     "X has 3 vertices, Y 2, in space"},
    {"parry", R"(let a = vec![
    Point2::new(0.0, 0.0),
    Point2::new(1.0, 0.0),
    Point2::new(1.0, 1.0),
];
let b: [Point2<f32>; 2] = [point![2.0, 0.5], point![3.0, 0.5_f32]];
)",
     "X has 3 vertices, Y 2, in the plane"},
    {"Rust arrays",
     "let a: [[f64; 2]; 3] = [[0.0, 0.0], [1_000.5, 0.0], [0.0, 1.0]];\n"
     "let b = &[[2e3f64, 2.0], [3e3, 3.0]];\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"three.js", R"(const a = [ new THREE.Vector3( 0, 0, 0 ), new THREE.Vector3( 1, 0, 0 ) ];
const vertices = new Float32Array( [
	-1.0, -1.0,  3.0, // v0
	 1.0, -1.0,  3.0, // v1
	 1.0,  1.0,  3.0, // v2
] );
)",
     "X has 2 vertices, Y 3, in space"},
    {"planck.js",
     "const a = pl.Polygon([Vec2(0, 0), Vec2(2, 0), Vec2(1, 1)]);\n"
     "const b = pl.Polygon([Vec2(3, 0), Vec2(5, 0), Vec2(4, 1)]);\n",
     "X has 3 vertices, Y 3, in the plane"},
    {"objects in JavaScript",
     R"({"vertsA": [{"x": 0, "y": 0}, {"x": 1, "y": 0}], "vertsB": [{"y": 3, "x": 2}]})",
     "X has 2 vertices, Y 1, in the plane"},
    {"shapely", R"(from shapely.geometry import Polygon, Point
a = Polygon([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)])  # concave
b = Point(2, 3)
print(a.distance(b))
)",
     "X has 1 outline of 5 vertices, Y 1 vertex, in the plane"},
    {"shapely with a hole",
     ">>> a = Polygon([(0,0),(10,0),(10,10),(0,10)], [[(2,2),(8,2),(8,8),(2,8)]])\n"
     ">>> b = Polygon([(4,4),(6,4),(6,6),(4,6)])\n",
     "X has 1 outline and 1 hole of 8 vertices, Y 4 vertices, in the plane"},
    {"shapely.wkt", R"py(a = wkt.loads("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))")
b = wkt.loads("MULTIPOINT (5 5, 6 5)")
)py",
     "X has 4 vertices, Y 2, in the plane"},
    {"PostGIS",
     "SELECT ST_Distance('LINESTRING(0 0, 1 1, 2 0)'::geometry,\n"
     "                   'SRID=4326;POLYGON((5 5,6 5,6 6,5 5))'::geometry);\n",
     "X has 1 open chain of 3 vertices, Y 3 vertices, in the plane; left out: SRID"},
    {"WKT of several parts",
     "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1)), ((9 0, 12 0, 11 2)))\n"
     "LINESTRING (20 0, 21 5, 22 0)\n",
     "X has 2 outlines and 1 hole of 11 vertices, Y 1 open chain of 3 vertices, in the plane"},
    {"WKT in space", "MULTIPOINT Z ((0 0 0), (1 0 0), (0 1 0), (0 0 1))\nPOINT Z (2 2 2)\n",
     "X has 4 vertices, Y 1, in space"},
    {"GeoJSON", R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"name": "park (north", "area": 64}, "geometry": {
  "type": "Polygon", "coordinates": [[[0,0],[8,0],[8,8],[0,8],[0,0]],
                                     [[2,2],[6,2],[6,6],[2,6],[2,2]]]}},
 {"type": "Feature", "properties": {}, "geometry": {"coordinates": [4, 4], "type": "Point"}}]}
)",
     "X has 1 outline and 1 hole of 8 vertices, Y 1 vertex, in the plane; left out: properties"},
    {"Unity", R"(var a = new Vector2[] { new Vector2(0f, 0f), new Vector2(1f, 0f) };
var b = new List<Vector2> { new Vector2(3f, 3f), new(4f, 3.5f), new(5f, 3f) };
)",
     "X has 2 vertices, Y 3, in the plane"},
    {"a log of Unity",
     "(1.00, 2.00, 3.00)\n(1.50, 2.00, 3.00)\n\n(4.00, 2.00, 3.00)\n(5.00, 2.00, 3.00)\n",
     "X has 2 vertices, Y 2, in space"},
    {"a log of Unreal",
     "X=1.000 Y=2.000 Z=3.000\nX=2.000 Y=2.000 Z=3.000\n\nX=5.000 Y=2.000 Z=3.000\n",
     "X has 2 vertices, Y 1, in space"},
    {"Godot",
     "var a = [Vector2(0, 0), Vector2(10, 0), Vector2(5, 8)]\n"
     "var b = PackedVector2Array([Vector2(12, 0), Vector2(20, 0)])\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"numpy",
     "A = np.array([[0., 0.], [1., 0.], [0., 1.]], dtype=np.float32)\n"
     "B = array([[2.  , 2.  ],\n       [3.25, 2.5 ]])\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"numpy, printed",
     "[[0.         0.        ]\n [1.         0.        ]\n [0.33333333 1.        ]]\n"
     "[[ 2.e+00 -1.e-03]\n [ 3.e+00  5.e-01]]\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"numpy 2",
     "[(np.float64(0.1), np.float64(0.2)), (np.float64(1.0), np.float64(0.0))]\n"
     "[(np.float64(3.0), np.float64(4.0))]\n",
     "X has 2 vertices, Y 1, in the plane"},
    {"MATLAB", "A = [0 0; 1 0; 1 1];\nB = [3, 0; 4, 0\n4, 1];\n",
     "X has 3 vertices, Y 3, in the plane"},
    {"columns with headings",
     "Polygon A:\n0.0 0.0\n1.0 0.0\n0.5 0.866\nPolygon B:\n2.0\t0.0\n3.0\t0.0\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"CSV", "x,y\n0,0\n1,0\n0,1\n\nx,y\n3,3\n4,3\n", "X has 3 vertices, Y 2, in the plane"},
    {"numbered shapes", "Triangle 1: (0,0), (1,0), (0,1)\nTriangle 2:\n(3,3), (4,3)\n",
     "X has 3 vertices, Y 2, in the plane"},
    {"points in two lines", "(0,0) (1,0) (1,1)\n(3,3) (4,3) (4,4)\n",
     "X has 3 vertices, Y 3, in the plane"},
    {"a program in C", R"(int main() {
  float a[][2] = {{0, 0}, {1, 0}, {1, 1}};
  float b[4][2] = {{3, 0}, {4, 0}, {4, 1}, {3, 1}};
  printf("%f\n", gjk(a, b));
  return 0;
}
)",
     "X has 3 vertices, Y 4, in the plane"},
    {"C99",
     "Vec2 a[] = { (Vec2){ .x = 0.0f, .y = 0.0f }, (Vec2){ .x = 1.0f, .y = 0.0f } };\n"
     "Vec2 b[] = { [0] = { .x = 3, .y = 1 } };\n",
     "X has 2 vertices, Y 1, in the plane"},
    {"a flat array", "float a[] = {0, 0, 1, 0};\nfloat b[] = {\n  3, 0,\n  4, 0,\n  4, 1,\n};\n",
     "X has 2 vertices, Y 3, in the plane"},
    {"C++ vectors",
     "a.push_back({0, 0}); a.push_back({1, 0}); b.push_back(Vec2(5, 5)); a.push_back({1, 1});\n",
     "X has 3 vertices, Y 1, in the plane"},
    {"OBJ of Blender", R"(mtllib a.mtl
o Cube
v 1.0 1.0 -1.0
v 1.0 -1.0 -1.0
v -1.0 -1.0 -1.0
vn 0 1 0
f 1//1 2//1 3//1
o Tri
v 3.0 1.0 -1.0
v 3.0 -1.0 -1.0
s off
)",
     "X has 3 vertices, Y 2, in space"},
    {"STL", R"(solid a
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1 0 0
   vertex 0 1 0
  endloop
 endfacet
 facet normal 0 0 1
  outer loop
   vertex 1.0 0 0
   vertex 1 1 0
   vertex -0 1 0
  endloop
 endfacet
endsolid a
solid b
 facet normal 0 0 1
  outer loop
   vertex 0 0 3
   vertex 1 0 3
   vertex 0 1 3e0
  endloop
 endfacet
endsolid b
)",
     "X has 4 vertices, Y 3, in space"},
    {"OFF",
     "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
     "OFF 2 0 0\n0 0 2 # top\n1 0 2\n",
     "X has 3 vertices, Y 2, in space"},
};

TEST(Paste, ReportsAreReadAsTheyStand) {
  for (const Report& report : kReports) {
    const ReadCase found = read(report.text);
    for (const Problem& problem : found.problems)
      ADD_FAILURE() << report.name << ": " << to_string(problem);
    EXPECT_EQ(report.understood, found.understood) << report.name;
  }
}

TEST(Paste, NumbersKeepEveryDigit) {
  const ReadCase found = read(
      "a = [(0.1f, 1.0F), (1_000.5, 0x1.999999999999ap-4), (0x10, 5e-324)]\n"
      "b = [(-0.0, \xE2\x88\x92"
      "2.5), (0.30000000000000004, 12'345L)]");
  ASSERT_TRUE(found.value);
  EXPECT_EQ((std::vector<Eigen::Vector2d>{{0.1, 1.0}, {1000.5, 0.1}, {16.0, 5e-324}}),
            found.value->a);
  EXPECT_EQ((std::vector<Eigen::Vector2d>{{-0.0, -2.5}, {0.30000000000000004, 12345.0}}),
            found.value->b);
  EXPECT_TRUE(std::signbit(found.value->b[0].x()));
}

TEST(Paste, AHoleIsOneByItsPlaceHoweverItTurns) {
  const std::string ring = "[[0,0],[10,0],[10,10],[0,10],[0,0]]";
  const std::string back = "[[0,0],[0,10],[10,10],[10,0],[0,0]]";
  const std::string hole = "[[2,2],[8,2],[8,8],[2,8],[2,2]]";
  const std::string hole_back = "[[2,2],[2,8],[8,8],[8,2],[2,2]]";
  const std::string point = R"({"type":"Point","coordinates":[5,4]})";
  for (const std::string& outer : {ring, back}) {
    for (const std::string& inner : {hole, hole_back}) {
      const std::string polygon =
          R"({"type":"Polygon","coordinates":[)" + outer + "," + inner + "]}";
      for (const std::string& text :
           {polygon + point, R"({"a":)" + polygon + R"(,"b":[[5,4]]})",
            R"({"type":"MultiPolygon","coordinates":[[)" + outer + "," + inner + "]]}" + point}) {
        const json answer = solved(text);
        EXPECT_EQ(2.0, answer["distance"]) << text << answer;
        EXPECT_EQ(false, answer["overlap"]) << text;
      }
    }
  }
}

TEST(Paste, OneShapeMayBeAnOutlineAndTheOtherPoints) {
  const std::string outline = "[[[0,0],[4,0],[4,4],[2,1],[0,4]]]";
  // The hull of points counts, beside an outline, too.
  for (const std::string& text :
       {R"({"outlines_a":)" + outline + R"(,"b":[[1.9,3],[2.1,3],[2,3.5],[2,3.1]]})",
        R"({"b":[[2,3],[2,3]],"outlines_a":)" + outline + "}"}) {
    const json answer = solved(text);
    EXPECT_EQ(false, answer["overlap"]) << text;
    EXPECT_LT(0.5, answer["distance"].get<double>()) << text;
  }
  const std::string around = R"({"outlines_a":)" + outline + R"(,"b":[[-9,-9],[9,-9],[0,20]]})";
  EXPECT_EQ(true, solved(around)["overlap"]);
  EXPECT_EQ(true, solved(R"({"a":[[-9,-9],[9,-9],[0,20],[0,0]],"outlines_b":)" + outline +
                         "}")["overlap"]);
}

TEST(Paste, WhatTakesPointsAloneIsToldOfTheHull) {
  const ReadCase found = read(kReports[11].text, std::nullopt);
  ASSERT_TRUE(found.value);
  EXPECT_EQ(4u, found.value->a.size());
  EXPECT_EQ(
      "X has 1 outline and 1 hole of 8 vertices, Y 4 vertices, in the plane; the hull of X counts",
      found.understood);
}

struct Bad {
  std::string text;
  std::string problem;
};

TEST(Paste, WhatIsNotClearIsSaidWithItsPlace) {
  const Bad bads[] = {
      {"a = [(0,0),(1,0)\nb = [(3,3)]\n", "f:1:5: '[' is never closed; expected a ']'"},
      {"[(0,0),(1,0))\n", "f:1:13: ')' closes a '['; expected ']'"},
      {"[(0,0)]]\n[(1,1)]", "f:1:8: ']' closes nothing"},
      {"a = {{0,0,0},{1,0,0,5},{1,1,1}}; b = {{3,3,3}};", "f:1:14: a point has 4 coordinates"},
      {"a = {{0,0},\n{1,0,0},{1,1}};\nb = {{3,3}};",
       "f:2:1: a point has 3 coordinates; expected 2 coordinates, as the points before"},
      {"a = {{0,0},{1,0}};\nb = {{3,3,3}};", "f:2:6: a point has 3 coordinates; expected 2"},
      {"[(0,0),(1e400,0)] [(1,1)]", "f:1:9: the number 1e400 is too large for a double"},
      {"[(0,0),(1e-400,0)] [(1,1)]", "f:1:9: the number 1e-400 is too small for a double"},
      {"", "f:1:1: there is no case"},
      {std::string("solid\0\1 12", 10), "f:1:6: a byte that is no text"},
      {"[(0, 0), (é, 1)] [(1,1)]", "f:1:11: 'é' stands among numbers"},
      {"[(0, 0),\n (nan, 1)] [(1,1)]", "f:2:3: 'nan' stands among numbers"},
      {"[(0, 1/3), (1, 1)] [(1,1)]", "f:1:7: '/' stands among numbers"},
      {"[(0, 2-1), (1, 1)] [(1,1)]", "f:1:7: '-' stands among numbers"},
      {"[(0, sqrt(3)), (1, 1)] [(1,1)]", "f:1:10: 'sqrt' is not computed"},
      {"[(0,0),(1.5px,1)] [(1,1)]", "f:1:9: '1.5px' is no number"},
      {"[1+2j, 3+4j] [5+6j]", "f:1:4: '2j' is no number"},
      {"[(0, 1)]\n[(1,1)]\n [(2,2)]", "f:3:3: a third shape begins; expected two shapes, X and Y"},
      {"[(0, 1), (1, 1)]\n", "f:2:1: there is one shape, of 2 vertices; expected a second one, Y"},
      {"a = [0,0,1,0,1,1]\nb=[3,3,4,4]", "f:1:5: 6 numbers in a row could be points in the plane"},
      {"a = [0,0,1,0,1]\nb=[3,3,4,4]", "f:1:5: 5 numbers are no points"},
      {"0 0 1 0\n3 3 4 4", "f:1:1: a line of 4 numbers"},
      {"a = [(0,0),(1,0)]\nradius = 0.5\nb = [(3,3)]", "f:2:10: a number stands alone: 0.5"},
      {"GJK returned 0.5 after 3 iterations\n", "f:1:5: 'returned' stands among numbers"},
      {"Cuboid::new(1.0, 2.0), Cuboid::new(1.0, 2.0)\n",
       "f:1:12: the numbers of 'Cuboid::new' are no point; expected the vertices of the shape"},
      {"POLYGON((0 0, 1 0, 1, 0 0))\nPOINT(1 2)",
       "f:1:20: a point has 1 coordinate; expected 2 coordinates"},
      {"POLYGON EMPTY\nPOINT(1 2)", "f:1:9: an empty geometry"},
      {R"({"type":"Polygon","coordinates":[]} [1,2])", "f:1:1: an empty geometry"},
      {"POINT M (1 2 3)\nPOINT(1 2)", "f:1:7: an M coordinate is no place"},
      {"POLYGON((0 0, 1 0, 1 1, 0 0),\n(5 5, 6 5, 6 6, 5 5))\nPOINT(1 2)",
       "f:2:2: a hole lies outside of its ring"},
      {"POLYGON Z ((0 0 1, 1 0 1, 1 1 1),\n(5 5 1, 6 5 1, 6 6 1))\nPOINT Z (1 2 3)",
       "f:2:2: a second outline in space"},
      {"OFF\n4 1 0\n0 0 0\n1 0 0\n", "f:2:1: OFF has 2 vertices; expected 4 vertices"},
      {"o a\nv 1 2\no b\nv 1 2 3\n", "f:2:1: a vertex has 2 numbers; expected 3 coordinates"},
      {"o a\nv 1 2 3\nv 1 2 x\n", "f:3:7: 'x' is no number"},
      {"o a\nv 1 2 3 0.5\n", "f:2:9: a vertex has a weight"},
      {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
       "f:5:1: the text ends within a solid; expected 'endsolid'"},
      {std::string(200, '[') + "1,2", "f:1:101: brackets stand too deep in each other"},
  };
  for (const Bad& bad : bads) {
    const std::string problem = problem_of(bad.text);
    EXPECT_TRUE(problem.starts_with(bad.problem)) << problem << "\nfor " << bad.text;
  }
}

TEST(Paste, LongAndHostileTextsTakeNoLonger) {
  std::string many = "a = [\n";
  for (int i = 0; i < 1000000; ++i) many += fmt::format("[{}, 0.5],\n", i);
  EXPECT_EQ("X has 1000000 vertices, Y 1, in the plane", read(many + "]\nb = [[3, 3]]").understood);
  for (const char* part :
       {"\"", "'a ", "a<", "a[", "v ", "{\"id\":", "1:", "/*", "(1,2)/", "- ", "a::"}) {
    std::string text;
    while (text.size() < 1000000) text += part;
    EXPECT_NE("", problem_of(text + " 1 2")) << part;
  }
}

/// The points of a shape, each written with `number` in `point`, joined by `comma`.
std::string listed(const std::vector<Eigen::Vector3d>& points, std::string_view point,
                   std::string_view comma) {
  std::string out;
  for (const Eigen::Vector3d& p : points) {
    if (!out.empty()) out += comma;
    out += fmt::format(fmt::runtime(point), p.x(), p.y(), p.z());
  }
  return out;
}

TEST(Paste, ACaseInEachFormReadsBackToTheSamePoints) {
  struct Form {
    std::string begin;
    std::string point;
    std::string comma;
    std::string end;
  };
  const Form forms[] = {
      {"MULTIPOINT Z (", "({} {} {})", ", ", ")\n"},
      {"MULTIPOINT (", "{0} {1}", ",", ")\n"},
      {R"({"type":"MultiPoint","coordinates":[)", "[{},{},{}]", ",", "]}\n"},
      {"o shape\n", "v {} {} {}", "\n", "\n"},
      {"OFF\n5 0 0\n", "{} {} {}", "\n", "\n"},
      {"solid\nfacet\n", "vertex {} {} {}", "\n", "\nendsolid\n"},
      {"double a[][3] = {", "{{{}, {:a}, {}}}", ", ", "};\n"},
      {"double a[] = {\n", "{0}, {1}", ",\n", "};\n"},
      {"a = np.array([", "[{}, {}, {}]", ",\n", "])\n"},
      {"let a = [", "Vec2::new({0}f64, {1:a})", ", ", "];\n"},
      {"var a = new Vector3[] { ", "new Vector3({}d, {}d, {}d)", ", ", " };\n"},
      {"[", R"({{"x": {0}, "y": {1}, "z": {2}}})", ", ", "]\n"},
      {"[", "{0} {1}", "; ", "];\n"},
      {"\n", "{} {} {}", "\n", "\n"},
      {"points:\n", "{0},{1}", "\n", "\n"},
      {"", "({}, {}, {})", "\n", "\n\n"},
  };
  std::mt19937_64 random(50);
  const auto number = [&] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  for (int round = 0; round < 50; ++round) {
    std::vector<Eigen::Vector3d> a(5);
    std::vector<Eigen::Vector3d> b(5);
    for (std::vector<Eigen::Vector3d>* shape : {&a, &b}) {
      for (Eigen::Vector3d& point : *shape) point = {number(), number(), number()};
    }
    for (const Form& form : forms) {
      std::string text;
      for (const auto& shape : {a, b})
        text += form.begin + listed(shape, form.point, form.comma) + form.end;
      SCOPED_TRACE(text);
      const ReadCase found = read(text);
      for (const Problem& problem : found.problems) ADD_FAILURE() << to_string(problem);
      if (found.in_space) {
        EXPECT_EQ(a, found.in_space->a);
        EXPECT_EQ(b, found.in_space->b);
      } else if (found.value) {
        for (std::size_t i = 0; i < 5; ++i) {
          EXPECT_EQ(a[i].head<2>(), found.value->a.at(i));
          EXPECT_EQ(b[i].head<2>(), found.value->b.at(i));
        }
      }
    }
  }
}

TEST(Paste, TextsWithFlawsAreReadOrRefusedNeverHalf) {
  std::mt19937 random(50);
  const std::string alphabet = "{}[](),:;\"'=0129.-+eExX#/ \n\tvPOLYGON\xC3\xFF";
  for (const Report& report : kReports) {
    for (int i = 0; i < 200; ++i) {
      std::string text = report.text;
      for (std::size_t k = random() % 4 + 1; k > 0 && !text.empty(); --k) {
        const std::size_t at = random() % text.size();
        const char c = alphabet[random() % alphabet.size()];
        if (random() % 2 == 0)
          text[at] = c;
        else if (random() % 2 == 0)
          text.insert(at, 1, c);
        else
          text.erase(at, 1 + random() % 8);
      }
      SCOPED_TRACE(text);
      for (const ReadCase& found : parse_cases(text, "f", 3, models::Needs::segments)) {
        const bool is_read = found.value || found.in_space || found.outlines;
        ASSERT_EQ(found.problems.empty(), is_read);
        for (const Problem& problem : found.problems) ASSERT_FALSE(problem.what.empty());
      }
    }
  }
}

TEST(Paste, TwoFilesOfOneShapeAreACase) {
  const test::TemporaryFolder folder;
  const std::string x = folder.file("x.obj", "v 0 0 0\nv 1 0 0\n");
  const std::string y = folder.file("y.off", "OFF\n1 0 0\n4 4 0\n");
  const test::Ran solved = test::run_program(fmt::format("solve {} {}", x, y));
  const json answer = json::parse(solved.out);
  EXPECT_EQ(5.0, answer["distance"]);
  EXPECT_EQ("X has 2 vertices, Y 1, in space", answer["understood"]);
  const test::Ran checked = test::run_program(fmt::format("check {} {}", x, y));
  EXPECT_EQ(0, checked.exit_code);
  EXPECT_NE(std::string::npos, checked.out.find("X has 2 vertices, Y 1, in space"));
  const test::Ran alone = test::run_program("solve " + x);
  EXPECT_EQ(1, alone.exit_code);
  EXPECT_NE(std::string::npos, alone.err.find("x.obj:3:1: there is one shape")) << alone.err;
  const std::string plane = folder.file("p.wkt", "POINT (1 2)");
  const test::Ran mixed = test::run_program(fmt::format("solve {} {}", x, plane));
  EXPECT_NE(std::string::npos, mixed.err.find("p.wkt:1:7: a point has 2 coordinates")) << mixed.err;
}

/// The table of README: each form with an example, which is read.
TEST(Paste, TheFormsOfReadmeAreRead) {
  const std::string readme = test::read_file(GJKSCOPE_SOURCE_DIR "/README.md");
  const std::string help = test::run_program("solve --help").out;
  std::size_t at = readme.find("| form | example");
  ASSERT_NE(std::string::npos, at);
  std::istringstream rows(readme.substr(at, readme.find("\n\n", at) - at));
  std::string row;
  std::getline(rows, row);
  std::getline(rows, row);
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    std::smatch cells;
    ASSERT_TRUE(std::regex_match(row, cells, std::regex(R"(\| (.*) \| `(.*)` \|)"))) << row;
    const std::string text = std::regex_replace(cells[2].str(), std::regex(" ⏎ "), "\n");
    const ReadCase found = read(text);
    for (const Problem& problem : found.problems) ADD_FAILURE() << text << to_string(problem);
    EXPECT_NE("", found.understood) << text;
    EXPECT_NE(std::string::npos, help.find(cells[1].str())) << "--help has no " << cells[1];
  }
  EXPECT_EQ(8, count);
}

}  // namespace paste_test
}  // namespace gjkscope
