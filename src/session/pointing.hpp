#pragma once
// A question that is answered in the drawing: the choice that lies under the hand.

#include <optional>
#include <string>
#include <vector>

#include "session/hand.hpp"

namespace gjkscope {

/// The choice that somebody points at.
struct PointedChoice {
  std::string choice;
  /// If the answer is a pair: whether this is a half from the first list or from the second, which
  /// need not have it.
  std::optional<std::size_t> half = {};
  /// If a place or a direction is asked for: the place that is pointed at, in the coordinates of
  /// the view.
  std::optional<Eigen::Vector2d> place = {};
};

/// A mark that a choice may be: a point, or an area with corners.
struct MarkPlace {
  Point middle;
  std::vector<Point> corners = {};
};
/// Nothing for other marks.
[[nodiscard]] std::optional<MarkPlace> place_of(const Mark& mark);

/// The name by which choices call a vertex; empty for all else.
[[nodiscard]] std::string name_of(const LessonRun& run, const Subject& subject);

/// The place on the page from which a direction is dragged, where one is asked for.
[[nodiscard]] std::optional<Point> origin_on_page(const Session& session);

/// The choice at a place of the page: a vertex, an edge, a face, a region, a mark, a place or a
/// direction that is asked for. In space a region of a simplex is pointed at by the vertex, edge or
/// face that it belongs to. `subject` is what lies under the pointer. Nothing where no question is
/// open.
[[nodiscard]] std::optional<PointedChoice> pointed_choice(Session& session, const Hand& hand,
                                                          const Subject& subject,
                                                          const Point& page);

}  // namespace gjkscope
