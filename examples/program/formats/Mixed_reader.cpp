// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Mixed_reader.h"

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <type_traits>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

// No count or number of a node is larger.
template <typename Number>
long long as_long(Number number)
{
  if constexpr(std::is_same<Number, std::uint64_t>::value)
    return static_cast<long long>((std::min)(number, std::uint64_t((std::numeric_limits<long long>::max)())));
  else
    return static_cast<long long>(number);
}

} // namespace

std::size_t Mixed_reader::next_word() const { return (std::min)(m_text.find_first_not_of(" \t\v\f\r\n", m_position), m_text.size()); }

std::string_view Mixed_reader::peek_word() const
{
  const std::size_t begin = next_word();
  return m_text.substr(begin, m_text.find_first_of(" \t\v\f\r\n", begin) - begin);
}

std::string_view Mixed_reader::word()
{
  m_last = next_word();
  const std::string_view result = m_text.substr(m_last, m_text.find_first_of(" \t\v\f\r\n", m_last) - m_last);
  m_position = m_last + result.size();
  return result;
}

std::string_view Mixed_reader::peek_line() const { return m_text.substr(m_position, m_text.find('\n', m_position) - m_position); }

std::string_view Mixed_reader::line()
{
  m_last = m_position;
  std::string_view result = peek_line();
  m_position = (std::min)(m_position + result.size() + 1, m_text.size());
  if(!result.empty() && result.back() == '\r')
    result.remove_suffix(1);
  return result;
}

bool Mixed_reader::skip_past(std::string_view characters)
{
  const std::size_t found = m_text.find(characters, m_position);
  if(found != std::string_view::npos)
    m_position = found + characters.size();
  return found != std::string_view::npos;
}

bool Mixed_reader::go_to(long long position)
{
  if(position < static_cast<long long>(m_position) || position > static_cast<long long>(m_text.size()))
    return false;
  m_position = static_cast<std::size_t>(position);
  return true;
}

bool Mixed_reader::read_integer(Number_type type, long long& value)
{
  if(!m_is_binary) {
    const std::string_view text = word();
    if(text.empty())
      return fail_at_end();
    const bool is_read = with_type(type, [&](auto number) {
      const bool is_number = internal::parse_number(text, number) == std::errc();
      value = is_number ? as_long(number) : 0;
      return is_number;
    });
    return is_read || fail(internal::quoted_word(text) + " is not an integer in the range of its type");
  }
  std::string_view bytes;
  if(!read_bytes(size_of(type), bytes))
    return false;
  value = with_type(type, [&](auto number) { return as_long(Binary_reader(bytes, m_is_big_endian).read<decltype(number)>()); });
  return true;
}

bool Mixed_reader::read_finite(Number_type type, double& value)
{
  if(!m_is_binary) {
    const std::string_view text = word();
    if(text.empty())
      return fail_at_end();
    const std::errc status = internal::parse_number(text, value);
    if(status != std::errc())
      return fail(internal::quoted_word(text) +
                  (status == std::errc::result_out_of_range ? " is not in the range of double precision numbers" : " is not a number"));
    return std::isfinite(value) || fail(internal::quoted_word(text) + " is not a finite number");
  }
  std::string_view bytes;
  if(!read_bytes(size_of(type), bytes))
    return false;
  Binary_reader reader(bytes, m_is_big_endian);
  value = type == Number_type::float32 ? static_cast<double>(reader.read<float>()) : reader.read<double>();
  return std::isfinite(value) || fail("a number is not finite");
}

bool Mixed_reader::read_count(std::size_t& count)
{
  const std::string_view text = word();
  long long value = 0;
  if(text.empty())
    return fail_at_end();
  if(internal::parse_number(text, value) != std::errc() || value < 0 || value > (std::numeric_limits<int>::max)())
    return fail(internal::quoted_word(text) + " is no number of items");
  count = static_cast<std::size_t>(value);
  return true;
}

bool Mixed_reader::read_bytes(std::size_t count, std::string_view& bytes)
{
  m_last = m_position;
  if(m_text.size() - m_position < count)
    return fail_at_end();
  bytes = m_text.substr(m_position, count);
  m_position += count;
  return true;
}

bool Mixed_reader::read_values(std::size_t count, Data_array& array)
{
  if(m_is_binary) {
    std::string_view bytes;
    if(count > m_text.size()) // before the product overflows
      return fail_at_end();
    if(!read_bytes(count * size_of(array.type), bytes))
      return false;
    append_bytes(array, bytes, m_is_big_endian);
    return true;
  }
  for(std::size_t i = 0; i < count; ++i) {
    const std::string_view text = word();
    if(text.empty())
      return fail_at_end();
    const std::string reason = append_word(array, text);
    if(!reason.empty())
      return fail(reason);
  }
  return true;
}

bool Mixed_reader::fail(const std::string& reason)
{
  const std::string where = m_is_binary ? "byte " + std::to_string(m_last)
                                        : "line " + std::to_string(1 + std::count(m_text.begin(), m_text.begin() + m_last, '\n'));
  m_error = where + ": " + reason;
  return false;
}

bool Mixed_reader::fail_at_end() { return fail("the file ends too early"); }

} // namespace program
