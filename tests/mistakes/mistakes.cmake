# Loops that people publish: the textbook's page (tests/gjk/textbook.hpp) with one line changed each. A header for each is
# made in the build folder, in a namespace of the mistake's name, and MISTAKES lists them. All write the log of their run.

file(READ ${PROJECT_SOURCE_DIR}/tests/gjk/textbook.hpp page)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/gjk/textbook.hpp)
set(MISTAKES_DIR ${CMAKE_CURRENT_BINARY_DIR}/mistakes)
set(MISTAKES "")

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

# mistake(NAME LINE REPLACEMENT)
function(mistake name line by)
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
  set(MISTAKES "${MISTAKES}MISTAKE(${name})\n" PARENT_SCOPE)
endfunction()

mistake(none [[s = closest(s);]] [[s = closest(s);]])

# d with the wrong sign.
mistake(wrong_sign
  [[if (dot(d, s[0].w) > 0) d = -d;]]
  [[if (s.size() == 2 && dot(d, s[0].w) < 0) d = -d;]])
# No vertex of a segment is dropped.
mistake(nothing_dropped
  [[if (s.size() == 2 && ab <= 0) return keep({s[1]}, 1);]]
  [[if (s.size() == 2 && ab <= 0) return keep(s, 0, 1);]])
# The region of an edge is not checked, so O counts as inside.
mistake(region_unchecked
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);]]
  [[]])
# The wrong vertex of a triangle is dropped.
mistake(wrong_drop
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);]]
  [[if (bc > 0 && cb > 0 && a <= 0) return keep({s[0], s[2]}, ac, ca);]])
# The weights of a segment's ends are exchanged.
mistake(exchanged_weights
  [[return keep(s, ab, ba);]]
  [[return keep(s, ba, ab);]])
# No test for d = 0.
mistake(no_zero_test
  [[if (d.isZero(0) || iterations == cap) return out;]]
  [[if (iterations == cap) return out;]])
# No test of progress: it runs for ever.
mistake(no_progress_test
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[static_cast<void>(v);]])
# The nearest vertex for the support point.
mistake(nearest_vertex
  [[const int far_x = support(in.x, -d), far_y = support(in.y, d);]]
  [[const int far_x = support(in.x, d), far_y = support(in.y, -d);]])
# An absolute epsilon: too large for tiny shapes, below rounding for huge ones.
mistake(absolute_epsilon
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[if (dot(d, in.y[far_y] - in.x[far_x]) - dot(d, v.w) < 1e-6) return out;]])
# Support points compared by their place on one shape, where two differences share a vertex.
mistake(compared_by_place
  [[if (v.index_x == far_x && v.index_y == far_y) return out;]]
  [[if (in.x[v.index_x] == in.x[far_x]) return out;]])
# The shapes' frames are turned by a quarter, and d is not turned into them.
mistake(direction_not_turned
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(Point(d.y(), -d.x()), shape[i]) > dot(Point(d.y(), -d.x()), shape[best])) best = i;]])
# Y + X for Y - X.
mistake(sum_for_difference
  [[s.push_back({far_x, far_y, in.y[far_y] - in.x[far_x]});]]
  [[s.push_back({far_x, far_y, in.y[far_y] + in.x[far_x]});]])
# "The support point is not past the origin" ends the test whether shapes overlap, and not the search for their distance.
mistake(past_the_origin
  [[if (d.isZero(0) || iterations == cap) return out;]]
  [[if (d.isZero(0) || iterations == cap || dot(d, in.y[far_y] - in.x[far_x]) < 0) return out;]])
# Climbing from vertex to vertex: right for a convex polygon, not for a reflex one.
mistake(reflex_polygon
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i;]]
  [[if (dot(d, shape[i]) > dot(d, shape[best])) best = i; else if (best > 0) break;]])

file(CONFIGURE OUTPUT ${MISTAKES_DIR}/mistakes.def CONTENT "@MISTAKES@" @ONLY)
string(REGEX REPLACE "MISTAKE\\(([a-z_]*)\\)" "#include \"mistakes/\\1.hpp\"" includes "${MISTAKES}")
file(CONFIGURE OUTPUT ${MISTAKES_DIR}/all.hpp CONTENT "#pragma once\n@includes@" @ONLY)
