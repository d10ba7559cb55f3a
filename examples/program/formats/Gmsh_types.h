// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GMSH_TYPES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GMSH_TYPES_H

#include "Volume_file.h"

#include <cstddef>

namespace program {

// Types of elements of Gmsh: the cell of VTK with the same order of nodes, but for tetrahedra of second order, or 0 where there is
// none; and a name where the element is a solid that is not mapped.
struct Gmsh_type
{
  int number;
  int cell;
  std::size_t number_of_nodes;
  const char* name;
};

constexpr Gmsh_type GMSH_TYPES[] = {{1, cell_type::LINE, 2, nullptr},
                                    {2, cell_type::TRIANGLE, 3, nullptr},
                                    {3, cell_type::QUAD, 4, nullptr},
                                    {4, cell_type::TETRAHEDRON, 4, nullptr},
                                    {5, 0, 8, "hexahedra"},
                                    {6, 0, 6, "prisms"},
                                    {7, 0, 5, "pyramids"},
                                    {8, cell_type::QUADRATIC_LINE, 3, nullptr},
                                    {9, cell_type::QUADRATIC_TRIANGLE, 6, nullptr},
                                    {10, cell_type::BIQUADRATIC_QUAD, 9, nullptr},
                                    {11, cell_type::QUADRATIC_TETRAHEDRON, 10, nullptr},
                                    {12, 0, 27, "hexahedra of second order"},
                                    {13, 0, 18, "prisms of second order"},
                                    {14, 0, 14, "pyramids of second order"},
                                    {15, cell_type::VERTEX, 1, nullptr},
                                    {16, cell_type::QUADRATIC_QUAD, 8, nullptr},
                                    {17, 0, 20, "hexahedra of second order"},
                                    {18, 0, 15, "prisms of second order"},
                                    {19, 0, 13, "pyramids of second order"},
                                    {20, 0, 9, nullptr},
                                    {21, 0, 10, nullptr},
                                    {22, 0, 12, nullptr},
                                    {23, 0, 15, nullptr},
                                    {24, 0, 15, nullptr},
                                    {25, 0, 21, nullptr},
                                    {26, 0, 4, nullptr},
                                    {27, 0, 5, nullptr},
                                    {28, 0, 6, nullptr},
                                    {29, 0, 20, "tetrahedra of third order"},
                                    {30, 0, 35, "tetrahedra of fourth order"},
                                    {31, 0, 56, "tetrahedra of fifth order"},
                                    {92, 0, 64, "hexahedra of third order"},
                                    {93, 0, 125, "hexahedra of fourth order"}};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GMSH_TYPES_H
