// The division of the window among its parts, at any size.

#include "room.hpp"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "command_line.hpp"
#include "density.hpp"
#include "headless_app.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "settings.hpp"
#include "system_fonts.hpp"

namespace gjkscope {
namespace room_test {

namespace fs = std::filesystem;
using nlohmann::json;
using test::HeadlessApp;
using test::TemporaryFolder;
using Kind = Subject::Kind;

json state(HeadlessApp& window) { return json::parse(window.app().state_json()); }

struct Size {
  double width;
  double height;
};
constexpr Size kSizes[] = {{520, 400},  {800, 600},   {1024, 768}, {1280, 800},
                           {1440, 900}, {1920, 1080}, {3840, 2160}};

TEST(Room, TypeIsNeverBelowTwelvePixels) {
  constexpr double kSmallestType = 16.0;  // of a page, frame pixels
  for (const Size& size : kSizes) {
    for (const char* drawer : {"", "Steps", "Values"}) {
      HeadlessApp window;
      window.resize(size.width, size.height);
      if (*drawer) window.app().show_drawer(drawer);
      window.settle();
      EXPECT_GE(window.session().page().zoom * kSmallestType, 12.0)
          << size.width << "x" << size.height << " " << drawer;
      EXPECT_GE(15.0 * kSmallestPanels, 12.0);
    }
  }
}

TEST(Room, TheChromeFoldsBeforeTheStageShrinks) {
  HeadlessApp window;
  for (const Size& size : kSizes) {
    window.resize(size.width, size.height);
    const Room& room = window.app().room();
    const bool is_whole = !window.session().page().bare;
    EXPECT_TRUE(room.folded || is_whole) << size.width << "x" << size.height;
    EXPECT_EQ(size.width < 1000, room.folded) << size.width << "x" << size.height;
    // One row, whatever the width.
    EXPECT_LE(ImGui::FindWindowByName("##top")->Rect().GetHeight(), 1.01 * room.bar);
  }
  window.resize(800.0, 600.0);
  EXPECT_FALSE(window.session().page().bare) << "the whole page, under one bar";
  window.resize(520.0, 400.0);
  EXPECT_TRUE(window.session().page().bare) << "stages and captions alone";
}

TEST(Room, NothingIsCutInTheBars) {
  for (const Size& size : kSizes) {
    HeadlessApp window;
    window.app().show_drawer("Numerics");
    window.resize(size.width, size.height);
    window.key("End");
    for (const char* name : {"##top", "##transport"}) {
      const ImGuiWindow* bar = ImGui::FindWindowByName(name);
      if (!bar || !bar->WasActive) continue;
      EXPECT_LE(bar->ContentSize.x, bar->Rect().GetWidth())
          << name << " " << size.width << "x" << size.height;
    }
  }
}

TEST(Room, ADrawerIsWidenedByItsEdgeAndKeepsItsWidth) {
  const TemporaryFolder folder;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    window.app().show_drawer("Values");
    window.settle();
    const double before = window.app().room().drawer;
    const double edge = 1440.0 - before;
    window.drag({edge + 2.0, 400.0}, {edge - 100.0, 400.0});
    EXPECT_NEAR(window.app().room().drawer, before + 100.0, 3.0);
    window.app().show_drawer("Shapes");
    window.settle();
    EXPECT_EQ(before, window.app().room().drawer) << "each has its own";
    window.app().show_drawer("Values");
    window.settle();
    EXPECT_NEAR(window.app().room().drawer, before + 100.0, 3.0);
  }
  HeadlessApp again("polygons-gjk", folder.path());
  again.app().show_drawer("Values");
  again.settle();
  EXPECT_NEAR(again.app().room().drawer, kDrawerWidth + 100.0, 3.0);
}

TEST(Room, StepsShowAllTheirColumns) {
  HeadlessApp window;
  window.resize(1920.0, 1080.0);
  window.app().show_drawer("Steps");
  window.settle();
  for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
    if (!each->WasActive || std::string(each->Name).find("##steps") == std::string::npos) continue;
    EXPECT_EQ(0.0f, each->ScrollMax.x);
    return;
  }
  FAIL() << "there is no table";
}

