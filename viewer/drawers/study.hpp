#pragma once
// The study of accuracy in the window: its dots, and the runs behind them.

#include <filesystem>
#include <string_view>

namespace gjkscope {

class App;

/// Results of a study, in the lesson that shows them.
void open_results(App& app, std::string_view json, const std::filesystem::path& file);

}  // namespace gjkscope
