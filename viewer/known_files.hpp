#pragma once
// The contents of files when they were read or written last: whoever writes one again looks whether
// somebody else was there meanwhile.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace gjkscope {

class KnownFiles {
 public:
  struct Known {
    std::string text;
    bool is_ours = false;  ///< This window wrote it.
    std::string good;      ///< The last text that could be shown.
  };

  void note_read(const std::filesystem::path& file, std::string text) {
    Known& known = known_[file];
    known.good = text;
    known.text = std::move(text);
    known.is_ours = false;
  }
  /// A text that cannot be shown.
  void note_broken(const std::filesystem::path& file, std::string text) {
    known_[file] = {std::move(text), false, std::move(known_[file].good)};
  }
  void note_written(const std::filesystem::path& file, std::string text) {
    note_read(file, std::move(text));
    known_[file].is_ours = true;
  }
  /// Null for a file that was neither read nor written.
  [[nodiscard]] const Known* find(const std::filesystem::path& file) const {
    const auto found = known_.find(file);
    return found == known_.end() ? nullptr : &found->second;
  }
  /// Whether the file holds something else than it did; where it is not known, anything is.
  [[nodiscard]] bool is_changed(const std::filesystem::path& file, const std::string& text) const {
    const Known* known = find(file);
    return known == nullptr || known->text != text;
  }

 private:
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace gjkscope
