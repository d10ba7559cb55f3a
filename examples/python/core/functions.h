// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The functions of the module, on arrays, before names, checks and objects are added in Python. Results are tuples of arrays and
// the account of the run.

#ifndef FLIP_FREE_MAPS_PYTHON_FUNCTIONS_H
#define FLIP_FREE_MAPS_PYTHON_FUNCTIONS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>

namespace python {

namespace py = pybind11;

// surfaces.cpp
py::tuple unwrap(const py::array& points, const py::array& values, const py::array& offsets, const py::array& seams,
                 const py::array& features, const py::array& pinned, const py::array& images, const py::dict& given,
                 bool is_single_precision, const py::object& progress);
py::tuple pack(const py::array& triangles, const py::array& uv, const py::array& pinned, const py::dict& given, bool is_single_precision);
py::tuple cut_to_disk(const py::array& points, const py::array& triangles, const py::array& seams, const py::dict& given);
py::tuple cut_along(const py::array& triangles, std::int64_t number_of_points, const py::array& seams);
py::tuple measure(const py::array& points, const py::array& triangles, const py::array& uv);
py::tuple is_bijective(const py::array& triangles, const py::array& uv);

// maps.cpp
py::tuple parameterize(const py::array& points, const py::array& triangles, const py::dict& given, const py::object& progress);
py::tuple repair(const py::array& points, const py::array& triangles, const py::array& uv, const py::dict& given,
                 const py::object& progress);
py::tuple parameterize_with_seams(const py::array& points, const py::array& triangles, const py::array& seams, const py::dict& given,
                                  const py::object& progress);

// The names that arguments may have, by the names of arguments.
py::dict names();

// deformations.cpp
py::tuple deform(const py::array& points, const py::array& triangles, const py::array& handles, const py::array& targets,
                 const py::dict& given, const py::object& progress);
py::tuple deform_volume(const py::array& points, const py::array& tetrahedra, const py::array& handles, const py::array& targets,
                        const py::dict& given, const py::object& progress);
py::tuple map_volume(const py::array& points, const py::array& tetrahedra, const py::array& boundary, const py::array& places,
                     const py::dict& given, const py::object& progress);

py::tuple morph_volume(const py::array& points, const py::array& tetrahedra, const py::array& vertices, const py::array& places,
                       const py::dict& given, const py::object& progress);
void add_deformations(py::module_& module);

// minimize.cpp
py::tuple minimize(const py::array& start, const py::array& elements, const py::array& rest, const py::object& energy,
                   const py::object& term, const py::dict& given, const py::object& progress);

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_FUNCTIONS_H
