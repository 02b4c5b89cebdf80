#include "study/configuration.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gjkscope::study {
namespace {

std::string_view arithmetic_name(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::half:
      return "half";
    case Arithmetic::single:
      return "float";
    case Arithmetic::single_in_double:
      return "float in double";
    case Arithmetic::double_:
      return "double";
    case Arithmetic::long_double:
      return "long double";
    case Arithmetic::quad:
      return "quad";
    case Arithmetic::exact:
      return "exact";
  }
  return "?";
}

bool has_other_rules(const gjk::Options& options) {
  return options.direction_rule != gjk::DirectionRule::perpendicular ||
         options.region_order != gjk::RegionOrder::vertices_first;
}

bool has_all_stops(const gjk::Options& options) {
  return options.stop_on_repeated_support && options.stop_on_no_progress;
}

}  // namespace

Configuration configuration(Arithmetic arithmetic, gjk::Proof proof) {
  Configuration out;
  out.arithmetic = arithmetic;
  out.options.proof = proof;
  return out;
}

std::string_view proof_name(gjk::Proof proof) {
  switch (proof) {
    case gjk::Proof::none:
      return "none";
    case gjk::Proof::bounds:
      return "bounds";
    case gjk::Proof::exact:
      return "exact";
  }
  return "?";
}

std::string name_of(const Configuration& configuration) {
  const gjk::Options& options = configuration.options;
  std::string name(arithmetic_name(configuration.arithmetic));
  if (options.proof == gjk::Proof::none) name += ", loop only";
  if (options.proof == gjk::Proof::bounds) name += ", bounds only";
  if (options.direction_rule == gjk::DirectionRule::towards_origin) name += ", towards O";
  if (options.region_order == gjk::RegionOrder::edges_first) name += ", edges first";
  if (options.region_order == gjk::RegionOrder::unchecked) name += ", regions unchecked";
  if (!options.stop_on_no_progress) name += ", stop: repeated support";
  if (!options.stop_on_repeated_support) name += ", stop: no progress";
  if (options.tolerance > 0.0) name += fmt::format(", tolerance {:.0e}", options.tolerance);
  if (options.iteration_cap != gjk::kDefaultIterationCap) {
    name += fmt::format(", cap {}", options.iteration_cap);
  }
  if (configuration.start == Start::first_vertices) name += ", first vertices";
  if (configuration.start == Start::warm) name += ", warm start";
  return name;
}

std::optional<Configuration> configuration_named(std::string_view name) {
  for (const auto& all : {configurations(false), configurations_by_size()}) {
    for (const Configuration& each : all) {
      if (name_of(each) == name) return each;
    }
  }
  return std::nullopt;
}

std::string_view axis_of(const Configuration& configuration) {
  const gjk::Options& options = configuration.options;
  if (options.tolerance > 0.0) return "tolerance";
  if (options.iteration_cap != gjk::kDefaultIterationCap) return "cap";
  if (!has_all_stops(options)) return "stop rule";
  if (has_other_rules(options)) return "direction and regions";
  if (configuration.start != Start::centers) return "start";
  return options.proof == gjk::Proof::exact ? "arithmetic" : "proof";
}

double unit_roundoff(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::half:
      return 0x1p-11;
    case Arithmetic::single:
      return 0x1p-24;
    case Arithmetic::long_double:
      return std::ldexp(1.0, -std::numeric_limits<long double>::digits);
    case Arithmetic::quad:
      return 0x1p-113;
    case Arithmetic::single_in_double:
    case Arithmetic::double_:
    case Arithmetic::exact:
      break;
  }
  return 0x1p-53;
}

std::vector<Configuration> configurations(bool quick) {
  using gjk::DirectionRule;
  using gjk::Proof;
  using gjk::RegionOrder;
  std::vector<Configuration> out = {{}};
  const auto add = [&](Arithmetic arithmetic, Proof proof) -> Configuration& {
    out.push_back(configuration(arithmetic, proof));
    return out.back();
  };

  constexpr Arithmetic kRounding[] = {Arithmetic::half,        Arithmetic::single,
                                      Arithmetic::double_,     Arithmetic::single_in_double,
                                      Arithmetic::long_double, Arithmetic::quad};
  for (const Arithmetic arithmetic : kRounding) {
    if (arithmetic != Arithmetic::double_) add(arithmetic, Proof::exact);
    add(arithmetic, Proof::bounds);
    add(arithmetic, Proof::none);
  }
  add(Arithmetic::exact, Proof::exact);

  for (const Arithmetic arithmetic : {Arithmetic::half, Arithmetic::single, Arithmetic::double_}) {
    for (const Proof proof : {Proof::none, Proof::exact}) {
      if (arithmetic == Arithmetic::half && proof == Proof::exact) continue;
      add(arithmetic, proof).options.direction_rule = DirectionRule::towards_origin;
      add(arithmetic, proof).options.region_order = RegionOrder::edges_first;
      add(arithmetic, proof).options.region_order = RegionOrder::unchecked;
      Configuration& both = add(arithmetic, proof);
      both.options.direction_rule = DirectionRule::towards_origin;
      both.options.region_order = RegionOrder::edges_first;
    }
  }

  for (const Proof proof : {Proof::none, Proof::exact}) {
    for (const Arithmetic arithmetic : {Arithmetic::single, Arithmetic::double_}) {
      add(arithmetic, proof).options.stop_on_no_progress = false;
      add(arithmetic, proof).options.stop_on_repeated_support = false;
    }
  }

  for (int digits = 1; digits <= 15; ++digits) {
    if (quick && digits % 3 != 0 && digits != 1) continue;
    const double tolerance = std::strtod(fmt::format("1e-{}", digits).c_str(), nullptr);
    add(Arithmetic::double_, Proof::exact).options.tolerance = tolerance;
    if (digits <= 6) add(Arithmetic::single, Proof::exact).options.tolerance = tolerance;
  }

  for (int cap = 1; cap <= 20; ++cap) {
    if (quick && cap > 4 && cap != 6 && cap != 10) continue;
    add(Arithmetic::double_, Proof::exact).options.iteration_cap = cap;
  }

  for (const Proof proof : {Proof::exact, Proof::none}) {
    add(Arithmetic::double_, proof).start = Start::first_vertices;
    add(Arithmetic::double_, proof).start = Start::warm;
  }
  return out;
}

std::vector<Configuration> configurations_by_size() {
  std::vector<Configuration> out = {{}};
  for (const Arithmetic arithmetic :
       {Arithmetic::single, Arithmetic::single_in_double, Arithmetic::long_double, Arithmetic::quad,
        Arithmetic::exact}) {
    out.push_back(configuration(arithmetic));
  }
  out.push_back(configuration(Arithmetic::double_, gjk::Proof::none));
  return out;
}

}  // namespace gjkscope::study
