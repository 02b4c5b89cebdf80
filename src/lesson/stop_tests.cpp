#include "lesson/stop_tests.hpp"

namespace gjkscope {

std::optional<std::array<bool, 2>> read_stop_tests(toml_file::Reader& reader,
                                                   const toml_file::Field& field) {
  if (!field) return std::nullopt;
  const std::vector<std::string> known(kStopTestNames.begin(), kStopTestNames.end());
  const std::vector<toml_file::Field> entries =
      reader.entries(field, "one of: repeated-support, no-progress (the others always apply)");
  if (!field.node->is_array()) return std::nullopt;
  std::array<bool, 2> on{};
  for (const toml_file::Field& entry : entries) {
    const std::optional<std::string> name = reader.name(entry, "stop test", known);
    for (std::size_t i = 0; i < known.size(); ++i) on[i] = on[i] || name == known[i];
  }
  return on;
}

void write_stop_tests(TomlText& out, const std::array<bool, 2>& tests) {
  std::vector<std::string> on;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (tests[i]) on.push_back(as_text(kStopTestNames[i]));
  }
  out.list("stop", on);
}

}  // namespace gjkscope
