#pragma once
// What of a picture is under the pointer.

#include "picture/picture.hpp"
#include "subjects/regions/voronoi.hpp"

namespace gjkscope {

/// The subject of the mark at `p` (frame pixels), kind none where there is none. Points come before
/// lines and lines before areas, and of each the last painted; points and lines are hit from up to
/// `slack` away.
[[nodiscard]] Subject subject_at(const Picture& picture, const Fonts& fonts, const Point& p,
                                 double slack);

/// The face of a simplex that a click means: its vertex or its edge within `reach` of `p`, else
/// that of the Voronoi region around `p`. Points are in the coordinates of the Minkowski
/// difference.
[[nodiscard]] gjk::Face face_at(const std::vector<Eigen::Vector2d>& simplex,
                                const VoronoiRegions::Value& regions, const Eigen::Vector2d& p,
                                double reach);

/// Whether any part of a shape, or of the difference, is inside of `card`; also where no mark
/// stands for one, and nobody can tell.
[[nodiscard]] bool is_in_sight(const Picture& picture, const Rect& card);

/// What a hand takes there: with a volume of a tree the shape that it bounds a part of.
[[nodiscard]] Subject held(const Subject& subject);

/// True when the two are parts of the same thing: a vertex of the difference and the vertices that
/// made it.
[[nodiscard]] bool is_linked(const Subject& a, const Subject& b);

}  // namespace gjkscope
