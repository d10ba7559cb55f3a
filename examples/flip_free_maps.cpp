// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The package at work on files: see `flip_free_maps --help`. The sub-commands are in the folder program/.

#include "program/commands.h"
#include "program/interruption.h"
#include "program/large_pages.h"
#include "program/outputs.h"
#include "program/report.h"

#include <CGAL/Flip_free_maps/version.h>

int main(int argc, char** argv)
{
  program::want_large_pages(argc, argv);
  CLI::App app("Low-distortion maps of meshes in which no element is flipped.");
  app.require_subcommand(1);
  app.footer(program::exit_codes_text());
  app.set_version_flag("--version", "flip_free_maps " CGAL_FLIP_FREE_MAPS_VERSION);
  std::unique_ptr<program::Command> commands[] = {
    program::parameterize_command(app), program::unwrap_command(app), program::deform_command(app),  program::repair_command(app),
    program::map_volume_command(app),   program::morph_command(app),  program::measure_command(app), program::pack_command(app)};
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  program::catch_signals();
  for(const auto& command : commands) {
    if(!*command->app)
      continue;
    const std::string option = program::option_without_number(*command->app);
    return option.empty() ? command->run() : program::refuse(option + " wants a number");
  }
  return 2;
}
