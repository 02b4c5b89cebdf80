#include "fcl_models.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>

namespace bench {
namespace {

using Tree = fcl::BVHModel<fcl::RSSd>;

void fill(Tree& tree, const models::Model& model) {
  tree.beginModel();
  for (const models::Segment& s : model.segments) {
    const double height = (s.b - s.a).norm();
    tree.addTriangle({s.a.x(), s.a.y(), 0.0}, {s.b.x(), s.b.y(), 0.0}, {s.a.x(), s.a.y(), height});
  }
  tree.endModel();
}

}  // namespace

struct FclModels::Trees {
  Tree x;
  Tree y;
};

FclModels::FclModels(const models::Model& x, const models::Model& y)
    : trees_(std::make_unique<Trees>()) {
  fill(trees_->x, x);
  fill(trees_->y, y);
}
FclModels::~FclModels() = default;

double FclModels::distance() const {
  fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  return fcl::distance(&trees_->x, fcl::Transform3d::Identity(), &trees_->y,
                       fcl::Transform3d::Identity(), request, result);
}

}  // namespace bench
