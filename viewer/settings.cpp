#include "settings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file.hpp"

namespace gjkscope {
namespace {

template <class T>
void read(const nlohmann::json& from, const char* key, T& value) {
  const auto found = from.find(key);
  if (found == from.end()) return;
  try {
    value = found->get<T>();
  } catch (const nlohmann::json::exception&) {
    // A value of another type counts as none.
  }
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
  Settings out;
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return out;
  std::string text;
  try {
    text = read_whole(file);
  } catch (const std::runtime_error&) {
    return out;
  }
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return out;
  read(json, "theme", out.theme);
  read(json, "panel_size", out.panel_size);
  read(json, "frames_per_second", out.frames_per_second);
  read(json, "lessons", out.lessons);
  read(json, "thumbnails", out.thumbnails);
  read(json, "motion", out.motion);
  read(json, "snaps", out.snaps);
  read(json, "hexadecimal", out.hexadecimal);
  read(json, "drawers", out.drawers);
  if (const auto exported = json.find("export"); exported != json.end() && exported->is_object()) {
    read(*exported, "folder", out.exported.folder);
    read(*exported, "format", out.exported.format);
    read(*exported, "theme", out.exported.theme);
    read(*exported, "width", out.exported.width);
    read(*exported, "height", out.exported.height);
    read(*exported, "transparent", out.exported.transparent);
    read(*exported, "stage_only", out.exported.stage_only);
  }
  return out;
}

std::string settings_text(const Settings& settings) {
  const nlohmann::ordered_json json = {{"theme", settings.theme},
                                       {"panel_size", settings.panel_size},
                                       {"frames_per_second", settings.frames_per_second},
                                       {"lessons", settings.lessons},
                                       {"thumbnails", settings.thumbnails},
                                       {"motion", settings.motion},
                                       {"snaps", settings.snaps},
                                       {"hexadecimal", settings.hexadecimal},
                                       {"drawers", settings.drawers},
                                       {"export",
                                        {{"folder", settings.exported.folder},
                                         {"format", settings.exported.format},
                                         {"theme", settings.exported.theme},
                                         {"width", settings.exported.width},
                                         {"height", settings.exported.height},
                                         {"transparent", settings.exported.transparent},
                                         {"stage_only", settings.exported.stage_only}}}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gjkscope
