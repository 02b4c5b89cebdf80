#pragma once
// Settings of a tour, a table of the lesson file, as a lesson holds them. This folder does not know
// what is in them: see lesson/settings_kind.hpp.

#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace gjkscope {

struct SettingsKind;

/// A file that a table names.
struct NamedFile {
  std::string path;                         ///< As seen from the lesson's folder.
  std::shared_ptr<const std::string> text;  ///< The content of the file; never nullptr.
};

/// A value of a type T that has == and `static const SettingsKind kKind`. Copies share the value
/// until one of them is edited.
class TourSettings {
 public:
  TourSettings() = default;  ///< No table.
  template <class T>
  requires requires { &T::kKind; }
  explicit TourSettings(T value) : value_(std::make_shared<const ValueOf<T>>(std::move(value))) {}

  /// nullptr: no table.
  [[nodiscard]] const SettingsKind* kind() const { return value_ ? &value_->kind() : nullptr; }
  /// nullptr where the table is of another type.
  template <class T>
  [[nodiscard]] const T* as() const {
    const auto* found = dynamic_cast<const ValueOf<T>*>(value_.get());
    return found != nullptr ? &found->value : nullptr;
  }
  /// A value of its own. The table must be of this type. Use the reference before the table is
  /// copied or edited again.
  template <class T>
  [[nodiscard]] T& edit() {
    assert(as<T>() != nullptr);
    const auto own = std::make_shared<ValueOf<T>>(*as<T>());
    value_ = own;
    return own->value;
  }

  /// The file that the table names, if any. Its path stands here alone, not in the value.
  std::optional<NamedFile> file;

  friend bool operator==(const TourSettings& a, const TourSettings& b) {
    if (a.kind() != b.kind() || a.file.has_value() != b.file.has_value()) return false;
    if (a.file && a.file->path != b.file->path) return false;
    return a.value_ == b.value_ || a.value_->is_same(*b.value_);
  }

 private:
  struct Value {
    virtual ~Value() = default;
    [[nodiscard]] virtual const SettingsKind& kind() const = 0;
    /// `other` is of the same kind.
    [[nodiscard]] virtual bool is_same(const Value& other) const = 0;
  };
  template <class T>
  struct ValueOf final : Value {
    explicit ValueOf(T of) : value(std::move(of)) {}
    [[nodiscard]] const SettingsKind& kind() const override { return T::kKind; }
    [[nodiscard]] bool is_same(const Value& other) const override {
      return value == dynamic_cast<const ValueOf&>(other).value;
    }
    T value;
  };
  std::shared_ptr<const Value> value_;
};

}  // namespace gjkscope
