#pragma once
// Changes some values of a TOML text and leaves the rest of it, comments and layout, as it is.

#include <string>
#include <string_view>

namespace gjkscope {

/// `original`, with the changes that lead from `before` to `after`. These two are texts of
/// TomlText: what `original` means, and what it shall mean. Tables and keys are told apart by their
/// names, tables of an array by their place in it. A value that stays keeps its spelling, and so do
/// the entries of a list that do. Comments of what goes stay, each on a line of its own.
///
/// Dotted keys, and tables that are written in another way than those of TomlText, are not found:
/// whoever calls this reads the result, and compares what it means with what it shall mean.
[[nodiscard]] std::string patched_toml(std::string_view original, std::string_view before,
                                       std::string_view after);

}  // namespace gjkscope
