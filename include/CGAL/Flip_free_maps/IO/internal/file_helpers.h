// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H
#define CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The conversions of <charconv> do not depend on the locale of the program, unlike those of <cstdio>. Without a number of
// digits the text is the shortest one that is read back as the same double.
inline void append_number(std::string& text, double value)
{
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

inline void append_number(std::string& text, double value, int digits)
{
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits).ptr);
}

inline void append_number(std::string& text, long long value)
{
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

// Word of a file in a form that is safe to print in a message.
inline std::string quoted_word(std::string_view word)
{
  std::string result = "'";
  for(const char c : word.substr(0, 40))
    result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (word.size() > 40 ? "...'" : "'");
}

template <typename Number>
std::errc parse_number(std::string_view word, Number& value)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
  if(result.ec != std::errc())
    return result.ec;
  return result.ptr == word.data() + word.size() ? std::errc() : std::errc::invalid_argument;
}

// Errors that appear only when the last bytes reach the disk are reported by fflush and fclose.
inline bool write_whole_file(const std::string& path, const std::string& content, std::string* message)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if(file == nullptr)
    return fail(message, "cannot open " + path + " for writing: " + std::strerror(errno));

  bool is_written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  is_written = (std::fflush(file) == 0) && is_written;
  const int write_error = errno;
  is_written = (std::fclose(file) == 0) && is_written;
  if(!is_written)
    return fail(message, "cannot write " + path + ": " + std::strerror(write_error != 0 ? write_error : errno));
  return succeed(message);
}

inline bool read_whole_file(const std::string& path, std::string& content, std::string* message)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if(file == nullptr)
    return fail(message, "cannot open " + path + ": " + std::strerror(errno));

  content.clear();
  std::string chunk(std::size_t(1) << 20, '\0');
  for(std::size_t length; (length = std::fread(&chunk[0], 1, chunk.size(), file)) > 0;)
    content.append(chunk, 0, length);
  const bool is_read = std::ferror(file) == 0;
  const int read_error = errno;
  std::fclose(file);
  if(!is_read)
    return fail(message, "cannot read " + path + ": " + std::strerror(read_error));
  return true;
}

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

#endif // CGAL_FLIP_FREE_MAPS_IO_INTERNAL_FILE_HELPERS_H
