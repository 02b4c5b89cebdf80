#pragma once
// The study's results as files and words.

#include <filesystem>
#include <string>
#include <string_view>

#include "study/accuracy.hpp"

namespace gjkscope::study {

/// One line a row after a line of names. Lines that begin with # come first and tell where and how
/// it was measured. A number that is none is an empty field. Has all but the worst cases.
[[nodiscard]] std::string to_csv(const Study& study);
/// Reads what `to_csv` wrote. Throws std::runtime_error, with the line, for anything else.
[[nodiscard]] Study from_csv(std::string_view text);

/// Everything, the worst cases included. Numbers that are none or infinite are null.
[[nodiscard]] std::string to_json(const Study& study);

/// Names of families: of a summary's rows, and of the one that is not hard.
inline constexpr std::string_view kAllFamilies = "all families";
inline constexpr std::string_view kOrdinary = "random";

/// Rows over all families instead of those of each, under the name kAllFamilies: errors are the
/// largest, counts are added up, times are geometric means of medians. Only of configurations that
/// answered all families. The ordinary family, those that differ by size, and what starts cost in
/// motion, stay as they are.
[[nodiscard]] Study summary(const Study& study);

/// For a terminal: the summary, and the front of each family.
[[nodiscard]] std::string table(const Study& study);

/// Advice on what to use to be sure of so many digits, what it costs, and what each choice does, as
/// Markdown. Made from a summary alone.
[[nodiscard]] std::string advice(const Study& summary);

/// One page that needs nothing else: error against time for each family. `html`: the template
/// (assets/accuracy.html).
[[nodiscard]] std::string page(const Study& study, std::string html);

}  // namespace gjkscope::study
