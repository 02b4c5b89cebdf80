#pragma once
// A table that only some acts take, as a lesson holds it. This folder does not know what is in it:
// see lesson/table_kind.hpp.

#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace gjkscope {

struct TableKind;

/// A file that a table names.
struct NamedFile {
  std::string path;                         ///< As seen from the lesson's folder.
  std::shared_ptr<const std::string> text;  ///< What stood in it; never nullptr.
};

/// A value of a type T that has == and `static const TableKind kKind`. Copies share the value
/// until one of them is edited.
class ActTable {
 public:
  ActTable() = default;  ///< No table.
  template <class T>
  requires requires { &T::kKind; }
  explicit ActTable(T value)
      : kind_(&T::kKind),
        value_(std::make_shared<T>(std::move(value))),
        is_same_([](const void* a, const void* b) {
          return *static_cast<const T*>(a) == *static_cast<const T*>(b);
        }) {}

  [[nodiscard]] const TableKind* kind() const { return kind_; }  ///< nullptr: no table.
  /// nullptr where the table is of another type.
  template <class T>
  [[nodiscard]] const T* as() const {
    return kind_ == &T::kKind ? static_cast<const T*>(value_.get()) : nullptr;
  }
  /// The value, no longer shared. The table must be of this type. Use the reference before the
  /// table is copied.
  template <class T>
  [[nodiscard]] T& edit() {
    assert(as<T>() != nullptr);
    if (value_.use_count() > 1) value_ = std::make_shared<T>(*as<T>());
    return *static_cast<T*>(value_.get());
  }

  /// The file that the table names, if any. Its path stands here alone, not in the value.
  std::optional<NamedFile> file;

  friend bool operator==(const ActTable& a, const ActTable& b) {
    if (a.kind_ != b.kind_ || a.file.has_value() != b.file.has_value()) return false;
    if (a.file && a.file->path != b.file->path) return false;
    return a.value_ == b.value_ || a.is_same_(a.value_.get(), b.value_.get());
  }

 private:
  const TableKind* kind_ = nullptr;
  std::shared_ptr<void> value_;
  bool (*is_same_)(const void*, const void*) = nullptr;
};

}  // namespace gjkscope
