// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_IMPL_H

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE std::errc parse_by_stream(std::string_view word, double& value)
{
  const bool is_negative = !word.empty() && word[0] == '-';
  const std::string digits(is_negative ? word.substr(1) : word);
  std::string lower = digits;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  double magnitude = 0;
  if(lower == "inf" || lower == "infinity")
    magnitude = std::numeric_limits<double>::infinity();
  else if(lower == "nan")
    magnitude = std::numeric_limits<double>::quiet_NaN();
  else {
    // Streams take more than decimal numbers, and signs.
    if(digits.empty() || digits.find_first_not_of("0123456789.eE+-") != std::string::npos || digits[0] == '+' || digits[0] == '-')
      return std::errc::invalid_argument;
    std::istringstream stream(digits);
    stream.imbue(std::locale::classic());
    stream >> magnitude;
    const bool is_out_of_range = stream.fail() && std::abs(magnitude) == (std::numeric_limits<double>::max)();
    if(stream.fail() && !is_out_of_range)
      return std::errc::invalid_argument;
    if(stream.peek() != std::char_traits<char>::eof())
      return std::errc::invalid_argument;
    // A number too small for a double is read as 0, and no failure to all streams.
    const std::size_t exponent = digits.find_first_of("eE");
    if(is_out_of_range || (magnitude == 0 && digits.substr(0, exponent).find_first_of("123456789") != std::string::npos))
      return std::errc::result_out_of_range;
  }
  value = is_negative ? -magnitude : magnitude;
  return std::errc();
}

CGAL_FLIP_FREE_MAPS_INLINE std::string text_by_stream(double value, int digits)
{
  if(!std::isfinite(value))
    return std::isnan(value) ? (std::signbit(value) ? "-nan" : "nan") : (value < 0 ? "-inf" : "inf");
  std::string text;
  for(int precision = digits > 0 ? digits : 1; precision <= (digits > 0 ? digits : 17); ++precision) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(precision);
    stream << value;
    text = stream.str();
    double read = 0;
    if(digits == 0 && parse_by_stream(text, read) == std::errc() && read == value)
      break;
  }
  return text;
}

CGAL_FLIP_FREE_MAPS_INLINE void append_number(std::string& text, double value)
{
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
#else
  text += text_by_stream(value, 0);
#endif
}

CGAL_FLIP_FREE_MAPS_INLINE void append_number(std::string& text, double value, int digits)
{
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits).ptr);
#else
  text += text_by_stream(value, digits);
#endif
}

CGAL_FLIP_FREE_MAPS_INLINE void append_number(std::string& text, long long value)
{
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

CGAL_FLIP_FREE_MAPS_INLINE std::string quoted_word(std::string_view word)
{
  std::string result = "'";
  for(const char c : word.substr(0, 40))
    result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (word.size() > 40 ? "...'" : "'");
}

CGAL_FLIP_FREE_MAPS_INLINE bool write_open_file(std::FILE* file, const std::string& path, const std::string& content, std::string* message)
{
  bool is_written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  is_written = (std::fflush(file) == 0) && is_written;
  const int write_error = errno;
  is_written = (std::fclose(file) == 0) && is_written;
  return is_written || fail(message, "cannot write " + path + ": " + std::strerror(write_error != 0 ? write_error : errno));
}

CGAL_FLIP_FREE_MAPS_INLINE bool write_whole_file(const std::string& path, const std::string& content, std::string* message)
{
  namespace fs = std::filesystem;
  errno = 0;
  std::error_code error;
  // A link is kept, and the file that it leads to is replaced.
  const fs::path link_target = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
  const std::string target = link_target.empty() ? path : link_target.string();
  const fs::file_status status = fs::status(target, error);
  std::FILE* file = nullptr;
  if(fs::exists(status) && !fs::is_regular_file(status)) { // a device, or a pipe
    file = std::fopen(target.c_str(), "wb");
    if(file == nullptr)
      return fail(message, "cannot open " + path + " for writing: " + std::strerror(errno));
    return write_open_file(file, path, content, message) && succeed(message);
  }

  std::string temporary;
  for(int i = 0; file == nullptr && i < 1000; ++i) {
    errno = 0;
    temporary = target + "." + std::to_string(i) + ".tmp";
    file = std::fopen(temporary.c_str(), "wbx");
    if(file == nullptr && errno != EEXIST)
      break;
  }
  if(file == nullptr)
    return fail(message, "cannot open " + path + " for writing: " + std::strerror(errno));
  const auto tell = [](const char* name) {
    if(temporary_file_observer() != nullptr)
      temporary_file_observer()(name);
  };
  tell(temporary.c_str());
  bool is_done = write_open_file(file, path, content, message);
  if(is_done && fs::exists(status))
    fs::permissions(temporary, status.permissions(), error);
  if(is_done) {
    fs::rename(temporary, target, error);
    is_done = !error || fail(message, "cannot write " + path + ": " + error.message());
  }
  if(!is_done)
    fs::remove(temporary, error);
  tell(nullptr);
  return is_done && succeed(message);
}

CGAL_FLIP_FREE_MAPS_INLINE bool read_whole_file(const std::string& path, std::string& content, std::string* message)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if(file == nullptr)
    return fail(message, "cannot open " + path + ": " + std::strerror(errno));

  content.clear();
  std::string chunk(std::size_t(1) << 16, '\0');
  for(std::size_t length; (length = std::fread(&chunk[0], 1, chunk.size(), file)) > 0;)
    content.append(chunk, 0, length);
  const bool is_read = std::ferror(file) == 0;
  const int read_error = errno;
  std::fclose(file);
  if(!is_read)
    return fail(message, "cannot read " + path + ": " + std::strerror(read_error));
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_IMPL_H
