#pragma once
// Parts of C++20 that the libc++ of Debian's Emscripten lacks: versions 15 and 20 have them.

#include <algorithm>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

}  // namespace std
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
namespace std {

/// Without a sign of its own: who calls it reads that.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
  for (const string_view name : {"infinity", "inf", "nan"}) {
    const string_view text(first, static_cast<size_t>(last - first));
    const auto is_same = [](char a, char b) { return a == (b | ' '); };
    if (text.size() < name.size() || !equal(name.begin(), name.end(), text.begin(), is_same))
      continue;
    value =
        name == "nan" ? numeric_limits<double>::quiet_NaN() : numeric_limits<double>::infinity();
    const char* const end = first + name.size();
    if (name != "nan" || end == last || *end != '(') return {end, errc()};
    const char* close = end + 1;  // of nan(...)
    while (close != last && (isalnum(static_cast<unsigned char>(*close)) != 0 || *close == '_'))
      ++close;
    return {close != last && *close == ')' ? close + 1 : end, errc()};
  }
  const bool hex = format == chars_format::hex;
  const string digits = hex ? "0123456789abcdefABCDEF." : "0123456789.";
  if (first == last || digits.find(*first) == string::npos) return {first, errc::invalid_argument};
  if (!hex && last - first > 1 && (first[1] == 'x' || first[1] == 'X')) last = first + 1;
  const string text = (hex ? "0x" : "") + string(first, last);
  char* end = nullptr;
  errno = 0;
  const double read = strtod(text.c_str(), &end);
  const ptrdiff_t length = end - text.c_str() - (hex ? 2 : 0);
  if (length <= 0) return {first, errc::invalid_argument};
  if (isinf(read) || (read == 0.0 && errno == ERANGE))
    return {first + length, errc::result_out_of_range};
  value = read;
  return {first + length, errc()};
}

}  // namespace std
#endif
