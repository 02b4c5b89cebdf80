#pragma once
// Lessons as web pages: `gjkscope export --format html`. A page is one file that opens offline and
// holds all that it needs; pages of a site have what they need once beside them.

#include <filesystem>
#include <string>
#include <vector>

#include "lesson/lesson.hpp"

namespace gjkscope {

struct SiteOptions {
  std::filesystem::path out_dir;  ///< Made when it is not there.
  std::filesystem::path share;    ///< Holds assets/, and web/ or build/wasm/web/ with the program
                                  ///< for browsers.
  bool index = false;   ///< Also an index of the lessons, a playground and a page about them all,
                        ///< and links between the pages.
  bool single = false;  ///< Also with an index each page is one file.
  bool force = false;   ///< Replace files that were not exported.
  std::string file_name = {};  ///< For the one page that is asked for; empty: by lesson.
  bool package = false;  ///< A package for npm: an element and functions, and in its folder pages/
                         ///< pages that share, a playground among them.
};

/// Writes `<lesson>.html` for each lesson; with `index` also index.html, playground.html and
/// about.html, and, unless `single`, what they share: shared/, cards/ and service-worker.js. With
/// `package` the folder is one that `npm pack` takes. Each
/// file appears whole or not at all; the same lessons give the same bytes. Throws
/// std::runtime_error, naming the path, when something cannot be read or written, or would replace
/// what was not exported; when there is no program for browsers it says how to build it.
[[nodiscard]] std::vector<std::filesystem::path> export_site(const std::vector<Lesson>& lessons,
                                                             const SiteOptions& wanted);

}  // namespace gjkscope
