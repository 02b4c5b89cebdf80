#include "subjects/hierarchy/table.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "lesson/settings_kind.hpp"

namespace gjkscope {
namespace {

constexpr double kLeastTile = 1e-3;

std::vector<LessonKey> tree_keys() {
  return {
      {"trees", "volumes", one_of(names_of<VolumeKind>()), "boxes",
       "what bounds the segments. With tiles, small circles cover the segments, larger circles "
       "bound those, and `query.tolerance` is the relative error that is allowed"},
      {"trees", "tile", fmt::format("number from {} to {}", kLeastTile, limits::kLargest), "0.5",
       "largest radius of these small circles; only with volumes = \"tiles\""},
  };
}

TourSettings read_trees(const TableSource& source) {
  LessonTrees trees;
  trees.volumes =
      source.reader.choice<VolumeKind>(source.table["volumes"], "volume").value_or(trees.volumes);
  const toml_file::Field tile = source.table["tile"];
  trees.tile = source.reader.number(tile, kLeastTile, limits::kLargest).value_or(trees.tile);
  if (tile && trees.volumes != VolumeKind::tiles)
    source.problems.add(tile.place(), "'tile' without tiles", "volumes = \"tiles\"");
  return TourSettings(trees);
}

void write_trees(const TourSettings& table, TomlText& out) {
  const LessonTrees& trees = *table.as<LessonTrees>();
  const LessonTrees defaults;
  out.table("[trees]");
  out.choice("volumes", trees.volumes, defaults.volumes);
  out.number("tile", trees.tile, defaults.tile);
  out.write_header();
}

}  // namespace

const SettingsKind LessonTrees::kKind = {"trees", "how trees of segments are built", tree_keys,
                                         read_trees, write_trees};

}  // namespace gjkscope
