#pragma once
// The names by which files, the command line and captions call the values of enumerations. One
// table each; parsing, printing and error messages read the same one.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gjk/proof/result.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

template <class E>
struct Named;  // specialised below and beside its enumeration: static constexpr kTable of (name,
               // value)

template <>
struct Named<ScalarKind> {
  static constexpr std::array<std::pair<std::string_view, ScalarKind>, 4> kTable = {
      {{"half", ScalarKind::half},
       {"float", ScalarKind::single},
       {"double", ScalarKind::double_},
       {"exact", ScalarKind::exact}}};
};
template <>
struct Named<ViewKind> {
  static constexpr std::array<std::pair<std::string_view, ViewKind>, 2> kTable = {
      {{"world", ViewKind::world}, {"difference", ViewKind::difference}}};
};
template <>
struct Named<CardCorner> {
  static constexpr std::array<std::pair<std::string_view, CardCorner>, 4> kTable = {
      {{"top left", CardCorner::top_left},
       {"top right", CardCorner::top_right},
       {"bottom left", CardCorner::bottom_left},
       {"bottom right", CardCorner::bottom_right}}};
};
template <>
struct Named<gjk::Phase> {
  static constexpr std::array<std::pair<std::string_view, gjk::Phase>, 6> kTable = {
      {{"closest", gjk::Phase::closest},
       {"drop", gjk::Phase::drop},
       {"direction", gjk::Phase::direction},
       {"support", gjk::Phase::support},
       {"stop", gjk::Phase::stop},
       {"add", gjk::Phase::add}}};
};
template <>
struct Named<gjk::StopReason> {
  static constexpr std::array<std::pair<std::string_view, gjk::StopReason>, 9> kTable = {
      {{"running", gjk::StopReason::running},
       {"repeated-support", gjk::StopReason::repeated_support},
       {"origin-inside", gjk::StopReason::origin_inside},
       {"zero-direction", gjk::StopReason::zero_direction},
       {"not-nearer", gjk::StopReason::not_nearer},
       {"no-progress", gjk::StopReason::no_progress},
       {"within-tolerance", gjk::StopReason::within_tolerance},
       {"iteration-cap", gjk::StopReason::iteration_cap},
       {"failed", gjk::StopReason::failed}}};
};
template <>
struct Named<gjk::Verdict> {
  static constexpr std::array<std::pair<std::string_view, gjk::Verdict>, 5> kTable = {
      {{"separated", gjk::Verdict::separated},
       {"touching", gjk::Verdict::touching},
       {"overlapping", gjk::Verdict::overlapping},
       {"undecided", gjk::Verdict::undecided},
       {"none", gjk::Verdict::none}}};
};
template <>
struct Named<gjk::Error> {
  static constexpr std::array<std::pair<std::string_view, gjk::Error>, 9> kTable = {
      {{"none", gjk::Error::none},
       {"x-has-no-vertices", gjk::Error::x_has_no_vertices},
       {"y-has-no-vertices", gjk::Error::y_has_no_vertices},
       {"x-not-finite", gjk::Error::x_not_finite},
       {"y-not-finite", gjk::Error::y_not_finite},
       {"overflow", gjk::Error::overflow},
       {"underflow", gjk::Error::underflow},
       {"bad-start", gjk::Error::bad_start},
       {"bad-options", gjk::Error::bad_options}}};
};
template <>
struct Named<gjk::DirectionRule> {
  static constexpr std::array<std::pair<std::string_view, gjk::DirectionRule>, 2> kTable = {
      {{"perpendicular", gjk::DirectionRule::perpendicular},
       {"towards-origin", gjk::DirectionRule::towards_origin}}};
};
template <>
struct Named<gjk::RegionOrder> {
  static constexpr std::array<std::pair<std::string_view, gjk::RegionOrder>, 3> kTable = {
      {{"vertices-first", gjk::RegionOrder::vertices_first},
       {"edges-first", gjk::RegionOrder::edges_first},
       {"unchecked", gjk::RegionOrder::unchecked}}};
};

template <class E>
[[nodiscard]] constexpr std::string_view name_of(E value) {
  for (const auto& [name, candidate] : Named<E>::kTable) {
    if (candidate == value) return name;
  }
  return "?";
}

template <class E>
[[nodiscard]] constexpr std::optional<E> value_of(std::string_view name) {
  for (const auto& [candidate, value] : Named<E>::kTable) {
    if (candidate == name) return value;
  }
  return std::nullopt;
}

template <class E>
[[nodiscard]] std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (const auto& [name, value] : Named<E>::kTable) names.emplace_back(name);
  return names;
}

}  // namespace gjkscope