TEST(Room, StepsShowAllTheirValuesWhereTheyHaveNoRoomForAllColumns) {
  for (const auto& [width, height] : {std::pair(1024.0, 768.0), {1280.0, 800.0}}) {
    HeadlessApp window;
    window.resize(width, height);
    window.app().show_drawer("Steps");
    window.settle();
    EXPECT_FALSE(window.app().room().drawer_is_over);
    EXPECT_GE(window.app().picture().area().size().x(), kStageWidth);
    const auto table = [&]() -> const ImGuiWindow* {
      for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        if (each->WasActive && std::string(each->Name).find("##steps") != std::string::npos)
          return each;
      }
      return nullptr;
    };
    ASSERT_TRUE(table());
    EXPECT_EQ(0.0f, table()->ScrollMax.y) << "all values";
    EXPECT_GT(table()->ScrollMax.x, 0.0f) << "of many steps";
    window.key("End");
    EXPECT_GT(table()->Scroll.x, 0.0f) << "this one in sight";
  }
}

TEST(Room, CardsAreNoStripsBesideAWideDrawer) {
  HeadlessApp window;
  for (double width = 900.0; width <= 1500.0; width += 50.0) {
    for (const char* drawer : {"", "Steps", "Values"}) {
      window.resize(width, 800.0);
      if (*drawer != '\0') window.app().show_drawer(drawer);
      window.settle();
      for (const auto& view : window.session().views())
        EXPECT_GT(view.card.size().y(), 0.35 * view.card.size().x()) << width << drawer;
      window.app().show_drawer(drawer, false);
    }
  }
}

TEST(Room, ADrawerWithoutRoomLiesOverTheStage) {
  HeadlessApp window;
  window.resize(800.0, 600.0);
  const Rect stage = window.app().picture().area();
  window.app().show_drawer("Values");
  window.settle();
  EXPECT_TRUE(window.app().room().drawer_is_over);
  EXPECT_EQ(stage, window.app().picture().area()) << "which does not shrink";
  EXPECT_GT(window.app().room().drawer, 200.0);
}

TEST(Room, LessonsAreReachedAtEveryWidth) {
  for (const Size& size : kSizes) {
    HeadlessApp window;
    window.resize(size.width, size.height);
    if (state(window)["lessons"] == true) window.key("L");
    EXPECT_EQ(false, state(window)["lessons"]) << size.width;
    window.key("L");
    EXPECT_EQ(true, state(window)["lessons"]) << size.width;
    window.settle();
    const ImGuiWindow* list = ImGui::FindWindowByName("##lessons");
    ASSERT_TRUE(list && list->WasActive) << size.width;
    window.key("L");
    EXPECT_EQ(false, state(window)["lessons"]) << size.width;
  }
}

TEST(Room, ADenseScreenAndAScaleEnlargeStageAndPanels) {
  EXPECT_EQ(192.0, dpi_of_resources("*foo: 1\nXft.antialias:\t1\nXft.dpi:\t192\n"));
  EXPECT_FALSE(dpi_of_resources("Xft.hinting:\t1\n"));
  EXPECT_FALSE(dpi_of_resources("Xft.dpi:\tmany\n"));
  EXPECT_EQ(1.0, scale_of_dpi(96.0));
  EXPECT_EQ(1.0, scale_of_dpi(72.0));
  EXPECT_EQ(1.5, scale_of_dpi(144.0));
  EXPECT_EQ(2.0, scale_of_dpi(192.0));
  HeadlessApp window;
  window.resize(1440.0, 900.0);
  const double type = window.session().page().zoom;
  window.resize(2880.0, 1800.0, 2.0);
  EXPECT_EQ(2.0, window.app().ui_scale());
  EXPECT_NEAR(2.0 * type, window.session().page().zoom, 0.05);
  window.resize(3840.0, 2160.0);
  EXPECT_EQ(2.0, window.app().ui_scale()) << "on a screen that does not say that it is dense";
}

TEST(Room, AWayHomeIsThereWhenNothingIsInSight) {
  HeadlessApp window;
  EXPECT_TRUE(window.app().picture().empty_cards().empty());
  const LessonPictures::ShownView view = window.session().views()[0];
  window.session().set_camera(0, {view.camera.center + Eigen::Vector3d(500.0, 0.0, 0.0), 3.0});
  window.settle();
  ASSERT_EQ(1u, window.app().picture().empty_cards().size());
  window.click(window.app().picture().empty_cards()[0].center() + Point(-40.0, 12.0));
  EXPECT_TRUE(window.app().picture().empty_cards().empty()) << "its button leads back";
}

TEST(Room, NoLessonIsAstrayAsItOpens) {
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    HeadlessApp window(lesson.id);
    EXPECT_TRUE(window.app().picture().empty_cards().empty()) << lesson.id << ", at the start";
    window.key("End");
    EXPECT_TRUE(window.app().picture().empty_cards().empty()) << lesson.id << ", at the end";
  }
}

