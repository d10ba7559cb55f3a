// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Named values at the points or in the cells of a file, in the type that the file gives them.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_DATA_ARRAY_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_DATA_ARRAY_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace program {

enum class Number_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

inline bool is_real(Number_type type) { return type == Number_type::float32 || type == Number_type::float64; }

// Calls `f` with a number of the type.
template <typename Function>
auto with_type(Number_type type, Function&& f)
{
  switch(type) {
  case Number_type::int8:
    return f(std::int8_t());
  case Number_type::uint8:
    return f(std::uint8_t());
  case Number_type::int16:
    return f(std::int16_t());
  case Number_type::uint16:
    return f(std::uint16_t());
  case Number_type::int32:
    return f(std::int32_t());
  case Number_type::uint32:
    return f(std::uint32_t());
  case Number_type::int64:
    return f(std::int64_t());
  case Number_type::uint64:
    return f(std::uint64_t());
  case Number_type::float32:
    return f(float());
  default:
    return f(double());
  }
}

inline std::size_t size_of(Number_type type)
{
  return with_type(type, [](auto number) { return sizeof(number); });
}

struct Data_array
{
  std::string name;
  Number_type type = Number_type::float64;
  std::size_t number_of_components = 1;
  std::vector<double> reals;          // the values of real types: those of the first point or cell, of the second, ...
  std::vector<std::int64_t> integers; // those of all others, uint64 by its bits
  std::string kind;                   // what VTK takes it for, as "Scalars" or "Vectors"; usually nothing

  std::size_t size() const { return is_real(type) ? reals.size() : integers.size(); }
  double value(std::size_t i) const { return is_real(type) ? reals[i] : static_cast<double>(integers[i]); }
};

Data_array real_array(const std::string& name, std::size_t number_of_components, std::vector<double> values);
Data_array integer_array(const std::string& name, Number_type type, std::vector<std::int64_t> values);

// Null if there is none.
const Data_array* find_array(const std::vector<Data_array>& arrays, std::string_view name);

// Adds an array in place of one with the same name.
void set_array(std::vector<Data_array>& arrays, Data_array array);

// Adds a number that a text gives. Returns the empty string, or why it is none of the array's type.
std::string append_word(Data_array& array, std::string_view word);

// Adds numbers from bytes of this order.
void append_bytes(Data_array& array, std::string_view bytes, bool is_big_endian);

// Adds all values to a text, in lines of as many numbers as there are components, or in bytes of this order.
void append_as_text(std::string& text, const Data_array& array);
void append_as_bytes(std::string& text, const Data_array& array, bool is_big_endian);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_DATA_ARRAY_H
