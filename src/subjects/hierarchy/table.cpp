#include "subjects/hierarchy/table.hpp"

#include "lesson/settings_kind.hpp"

namespace gjkscope {
namespace {

constexpr double kLeastTile = 1e-3;

void tree_keys(KeyPass& keys, LessonTrees& trees) {
  keys("volumes", "",
       "what bounds the segments. With tiles, small circles cover the segments, larger circles "
       "bound those, and `query.tolerance` is the relative error that is allowed")
      .choice<VolumeKind>(trees.volumes, "volume");
  keys("tile", "", "largest radius of these small circles; only with volumes = \"tiles\"")
      .number(trees.tile, kLeastTile, limits::kLargest);
}

TourSettings read_trees(const TableSource& source) {
  LessonTrees trees;
  source.read_keys(source.table, tree_keys, trees);
  const toml_file::Field tile = source.table["tile"];
  if (tile && trees.volumes != VolumeKind::tiles)
    source.problems.add(tile.place(), "'tile' without tiles", "volumes = \"tiles\"");
  return TourSettings(trees);
}

void write_trees(const TourSettings& table, TomlText& out) {
  out.table("[trees]");
  out.lines(written_keys(*table.as<LessonTrees>(), tree_keys));
  out.write_header();
}

}  // namespace

const SettingsKind LessonTrees::kKind = {
    "trees", "how trees of segments are built",
    [] { return listed_keys<LessonTrees>("trees", tree_keys); }, read_trees, write_trees};

}  // namespace gjkscope