TEST(Room, InsideOfAShapeIsNotNowhere) {
  HeadlessApp window;
  const auto world = in_plane(window.session().run().runs[0].bodies[1].world);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& vertex : world) middle += vertex / static_cast<double>(world.size());
  window.session().set_camera(0, {in_space(middle), 1e-3});
  EXPECT_TRUE(window.app().picture().empty_cards().empty());
}

TEST(Room, TheLayoutDoesNotDependOnTheWayToIt) {
  const auto cards = [](HeadlessApp& window) {
    std::vector<Rect> out;
    for (const auto& view : window.session().views()) out.push_back(view.card);
    return out;
  };
  for (const char* drawer : {"Values", "Steps", "Shapes"}) {
    HeadlessApp fresh;
    fresh.app().show_drawer(drawer);
    fresh.settle();
    HeadlessApp worked;
    const Point at = worked.at({Kind::vertex_of_x, 2});
    worked.drag(at, at + Point(40.0, 10.0));
    worked.key("Z", true);
    worked.app().show_drawer(drawer);
    worked.settle();
    EXPECT_EQ(cards(fresh), cards(worked)) << drawer;
  }
}

TEST(Room, SettingsAreRemembered) {
  const TemporaryFolder folder;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    window.key("T");
    window.key("L");
    window.key("]");
    window.key("=", true);
    window.key("G");
    EXPECT_NE("light", window.app().theme_name());
  }
  HeadlessApp again("polygons-gjk", folder.path());
  EXPECT_NE("light", again.app().theme_name());
  EXPECT_EQ(false, state(again)["lessons"]);
  EXPECT_FALSE(again.app().last_export) << "nothing was exported";
  EXPECT_EQ(1.125, again.app().ui_scale());
  EXPECT_TRUE(again.app().snaps());
}

TEST(Room, SettingsThatCannotBeReadAreAsAtFirst) {
  const TemporaryFolder folder;
  for (const char* text :
       {"", "{", "[]", R"({"theme": 3, "panel_size": "large", "drawers": [1]})"}) {
    EXPECT_EQ(Settings{}, read_settings(folder.file("settings", text))) << text;
  }
  EXPECT_EQ(Settings{}, read_settings(folder.path() / "none"));
  (void)folder.file("settings", R"({"theme": "no such", "panel_size": 1000, "snaps": true})");
  HeadlessApp window("polygons-gjk", folder.path());
  EXPECT_EQ("light", window.app().theme_name());
  EXPECT_EQ(kLargestPanels, window.app().ui_scale());
  Settings settings;
  settings.drawers["Steps"] = 612.5;
  settings.theme = "dark";
  settings.exported = {"/tmp/talk", "pdf", "print", 1920, 1080, true, true};
  EXPECT_EQ(settings, read_settings(folder.file("settings", settings_text(settings))));
}

TEST(Room, TheFirstStartSaysWhereToBeginAndALaterOneCanBeAsked) {
  const TemporaryFolder folder;
  {
    HeadlessApp window("", folder.path());
    EXPECT_EQ(true, state(window)["welcome"]);
    for (int i = 0; i < 100; ++i) window.frame(1.0);
    EXPECT_EQ(true, state(window)["welcome"]) << "it does not go by itself";
    window.key("Right");
    window.settle();
    EXPECT_EQ(false, state(window)["welcome"]) << "who has begun knows";
  }
  HeadlessApp again("", folder.path());
  EXPECT_EQ(false, state(again)["welcome"]);
  again.app().run_command("Where to begin");
  again.settle();
  EXPECT_EQ(true, state(again)["welcome"]);
  again.key("Escape");
  EXPECT_EQ(false, state(again)["welcome"]);
}

TEST(Room, AMenuTakesKeys) {
  HeadlessApp window;
  const auto open = [&] {
    const ImGuiWindow* bar = ImGui::FindWindowByName("##top");
    window.click({bar->Pos.x + 25.0, bar->Pos.y + 0.5 * bar->Size.y});
    window.settle();
  };
  const auto is_open = [] { return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0; };
  const int index = window.session().index();
  open();
  ASSERT_TRUE(is_open());
  window.key("Escape");
  EXPECT_FALSE(is_open());
  open();
  window.key("Down");
  window.key("Enter");
  EXPECT_TRUE(window.app().has_dialog()) << "the first of File is Open";
  EXPECT_EQ(index, window.session().index());
}

