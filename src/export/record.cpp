#include "export/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/file.hpp"
#include "base/hexadecimal.hpp"
#include "paint/png.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;

template <int D>
Json json_of(const CaseIn<D>& shapes) {
  const auto points = [](const std::vector<gjk::Vec<double, D>>& vertices) {
    Json list = Json::array();
    for (const auto& vertex : vertices) {
      Json numbers = Json::array();
      for (const double value : vertex) numbers.push_back(hexadecimal(value));
      list.push_back(std::move(numbers));
    }
    return list;
  };
  return {{"dimension", D}, {"a", points(shapes.a)}, {"b", points(shapes.b)}};
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string in_svg(std::string_view file) {
  constexpr std::string_view kBegin = "<metadata>";
  const std::size_t begin = file.find(kBegin);
  const std::size_t end = file.find("</metadata>", std::min(begin, file.size()));
  if (begin == std::string_view::npos || end == std::string_view::npos) return {};
  std::string text(file.substr(begin + kBegin.size(), end - begin - kBegin.size()));
  for (const auto& [from, to] :
       {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&quot;", "\""},
        std::pair{"&#39;", "'"}, std::pair{"&amp;", "&"}}) {
    replace_all(text, from, to);
  }
  return text;
}

/// A PDF string: in parentheses, where ( ) and \ have a \ before them, or hexadecimal, in UTF-16.
std::string in_pdf(std::string_view file) {
  constexpr std::string_view kKey = "/Keywords ";
  constexpr std::string_view kWide = "<FEFF";
  const std::size_t key = file.rfind(kKey);
  std::string text;
  if (key == std::string_view::npos) return text;
  const std::string_view value = file.substr(key + kKey.size());
  if (value.starts_with(kWide)) {
    // A record is ASCII.
    constexpr std::size_t kDigits = 4;
    for (std::size_t at = kWide.size(); at + kDigits <= value.size() && value[at] != '>';
         at += kDigits) {
      int unit = 0;
      std::from_chars(value.data() + at, value.data() + at + kDigits, unit, 16);
      text += static_cast<char>(unit);
    }
    return text;
  }
  for (std::size_t at = 1; at < value.size() && value[at] != ')'; ++at) {
    if (value[at] == '\\') ++at;
    if (at < value.size()) text += value[at];
  }
  return text;
}

/// The comments of a GIF, in blocks that say how long they are.
std::string in_gif(std::string_view file) {
  std::size_t at = file.find("\x21\xFE");
  std::string text;
  if (at == std::string_view::npos) return text;
  for (at += 2; at < file.size() && file[at] != '\0';) {
    const auto length = static_cast<unsigned char>(file[at]);
    text += file.substr(at + 1, length);
    at += length + 1;
  }
  return text.substr(std::min(text.find('{'), text.size()));
}

}  // namespace

std::string record_text(const Record& record) {
  Json frames = Json::array();
  const RecordedFrame* before = nullptr;
  for (const RecordedFrame& frame : record.frames) {
    Json one = {{"step", frame.step}, {"caption", frame.caption}};
    if (!before || before->shapes != frame.shapes)
      one["case"] = std::visit([](const auto& each) { return json_of(each); }, frame.shapes);
    frames.push_back(std::move(one));
    before = &frame;
  }
  const Json json = {{"program", signature()},
                     {"key", record.key},
                     {"lesson", record.lesson},
                     {"frames", std::move(frames)},
                     {"toml", record.toml}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::optional<Record> find_record(std::span<const std::uint8_t> file) {
  const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  const std::string text = bytes.starts_with("\x89PNG") ? text_in_png(file, kRecordKeyword)
                           : bytes.starts_with("%PDF")  ? in_pdf(bytes)
                           : bytes.starts_with("GIF8")  ? in_gif(bytes)
                                                        : in_svg(bytes);
  try {
    const Json json = Json::parse(text);
    Record record{json.at("lesson"), json.at("toml"), json.at("key"), {}};
    for (const Json& frame : json.at("frames")) {
      RecordedFrame one{frame.at("step"), frame.at("caption"), {}};
      if (frame.contains("case")) {
        const ReadCase read = parse_cases(frame.at("case").dump(), "record", 3).front();
        if (read.in_space)
          one.shapes = *read.in_space;
        else
          one.shapes = read.value.value();
      } else if (!record.frames.empty()) {
        one.shapes = record.frames.back().shapes;
      }
      record.frames.push_back(std::move(one));
    }
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::bad_optional_access&) {
    return std::nullopt;  // A case could not be read.
  }
}

void Fingerprint::add(std::string_view bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (const char byte : bytes) sum_ = (sum_ ^ static_cast<unsigned char>(byte)) * kPrime;
  // The sum also depends on where each input ends.
  sum_ = (sum_ ^ bytes.size()) * kPrime;
}

std::string Fingerprint::hex() const { return fmt::format("{:016x}", sum_); }

}  // namespace gjkscope
