// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H
#define CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The conversions of <charconv> do not depend on the locale of the program, unlike those of <cstdio>. Without a number of
// digits the text is the shortest one that is read back as the same double.
void append_number(std::string& text, double value);

void append_number(std::string& text, double value, int digits);

void append_number(std::string& text, long long value);

// Word of a file in a form that is safe to print in a message.
std::string quoted_word(std::string_view word);

// Standard libraries that convert integers only, such as that of LLVM before version 20, leave real numbers to streams in the
// classic locale.
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
constexpr bool has_charconv_of_doubles = true;
#else
constexpr bool has_charconv_of_doubles = false;
#endif

// What std::from_chars() does.
std::errc parse_by_stream(std::string_view word, double& value);

inline std::errc parse_by_stream(std::string_view word, float& value)
{
  double number = 0;
  const std::errc status = parse_by_stream(word, number);
  if(status != std::errc())
    return status;
  const bool is_too_large = std::isfinite(number) && std::abs(number) > double((std::numeric_limits<float>::max)());
  if(is_too_large || (number != 0 && static_cast<float>(number) == 0))
    return std::errc::result_out_of_range;
  value = static_cast<float>(number);
  return std::errc();
}

// What std::to_chars() does, with 0 digits the shortest text.
std::string text_by_stream(double value, int digits);

template <typename Number>
std::errc parse_by_charconv(std::string_view word, Number& value)
{
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
  if(result.ec != std::errc())
    return result.ec;
  return result.ptr == word.data() + word.size() ? std::errc() : std::errc::invalid_argument;
}

template <typename Number>
std::errc parse_number(std::string_view word, Number& value)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  if constexpr(std::is_floating_point_v<Number> && !has_charconv_of_doubles)
    return parse_by_stream(word, value);
  else
    return parse_by_charconv(word, value);
}

// Errors that appear only when the last bytes reach the disk are reported by fflush and fclose. The file is closed.
bool write_open_file(std::FILE* file, const std::string& path, const std::string& content, std::string* message);

// What is told the path of a temporary file that is being written, and null when it is gone: a program that
// ends at once removes it.
inline void (*&temporary_file_observer())(const char* path)
{
  static void (*observer)(const char*) = nullptr;
  return observer;
}

// The file appears, or replaces another one, in one step: what fails or is interrupted leaves what was there before.
bool write_whole_file(const std::string& path, const std::string& content, std::string* message);

bool read_whole_file(const std::string& path, std::string& content, std::string* message);

// Reads a file with a `Reader`: its `read(text)` returns the reason of a failure or the empty string, `mesh()` is the result.
// `mesh` does not change on failure.
template <typename Reader, typename Mesh>
bool read_mesh_with(const std::string& path, Mesh& mesh, std::string* message)
{
  std::string text;
  if(!read_whole_file(path, text, message))
    return false;
  Reader reader;
  const std::string error = reader.read(text);
  if(!error.empty())
    return fail(message, "cannot read " + path + ": " + error);
  mesh = std::move(reader.mesh());
  return succeed(message);
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/IO/internal/file_helpers_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H
