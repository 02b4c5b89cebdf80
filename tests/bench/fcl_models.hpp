#pragma once
// FCL (BSD licence) asked for the distance of two outlines: each segment is a triangle that stands
// on it, so that distances are those in the plane.

#include <memory>

#include "outlines/outline.hpp"

namespace bench {

class FclModels {
 public:
  FclModels(const models::Model& x, const models::Model& y);
  ~FclModels();
  [[nodiscard]] double distance() const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace bench
