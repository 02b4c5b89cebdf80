#include "lesson/key_pass.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "base/decimal.hpp"

namespace gjkscope {

using toml_file::Field;

namespace {

constexpr std::array kStopTestNames = {name_of(gjk::StopReason::repeated_support),
                                       name_of(gjk::StopReason::no_progress)};

}  // namespace

KeyPass& KeyPass::operator()(std::string_view key, std::string_view otherwise, std::string meaning,
                             std::string type) {
  words_ = {std::string(name_), std::string(key), std::move(type), std::string(otherwise),
            std::move(meaning)};
  always_ = otherwise == kRequired;
  return *this;
}

KeyPass& KeyPass::always() {
  always_ = true;
  return *this;
}

std::optional<Field> KeyPass::key(std::string_view type, std::string_view fresh, std::string line) {
  if (words_.type.empty()) words_.type = type;
  if (words_.otherwise.empty()) words_.otherwise = fresh;
  if (keys_ != nullptr) keys_->push_back(words_);
  if (lines_ != nullptr) lines_->push_back(is_fresh_ && always_ ? "" : std::move(line));
  return table_ != nullptr ? std::optional((*table_)[words_.key]) : std::nullopt;
}

void KeyPass::text(std::string& value, int longest) {
  const std::string line = value.empty() ? "" : key_line(words_.key, as_text(value));
  if (const auto field = key(text_up_to(longest), "", line))
    value = reader_->text(*field, longest).value_or(value);
}

void KeyPass::long_text(std::string& value, int longest) {
  const std::string line = value.empty() ? "" : long_text_line(words_.key, value);
  if (const auto field = key(text_up_to(longest), "", line))
    value = reader_->text(*field, longest).value_or(value);
}

void KeyPass::read_number(std::optional<double>& value, double least, double most) {
  const std::string line = value ? key_line(words_.key, decimal(*value)) : "";
  if (const auto field = key(fmt::format("number from {} to {}", least, most),
                             fmt::format("{}", value.value_or(0.0)), line))
    value = reader_->number(*field, least, most);
}

void KeyPass::read_whole_number(std::optional<int>& value, int least, int most) {
  const std::string text = value ? std::to_string(*value) : "";
  const std::string line = value ? key_line(words_.key, text) : "";
  if (const auto field = key(fmt::format("whole number from {} to {}", least, most), text, line))
    value = reader_->whole_number(*field, least, most);
}

void KeyPass::yes_or_no(bool& value) {
  const std::string_view text = value ? "true" : "false";
  if (const auto field = key("true or false", text, key_line(words_.key, text)))
    value = reader_->yes_or_no(*field).value_or(value);
}

void KeyPass::point(Eigen::Vector3d& value) {
  const std::string line = key_line(words_.key, in_brackets(value, dimension));
  if (const auto field = key("point [x, y]", "[0, 0]", line))
    value = reader_->point(*field, largest, dimension).value_or(value);
}

void KeyPass::name(std::optional<std::string>& value, std::string_view kind, const Texts& known) {
  const std::string line = value ? key_line(words_.key, as_text(*value)) : "";
  if (const auto field = key(one_of(known), value.value_or(""), line))
    value = reader_->name(*field, kind, known);
}

void KeyPass::stop_tests(std::optional<std::array<bool, 2>>& on) {
  const Texts known(kStopTestNames.begin(), kStopTestNames.end());
  Texts entries;
  for (std::size_t i = 0; on && i < known.size(); ++i) {
    if ((*on)[i]) entries.push_back(as_text(known[i]));
  }
  const auto field = key(fmt::format("list of: {}", fmt::join(known, ", ")), "both",
                         on ? list_line(words_.key, entries) : "");
  if (!field || !*field) return;
  const std::vector<Field> read =
      reader_->entries(*field, one_of(known) + " (the others always apply)");
  if (!field->node->is_array()) return;
  on.emplace();
  for (const Field& entry : read) {
    const std::optional<std::string> name = reader_->name(entry, "stop test", known);
    for (std::size_t i = 0; i < known.size(); ++i) (*on)[i] = (*on)[i] || name == known[i];
  }
}

void KeyPass::other(std::string_view value) {
  key("", "", value.empty() ? "" : key_line(words_.key, value));
}

void KeyPass::other_list(const std::optional<Texts>& entries) {
  key("", "", entries ? list_line(words_.key, *entries) : "");
}

}  // namespace gjkscope
