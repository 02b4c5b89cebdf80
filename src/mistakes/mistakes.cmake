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
  replace_line(text "${text}" "inline Output gjk(const Input& in, int cap = 64) {"
    "template <class Log>\nOutput gjk(const Input& in, int cap, Log& log) {")
  replace_line(text "${text}" "++iterations) {\n" "++iterations) {\n    log.simplex(s);\n")
  replace_line(text "${text}" "    if (s.size() == 3) return out;"
    "    log.kept(s);\n    if (s.size() == 3) return out;")
  replace_line(text "${text}" "    for (const auto& v : s)\n"
    "    log.step(d, far_x, far_y);\n    for (const auto& v : s)\n")
  file(CONFIGURE OUTPUT ${MISTAKES_DIR}/${name}.hpp CONTENT "@text@" @ONLY)
  string(REPLACE "_" "-" file_name ${name})
  set(MISTAKES "${MISTAKES}MISTAKE(${name}, \"${file_name}\", \"${meaning}\", R\"~(${line})~\", R\"~(${by})~\")\n" PARENT_SCOPE)
  set(INCLUDES "${INCLUDES}#include \"mistakes/${name}.hpp\"\n" PARENT_SCOPE)
endfunction()

mistake(none
  "The loop of the textbook's page."
  [[s = closest(s);]]
  [[s = closest(s);]])
mistake(wrong_sign
  "The normal points away from O: d has the wrong sign."
  [[if (dot(d, s[0].w) > 0) d = -d;]]
  [[if (s.size() == 2 && dot(d, s[0].w) < 0) d = -d;]])
mistake(nothing_dropped
  "No vertex of a segment is dropped."
  [[if (s.size() == 2 && ab <= 0) return keep({s[1]}, 1);]]
  [[if (s.size() == 2 && ab <= 0) return keep(s, 0, 1);]])
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
  [[if (d.isZero(0) || iterations == cap) return out;]]
  [[if (iterations == cap) return out;]])
mistake(no_progress_test
  "There is no test of progress: only the cap on iterations ends the loop."
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[static_cast<void>(v);]])
mistake(nearest_vertex
  "The nearest vertex stands for the farthest one."
  [[const int far_x = support(in.x, -d), far_y = support(in.y, d);]]
  [[const int far_x = support(in.x, d), far_y = support(in.y, -d);]])
mistake(absolute_epsilon
  "An absolute epsilon is too large for tiny shapes, and below rounding for huge ones."
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[if (dot(d, in.y[far_y] - in.x[far_x]) - dot(d, v.w) < 1e-6) return out;]])
mistake(compared_by_place
  "Support points are compared by their vertex of X alone, and two differences share it."
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[if (in.x[v.index_x] == in.x[far_x]) return out;]])
mistake(direction_not_turned
  "The shapes' frames are turned by a quarter, and d is not turned into them."
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(Point(d.y(), -d.x()), shape[i]) > dot(Point(d.y(), -d.x()), shape[best])) best = i;]])
mistake(sum_for_difference
  "The loop adds the vertices of Y and X: Y + X for Y - X."
  [[s.push_back({far_x, far_y, in.y[far_y] - in.x[far_x]});]]
  [[s.push_back({far_x, far_y, in.y[far_y] + in.x[far_x]});]])
mistake(past_the_origin
  "The test whether shapes overlap ends where no point lies past O, and the distance is read there."
  [[if (d.isZero(0) || iterations == cap) return out;]]
  [[if (d.isZero(0) || iterations == cap || dot(d, in.y[far_y] - in.x[far_x]) < 0) return out;]])
mistake(reflex_polygon
  "The search climbs from vertex to vertex, which is right for a convex polygon alone."
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i; else if (best > 0) break;]])

file(CONFIGURE OUTPUT ${MISTAKES_DIR}/mistakes.def CONTENT "@MISTAKES@" @ONLY)
file(CONFIGURE OUTPUT ${MISTAKES_DIR}/all.hpp CONTENT "#pragma once\n@INCLUDES@" @ONLY)
