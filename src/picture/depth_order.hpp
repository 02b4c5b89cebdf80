#pragma once
// Marks of space in the order of their depth: what is nearer to the eye is painted later. What
// cuts through another thing, or would come both before and after it, is painted in parts.

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// Points of space are in frame pixels, with z towards the eye.
using PointsInSpace = std::vector<Eigen::Vector3d>;

/// A face that looks towards the eye.
struct Facet {
  PointsInSpace corners;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< Outwards, of unit length.
  bool is_shaded = false;
  Eigen::AlignedBox2d box = {};  ///< On the screen; made by Convex.
};

/// Something convex as the eye sees it: one flat polygon, or the faces in front of a body.
struct Convex {
  Convex(std::vector<Facet> faces, const PointsInSpace& points);

  std::vector<Facet> facets;     ///< In the order of their boxes' left sides.
  std::vector<Point> outline;    ///< The hull of all points on the screen.
  std::vector<Facet> sides;      ///< Planes through the outline's edges and the eye.
  Eigen::AlignedBox2d box = {};  ///< On the screen.
  double widest = 0.0;           ///< The width of the widest facet.
  double nearest = 0.0;          ///< The largest z.
  double touching = 0.0;         ///< Points less deep than this are not behind.
};

/// The filled areas of something convex.
struct PaintedSurface {
  std::string fill;
  std::string shade;  ///< The role of facets that are shaded, beside their fill.
  std::shared_ptr<const Convex> shape;
  bool is_opaque = false;  ///< Lines behind it are drawn as hidden, if they have a role for that.
  Subject subject = {};
  bool is_whole = true;
  std::vector<Facet> parts = {};  ///< Parts of the facets, once it is not whole.
  std::size_t index = 0;
};

/// A line, or a disk around a single point. It is painted over surfaces that it only touches.
struct LooseMark {
  std::string role;
  PointsInSpace points;
  std::string hidden = {};  ///< Its role behind opaque surfaces; empty: the same.
  Subject subject = {};
  double radius = 0.0;
};

/// Surfaces that touch keep the order in which they come.
[[nodiscard]] std::vector<Mark> in_order_of_depth(std::vector<PaintedSurface> surfaces,
                                                  std::vector<LooseMark> loose);

}  // namespace gjkscope
