// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Data_array.h"

#include "Binary_reader.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <system_error>
#include <type_traits>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

Data_array real_array(const std::string& name, std::size_t number_of_components, std::vector<double> values)
{
  Data_array array;
  array.name = name;
  array.number_of_components = number_of_components;
  array.reals = std::move(values);
  return array;
}

Data_array integer_array(const std::string& name, Number_type type, std::vector<std::int64_t> values)
{
  Data_array array;
  array.name = name;
  array.type = type;
  array.integers = std::move(values);
  return array;
}

const Data_array* find_array(const std::vector<Data_array>& arrays, std::string_view name)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(), [name](const Data_array& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

void set_array(std::vector<Data_array>& arrays, Data_array array)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Data_array& other) { return other.name == array.name; });
  if(found == arrays.end())
    arrays.push_back(std::move(array));
  else
    *found = std::move(array);
}

std::string append_word(Data_array& array, std::string_view word)
{
  return with_type(array.type, [&](auto number) -> std::string {
    using Number = decltype(number);
    if constexpr(std::is_floating_point<Number>::value) {
      double value = 0;
      const std::errc status = internal::parse_number(word, value);
      if(status != std::errc())
        return internal::quoted_word(word) +
               (status == std::errc::result_out_of_range ? " is not in the range of double precision numbers" : " is not a number");
      array.reals.push_back(static_cast<double>(static_cast<Number>(value)));
    } else {
      if(internal::parse_number(word, number) != std::errc())
        return internal::quoted_word(word) + " is not an integer" + (sizeof(Number) < 8 ? " in the range of its type" : "");
      array.integers.push_back(static_cast<std::int64_t>(number));
    }
    return "";
  });
}

void append_bytes(Data_array& array, std::string_view bytes, bool is_big_endian)
{
  with_type(array.type, [&](auto number) {
    using Number = decltype(number);
    for(Binary_reader reader(bytes, is_big_endian); reader.left() >= sizeof(Number);)
      if constexpr(std::is_floating_point<Number>::value)
        array.reals.push_back(static_cast<double>(reader.read<Number>()));
      else
        array.integers.push_back(static_cast<std::int64_t>(reader.read<Number>()));
  });
}

void append_as_text(std::string& text, const Data_array& array)
{
  char buffer[40];
  for(std::size_t i = 0; i < array.size(); ++i) {
    const std::to_chars_result end =
      array.type == Number_type::float64   ? std::to_chars(buffer, buffer + sizeof buffer, array.reals[i])
      : array.type == Number_type::float32 ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(array.reals[i]))
      : array.type == Number_type::uint64  ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<std::uint64_t>(array.integers[i]))
                                           : std::to_chars(buffer, buffer + sizeof buffer, array.integers[i]);
    text.append(buffer, end.ptr);
    text += (i + 1) % array.number_of_components == 0 ? '\n' : ' ';
  }
}

void append_as_bytes(std::string& text, const Data_array& array, bool is_big_endian)
{
  with_type(array.type, [&](auto number) {
    using Number = decltype(number);
    text.reserve(text.size() + array.size() * sizeof(Number));
    for(std::size_t i = 0; i < array.size(); ++i) {
      if constexpr(std::is_floating_point<Number>::value)
        append_number_bytes(text, static_cast<Number>(array.reals[i]), is_big_endian);
      else
        append_number_bytes(text, static_cast<Number>(array.integers[i]), is_big_endian);
    }
  });
}

} // namespace program
