// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps to the plane, written and drawn.

#ifndef FLIP_FREE_MAPS_PROGRAM_LAYOUT_H
#define FLIP_FREE_MAPS_PROGRAM_LAYOUT_H

#include "Atlas.h"
#include "method_arguments.h"
#include "outputs.h"

#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace program {

// The options of sub-commands that draw a layout, or the surface that has it as its texture.
struct Picture_arguments
{
  std::string svg, png, png3d;
  int width = 1200;
  char up = 'y'; // of the surface
};

// Before anything is computed, not when the picture is due.
void refuse_without_cairo(CLI::Option* option);

void add_picture_options(CLI::App& command, Picture_arguments& arguments);

// The files of the pictures that are asked for.
std::vector<std::string> pictures_of(const Picture_arguments& arguments);

void add_picture_width(CLI::App& command, Picture_arguments& arguments);

// The picture of the surface, which sub-commands have that write texture coordinates or measure them.
void add_surface_picture(CLI::App& command, Picture_arguments& arguments);

void write_pictures(const Picture_arguments& arguments, const std::string& input, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion, const FFM::Summary& summary);

// The same with a title.
void write_pictures(const Picture_arguments& arguments, const std::string& title, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion);

// Draws the surface alone.
void write_surface_picture(const Picture_arguments& arguments, const FFM::Textured_mesh& layout);

// All files that a call writes, the surface first.
std::vector<File_argument> files_of(const Surface_output& output, const Picture_arguments& pictures, const Method_arguments& method);

// The files of sub-commands that map a patch to the plane.
struct Layout_arguments
{
  std::string input;
  Surface_output output;
  bool unit_square = false;
  Picture_arguments pictures;
};

// Those but the pictures' options, which come last.
void add_layout_options(CLI::App& command, Layout_arguments& arguments, const std::string& input, const std::string& output);

std::vector<File_argument> files_of(const Layout_arguments& arguments, const Method_arguments& method);

// Writes and draws the map `images`, whatever of it is asked for; if it has to be scaled, it is certified anew. Returns the note of
// write_surface().
std::string write_layout(const Layout_arguments& arguments, const Surface& surface, Corner_images images, const FFM::Summary& summary);

// The image of each vertex at all of its corners.
Corner_images corner_images(const Surface& surface, const std::vector<Kernel::Point_2>& uv);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_LAYOUT_H
