// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Arrays of numpy as containers of rows, and back.

#ifndef FLIP_FREE_MAPS_PYTHON_ROWS_H
#define FLIP_FREE_MAPS_PYTHON_ROWS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// An array of shape (n, N) as a container of n rows. It is not copied if it has the type and the layout already, and neither
// written. The object is made and destroyed with the interpreter's lock, and may be read without.
template <typename T, std::size_t N>
class Rows
{
public:
  using value_type = std::array<T, N>;
  using const_iterator = const value_type*;

  Rows(const py::array& array, const char* name) : m_array(Numbers::ensure(array))
  {
    if(!m_array)
      throw py::error_already_set();
    if(m_array.ndim() != 2 || m_array.shape(1) != static_cast<py::ssize_t>(N))
      throw py::value_error(std::string(name) + " must have the shape (n, " + std::to_string(N) + ")");
    m_begin = reinterpret_cast<const value_type*>(m_array.data());
    m_size = static_cast<std::size_t>(m_array.shape(0));
  }

  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  std::size_t size() const { return m_size; }
  const value_type& operator[](std::size_t i) const { return m_begin[i]; }
  const_iterator begin() const { return m_begin; }
  const_iterator end() const { return m_begin + m_size; }

private:
  using Numbers = py::array_t<T, py::array::c_style | py::array::forcecast>;

  Numbers m_array;
  const value_type* m_begin;
  std::size_t m_size;
};

using Points = Rows<double, 3>;
using Planar_points = Rows<double, 2>;
using Triangles = Rows<std::int64_t, 3>;
using Tetrahedra = Rows<std::int64_t, 4>;
using Edges = Rows<std::int64_t, 2>;

// An array that owns a copy of the numbers of a vector, whose elements may be arrays themselves.
template <typename T, typename Row>
py::array_t<T> array_of(const std::vector<Row>& rows, std::vector<py::ssize_t> shape)
{
  static_assert(sizeof(Row) % sizeof(T) == 0, "rows consist of numbers");
  py::array_t<T> result(std::move(shape));
  if(!rows.empty())
    std::memcpy(result.mutable_data(), rows.data(), rows.size() * sizeof(Row));
  return result;
}

template <typename T, std::size_t N>
py::array_t<T> array_of(const std::vector<std::array<T, N>>& rows)
{
  return array_of<T>(rows, {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(N)});
}

template <typename T>
py::array_t<T> array_of(const std::vector<T>& numbers)
{
  return array_of<T>(numbers, {static_cast<py::ssize_t>(numbers.size())});
}

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_ROWS_H
