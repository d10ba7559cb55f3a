// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "packing_arguments.h"

namespace program {

void add_packing_options(CLI::App& command, Packing_arguments& arguments)
{
  CLI::Option* margin =
    command.add_option("--margin", arguments.options.margin, "least distance between charts, in parts of the square's side")
      ->capture_default_str();
  CLI::Option* resolution =
    command.add_option("--resolution", arguments.options.resolution, "the side of the texture in pixels, for --padding")
      ->check(CLI::PositiveNumber)
      ->excludes(margin);
  command
    .add_option("--padding", arguments.options.padding,
                "with --resolution: least distance between charts in pixels; half of it is kept from the sides")
    ->needs(resolution)
    ->capture_default_str();
  command.add_flag("--no-rotation", arguments.no_rotation, "do not turn charts other than by quarters");
}

FFM::Packing_options Packing_arguments::chosen() const
{
  FFM::Packing_options result = options;
  result.rotate = !no_rotation;
  return result;
}

} // namespace program