TEST(Room, AListOpenedByTheMouseTakesKeys) {
  HeadlessApp window;
  window.app().show_drawer("Numerics");
  window.settle();
  const ImGuiWindow* drawer = ImGui::FindWindowByName("##drawer");
  const auto is_open = [] { return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0; };
  // The first list of the drawer is that of scalars.
  for (float y = drawer->Pos.y + 30.0f; !is_open() && y < drawer->Pos.y + 200.0f; y += 8.0f)
    window.click({drawer->Pos.x + drawer->Size.x - 60.0, y});
  ASSERT_TRUE(is_open());
  const ScalarKind before = window.session().lesson().scalar;
  window.key("Down");
  window.key("Enter");
  EXPECT_FALSE(is_open());
  EXPECT_NE(before, window.session().lesson().scalar);
}

TEST(Room, AnotherMenuOpensUnderThePointer) {
  HeadlessApp window;
  const ImGuiWindow* bar = ImGui::FindWindowByName("##top");
  const double y = bar->Pos.y + 0.5 * bar->Size.y;
  window.click({bar->Pos.x + 25.0, y});
  const ImGuiID file = ImGui::GetCurrentContext()->OpenPopupStack.back().PopupId;
  window.move({bar->Pos.x + 75.0, y});
  ASSERT_GT(ImGui::GetCurrentContext()->OpenPopupStack.Size, 0);
  EXPECT_NE(file, ImGui::GetCurrentContext()->OpenPopupStack.back().PopupId);
}

TEST(Room, AClickTakesTheKeyboardBackFromThePanels) {
  HeadlessApp window;
  window.key("F6");
  EXPECT_TRUE(window.app().panels_have_keys());
  EXPECT_FALSE(ImGui::GetCurrentContext()->NavDisableHighlight) << "and it shows";
  window.click(window.at({Kind::shape_y}));
  EXPECT_FALSE(window.app().panels_have_keys());
  window.key("F6");
  window.key("F6");
  const ImGuiWindow* list = ImGui::FindWindowByName("##lessons");
  ASSERT_TRUE(list);
  window.click({list->Pos.x + 120.0, list->Pos.y + 100.0});
  EXPECT_FALSE(window.app().panels_have_keys());
}

/// The window of this name, or part of one, that is seen now.
const ImGuiWindow* seen(const std::string& part) {
  for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
    if (each->Active && !each->Hidden && std::string(each->Name).find(part) != std::string::npos)
      return each;
  }
  return nullptr;
}

TEST(Room, WordsAboutAThingLieBesideIt) {
  HeadlessApp window;
  const auto words_cover = [&](const char* panel) {
    const ImGuiWindow* bar = ImGui::FindWindowByName(panel);
    int count = 0;
    const float middle = bar->Pos.y + 0.5f * ImGui::GetFrameHeight() + 8.0f;
    for (float x = bar->Pos.x + 4.0f; x < bar->Pos.x + bar->Size.x; x += 9.0f) {
      window.move({x, middle});
      const ImGuiWindow* words = seen("##Tooltip");
      if (!words) continue;
      ++count;
      const bool is_beside = words->Pos.y >= middle || words->Pos.y + words->Size.y <= middle;
      EXPECT_TRUE(is_beside) << panel << " " << x;
    }
    return count;
  };
  EXPECT_GT(words_cover("##top"), 20);
  EXPECT_GT(words_cover("##transport"), 20);
  window.app().show_drawer("Effects");
  window.settle();
  const ImGuiWindow* drawer = ImGui::FindWindowByName("##drawer");
  int count = 0;
  for (float y = drawer->Pos.y + 60.0f; y < drawer->Pos.y + 400.0f; y += 9.0f) {
    window.move({drawer->Pos.x + 20.0f, y});
    const ImGuiWindow* words = seen("##Tooltip");
    if (!words) continue;
    ++count;
    EXPECT_LE(words->Pos.x + words->Size.x, drawer->Pos.x + 8.0f) << y;
  }
  EXPECT_GT(count, 10);
}

TEST(Room, ASearchThatFindsNothingSaysSo) {
  HeadlessApp window;
  window.key("/");
  window.type("zzzz");
  const ImGuiWindow* list = seen("##list");
  ASSERT_TRUE(list);
  EXPECT_GT(list->ContentSize.y, 0.0f) << "there is a line in it";
  EXPECT_LT(list->ContentSize.y, 2.0f * ImGui::GetTextLineHeightWithSpacing());
}

