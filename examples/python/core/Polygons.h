// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Polygons of any numbers of corners in two arrays of numpy.

#ifndef FLIP_FREE_MAPS_PYTHON_POLYGONS_H
#define FLIP_FREE_MAPS_PYTHON_POLYGONS_H

#include "Rows.h"

#include <cstddef>
#include <cstdint>

namespace python {

// A container of polygons, of which number p has the values from `offsets[p]` to before `offsets[p + 1]`. Offsets ascend from 0 to
// the number of values.
class Polygons
{
public:
  using Numbers = Rows<std::int64_t, 1>;

  class Polygon
  {
  public:
    Polygon(Numbers::const_iterator first, Numbers::const_iterator last) : m_first(first), m_last(last) {}
    std::size_t size() const { return static_cast<std::size_t>(m_last - m_first); }
    std::int64_t operator[](std::size_t k) const { return m_first[k][0]; }

  private:
    Numbers::const_iterator m_first, m_last;
  };

  class Iterator
  {
  public:
    Iterator(const Polygons* polygons, std::size_t p) : m_polygons(polygons), m_p(p) {}
    Polygon operator*() const { return (*m_polygons)[m_p]; }
    Iterator& operator++()
    {
      ++m_p;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return m_p != other.m_p; }

  private:
    const Polygons* m_polygons;
    std::size_t m_p;
  };

  Polygons(const py::array& values, const py::array& offsets) : m_values(values, "values"), m_offsets(offsets, "offsets") {}

  std::size_t size() const { return m_offsets.size() - 1; }
  Polygon operator[](std::size_t p) const { return Polygon(m_values.begin() + m_offsets[p][0], m_values.begin() + m_offsets[p + 1][0]); }
  Iterator begin() const { return Iterator(this, 0); }
  Iterator end() const { return Iterator(this, size()); }

private:
  Numbers m_values, m_offsets;
};

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_POLYGONS_H
