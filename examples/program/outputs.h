// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What a call writes: where it must not, and surfaces with their texture coordinates.

#ifndef FLIP_FREE_MAPS_PROGRAM_OUTPUTS_H
#define FLIP_FREE_MAPS_PROGRAM_OUTPUTS_H

#include "files.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// A name of a file, and the option that it was given with.
struct File_argument
{
  std::string option, path;
};

// Why the outputs of a call would destroy each other or an input; empty if they do not. The first output is a mesh, which may replace
// the first input, from which it is made. Arguments without a path are left out.
std::string why_files_collide(const std::vector<File_argument>& inputs, const std::vector<File_argument>& outputs);

// Fails before anything is computed if a folder of an output does not exist.
void check_folders(const std::vector<File_argument>& outputs);

// Says on the command line's behalf what is wrong with it, and returns the exit code.
int refuse(const std::string& reason);

// Where a surface goes with its texture coordinates.
struct Surface_output
{
  std::string path;
  bool checker = false;
  std::size_t uv_set = 0; // of glTF
};

void add_uv_set(CLI::App& command, std::size_t& uv_set);

void add_surface_output(CLI::App& command, Surface_output& output, const std::string& what);

// Why the output of an input cannot be written, by their names and options; empty if it can.
std::string why_not_written(const std::string& input, const Surface_output& output);

// The names of all files of an output.
std::vector<File_argument> files_of(const Surface_output& output);

// Writes the surface's file with these images, or a new one if the format is another one or the polygons are. Returns what the user must
// know of it, mostly nothing.
std::string write_surface(const Surface_output& output, const Surface& surface, const Corner_images& images);

// Adds such a note to a message.
void add_note(std::string& message, const std::string& note);

// The text of a file of polygons, by its extension, but not of glTF. All digits are written.
std::string surface_text(const std::string& extension, const Surface& surface);

void write_text(const std::string& path, const std::string& text);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_OUTPUTS_H