TEST(Room, FieldsShowAllDigitsOfACoordinate) {
  HeadlessApp window;
  window.resize(1280.0, 800.0);
  window.app().show_drawer("Shapes");
  window.settle();
  const auto height = [&] { return ImGui::FindWindowByName("##drawer")->ContentSize.y; };
  const double edge = ImGui::FindWindowByName("##edge")->Pos.x + 2.0;
  window.drag({edge, 400.0}, {edge + 150.0, 400.0});
  const float short_numbers = height();
  Lesson lesson = window.session().lesson();
  lesson.x().vertices[0] = {-59.852055103169033, -2.2734748438784972, 0.0};
  ASSERT_TRUE(window.app().edit("long", lesson));
  window.settle();
  EXPECT_GT(height(), short_numbers) << "x and y stand below each other where they are long";
  window.app().hexadecimal = true;
  window.settle();
  EXPECT_GT(height(), short_numbers);
}

TEST(Room, WordsOfPanelsHaveContrast) {
  const auto luminance = [](const ImVec4& c) {
    const auto linear = [](double v) {
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
  };
  const auto contrast = [&](const ImVec4& a, const ImVec4& b) {
    const double x = luminance(a) + 0.05;
    const double y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
  };
  HeadlessApp window;
  for (int i = 0; i < 4; ++i) {
    const ImVec4* colors = ImGui::GetStyle().Colors;
    for (const ImGuiCol words : {ImGuiCol_Text, ImGuiCol_TextDisabled}) {
      for (const ImGuiCol ground : {ImGuiCol_WindowBg, ImGuiCol_FrameBg, ImGuiCol_Button,
                                    ImGuiCol_TableRowBgAlt, ImGuiCol_TableHeaderBg})
        EXPECT_GE(contrast(colors[words], colors[ground]), 4.5)
            << window.app().theme_name() << " " << words << " on " << ground;
    }
    window.key("T");
  }
}

TEST(Room, ARandomPairIsInSight) {
  HeadlessApp window;
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(window.app().run_command("Random pair"));
    window.settle();
    const LessonPictures::ShownView view = window.session().views()[0];
    const Eigen::Vector2d half =
        0.5 * view.camera.units_per_pixel(view.card.size().y()).cwiseProduct(view.card.size());
    for (const auto& body : window.session().run().runs[0].bodies) {
      for (const Eigen::Vector2d& vertex : in_plane(body.world))
        EXPECT_TRUE(
            ((vertex - in_plane(view.camera.center)).cwiseAbs().array() <= half.array()).all());
    }
  }
}

TEST(Room, NamesInOtherScriptsHaveFonts) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "Привет-x-日本.toml";
  fs::copy_file(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "simplex.toml", file);
  HeadlessApp window(file.string());
  for (const char32_t c : code_points("Привет日本"))
    EXPECT_TRUE(window.app().characters().contains(c)) << static_cast<int>(c);
  EXPECT_FALSE(window.app().characters().contains(U'x')) << "those of ASCII are always there";
  const std::vector<SystemFont> fonts = system_fonts_for(U"\u0436\u05D0");
  std::u32string found;
  for (const SystemFont& font : fonts) {
    EXPECT_TRUE(fs::exists(font.file)) << font.file;
    found += font.characters;
  }
  EXPECT_NE(std::u32string::npos, found.find(U'\u0436'));
  EXPECT_EQ(found.size(), std::set<char32_t>(found.begin(), found.end()).size()) << "each once";
  EXPECT_TRUE(system_fonts_for(U"").empty());
}

TEST(Room, TheHandleThatTurnsCoversNoLabel) {
  HeadlessApp window;
  Session& session = window.session();
  for (const double by : {0.0, 0.5, 1.0, 1.5}) {
    Lesson lesson = session.lesson();
    edit::move_shape(lesson, 1, {-by, 0.0, 0.0});
    ASSERT_TRUE(window.app().edit("nearer", std::move(lesson)));
    window.app().picture().hand().selected = {Kind::shape_y};
    const std::optional<Point> at = window.app().picture().hand().handle();
    ASSERT_TRUE(at);
    for (const Mark& mark : session.picture().marks) {
      const Text* text = std::get_if<Text>(&mark.shape);
      if (!text || mark.clip < 0) continue;
      const Rect box = box_of(window.app().fonts(), *text);
      EXPECT_FALSE(is_in(box, *at)) << by << " " << text->text;
    }
  }
}

}  // namespace room_test
}  // namespace gjkscope
