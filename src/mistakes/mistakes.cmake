# Loops that people publish: the textbook's page (tests/gjk/textbook.hpp) with one line changed each. A header for each is
# made in the build folder, in a namespace of the mistake's name; mistakes.def lists them, with the line and what stands in its place.

file(READ ${PROJECT_SOURCE_DIR}/tests/gjk/textbook.hpp page)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/gjk/textbook.hpp)
set(MISTAKES_DIR ${CMAKE_CURRENT_BINARY_DIR}/mistakes)
set(MISTAKES "")
set(INCLUDES "")

# The text with `line`, which it has exactly once, replaced by `by`.
function(replace_line out text line by)
  string(REPLACE "${line}" "" rest "${text}")
  string(LENGTH "${text}" whole)
  string(LENGTH "${rest}" left)
  string(LENGTH "${line}" one)
  math(EXPR removed "${whole} - ${left}")
  if(NOT removed EQUAL one)
    message(FATAL_ERROR "tests/gjk/textbook.hpp does not have this once:\n${line}")
  endif()
  string(REPLACE "${line}" "${by}" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# mistake(NAME MEANING LINE REPLACEMENT)
function(mistake name meaning line by)
  replace_line(text "${page}" "${line}" "${by}")
  replace_line(text "${text}" "namespace textbook {" "namespace ${name} {")
  # What the log is told, and when.
  replace_line(text "${text}" "inline Simplex gjk(const Polygon& x, const Polygon& y, int cap) {"
    "template <class Log>\nSimplex gjk(const Polygon& x, const Polygon& y, int cap, Log& log) {")
  replace_line(text "${text}" "  while (true) {\n" "  while (true) {\n    log.simplex(s);\n")
  replace_line(text "${text}" "    if (s.size() == 3) return s;" "    log.kept(s);\n    if (s.size() == 3) return s;")
  replace_line(text "${text}" "    for (const Vertex& v : s)\n" "    log.step(d, far_x, far_y);\n    for (const Vertex& v : s)\n")
  file(CONFIGURE OUTPUT ${MISTAKES_DIR}/${name}.hpp CONTENT "@text@" @ONLY)
  string(REPLACE "_" "-" file_name ${name})
  set(MISTAKES "${MISTAKES}MISTAKE(${name}, \"${file_name}\", \"${meaning}\", R\"~(${line})~\", R\"~(${by})~\")\n" PARENT_SCOPE)
  set(INCLUDES "${INCLUDES}#include \"mistakes/${name}.hpp\"\n" PARENT_SCOPE)
endfunction()

mistake(none "The loop of the textbook's page." [[s = closest(s);]] [[s = closest(s);]])

mistake(wrong_sign
  "The normal points away from O: d has the wrong sign."
  [[d = dot(normal, d) < 0 ? Point(-normal) : normal;]]
  [[d = dot(normal, d) > 0 ? Point(-normal) : normal;]])
mistake(nothing_dropped
  "No vertex of a segment is dropped."
  [[if (ab <= 0) return keep({s[1]}, 1, 0);]]
  [[if (ab <= 0) return keep(s, 0, 1);]])
mistake(region_unchecked
  "The region of one edge is not checked, and O counts as inside."
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);]]
  [[]])
mistake(wrong_drop
  "The wrong vertex of a triangle is dropped."
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);]]
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[0], s[2]}, ac, ca);]])
mistake(exchanged_weights
  "The weights of a segment's ends are exchanged."
  [[return keep(s, ab, ba);]]
  [[return keep(s, ba, ab);]])
mistake(no_zero_test
  "There is no test for d = 0."
  [[if (d.isZero(0) || --cap == 0) return s;]]
  [[if (--cap == 0) return s;]])
mistake(no_progress_test
  "There is no test of progress, and the loop runs for ever."
  [[if (v.x == far_x && v.y == far_y) return s;]]
  [[static_cast<void>(v);]])
mistake(nearest_vertex
  "The nearest vertex stands for the farthest one."
  [[const int far_x = support(x, -d), far_y = support(y, d);]]
  [[const int far_x = support(x, d), far_y = support(y, -d);]])
mistake(absolute_epsilon
  "An absolute epsilon is too large for tiny shapes, and below rounding for huge ones."
  [[if (v.x == far_x && v.y == far_y) return s;]]
  [[if (dot(d, y[far_y] - x[far_x]) - dot(d, v.w) < 1e-6) return s;]])
mistake(compared_by_place
  "Support points are compared by their vertex of X alone, and two differences share it."
  [[if (v.x == far_x && v.y == far_y) return s;]]
  [[if (x[v.x] == x[far_x]) return s;]])
mistake(direction_not_turned
  "The shapes' frames are turned by a quarter, and d is not turned into them."
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(Point(d.y(), -d.x()), shape[i]) > dot(Point(d.y(), -d.x()), shape[best])) best = i;]])
mistake(sum_for_difference
  "The loop adds the vertices of Y and X: Y + X for Y - X."
  [[s.push_back({far_x, far_y, y[far_y] - x[far_x]});]]
  [[s.push_back({far_x, far_y, y[far_y] + x[far_x]});]])
mistake(past_the_origin
  "The test whether shapes overlap ends where no point lies past O, and the distance is read there."
  [[if (d.isZero(0) || --cap == 0) return s;]]
  [[if (d.isZero(0) || --cap == 0 || dot(d, y[far_y] - x[far_x]) < 0) return s;]])
mistake(reflex_polygon
  "The search climbs from vertex to vertex, which is right for a convex polygon alone."
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i; else if (best > 0) break;]])

file(CONFIGURE OUTPUT ${MISTAKES_DIR}/mistakes.def CONTENT "@MISTAKES@" @ONLY)
file(CONFIGURE OUTPUT ${MISTAKES_DIR}/all.hpp CONTENT "#pragma once\n@INCLUDES@" @ONLY)
