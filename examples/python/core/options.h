// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Settings as dictionaries, in which what is not given keeps its default.

#ifndef FLIP_FREE_MAPS_PYTHON_OPTIONS_H
#define FLIP_FREE_MAPS_PYTHON_OPTIONS_H

#include "../../program/methods.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

namespace python {

namespace py = pybind11;
namespace FFM = CGAL::Flip_free_maps;

template <typename T>
void read(const py::dict& options, const char* name, T& field)
{
  if(!options.contains(name))
    return;
  try {
    field = options[name].cast<T>();
  } catch(const py::cast_error&) {
    throw py::type_error(std::string(name) + " has the wrong type");
  }
}

program::Method_choice method_choice(const py::dict& options);

program::Start_choice start_choice(const py::dict& options);

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_OPTIONS_H
