// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The compiled part of the Python module.

#include "functions.h"

#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/version.h>

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace python {

namespace {

namespace FFM = CGAL::Flip_free_maps;

// The statuses that leave no map.
std::vector<std::string> failures()
{
  std::vector<std::string> names;
  for(int s = 0; s <= static_cast<int>(FFM::Status::interrupted); ++s)
    if(!FFM::is_valid_map(static_cast<FFM::Status>(s)))
      names.push_back(FFM::status_name(static_cast<FFM::Status>(s)));
  return names;
}

} // namespace

} // namespace python

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CGAL_FLIP_FREE_MAPS_VERSION;
  module.def("unwrap", &python::unwrap);
  module.def("pack", &python::pack);
  module.def("cut_to_disk", &python::cut_to_disk);
  module.def("cut_along", &python::cut_along);
  module.def("measure", &python::measure);
  module.def("is_bijective", &python::is_bijective);
  module.def("parameterize", &python::parameterize);
  module.def("repair", &python::repair);
  module.def("parameterize_with_seams", &python::parameterize_with_seams);
  module.def("deform", &python::deform);
  module.def("deform_volume", &python::deform_volume);
  module.def("map_volume", &python::map_volume);
  module.def("morph_volume", &python::morph_volume);
  module.def("minimize", &python::minimize);
  python::add_deformations(module);

  module.def("failures", &python::failures);
  module.def("names", &python::names);
}
