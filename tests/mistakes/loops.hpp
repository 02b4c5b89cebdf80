#pragma once
// The loops of src/mistakes, and the logs that they write by gjkscope_log.h.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "judge/gjkscope_log.h"
#include "mistakes/all.hpp"

namespace mistakes {

using Polygon = std::vector<Eigen::Vector2d>;

/// A log, as the text that it is.
class Writer {
 public:
  Writer(const Polygon& x, const Polygon& y) {
    gjkscope_log_begin(&log_, file_, 2, GJKSCOPE_B_MINUS_A, "double");
    for (const auto& p : x) gjkscope_log_vertex(&log_, "a", p.x(), p.y(), 0);
    for (const auto& p : y) gjkscope_log_vertex(&log_, "b", p.x(), p.y(), 0);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() {
    std::fclose(file_);
    std::free(text_);  // NOLINT(cppcoreguidelines-no-malloc): of open_memstream
  }

  // The notes of the loop.
  void simplex(const auto& simplex) {
    gjkscope_log_iteration(&log_);
    for (const auto& v : simplex) gjkscope_log_pair(&log_, "simplex", v.index_x, v.index_y);
    for (const auto& v : simplex) gjkscope_log_point(&log_, "points", v.w.x(), v.w.y(), 0);
  }
  void kept(const auto& simplex) {
    for (const auto& v : simplex) gjkscope_log_pair(&log_, "kept", v.index_x, v.index_y);
    for (const auto& v : simplex) gjkscope_log_weight(&log_, v.weight);
    const Eigen::Vector2d p = closest(simplex);
    gjkscope_log_vector(&log_, "closest", p.x(), p.y(), 0);
  }
  void step(const Eigen::Vector2d& d, int far_x, int far_y) {
    gjkscope_log_vector(&log_, "direction", d.x(), d.y(), 0);
    gjkscope_log_support(&log_, far_x, far_y);
  }

  /// The log whose run ended with this simplex.
  std::string ended(const auto& simplex) {
    gjkscope_log_answer(&log_);
    gjkscope_log_number(&log_, "distance", closest(simplex).norm());
    gjkscope_log_overlap(&log_, simplex.size() == 3);
    gjkscope_log_end(&log_);
    return {text_, size_};
  }

 private:
  /// O where the loop takes it for inside.
  static Eigen::Vector2d closest(const auto& simplex) {
    Eigen::Vector2d p(0, 0);
    if (simplex.size() == 3) return p;
    for (const auto& v : simplex) p += v.weight * v.w;
    return p;
  }

  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* file_ = open_memstream(&text_, &size_);
  gjkscope_log log_;
};

inline constexpr int kCap = 64;

struct Loop {
  std::string_view name;
  std::string (*log_of)(const Polygon& x, const Polygon& y);  ///< The log of its run.
};
#define MISTAKE(name, file_name, meaning, line, by)                \
  Loop{#name, [](const Polygon& x, const Polygon& y) {             \
         Writer log(x, y);                                         \
         return log.ended(::name::gjk({x, y}, kCap, log).simplex); \
       }},
inline const std::vector<Loop> kLoops = {
#include "mistakes/mistakes.def"
};
#undef MISTAKE

inline const Loop& loop(std::string_view name) {
  for (const Loop& each : kLoops) {
    if (each.name == name) return each;
  }
  std::abort();
}

}  // namespace mistakes
