// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The sub-commands: each adds itself to the application, and runs if it was chosen.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMANDS_H
#define FLIP_FREE_MAPS_PROGRAM_COMMANDS_H

#include <CLI/CLI.hpp>

#include <memory>

namespace program {

class Command
{
public:
  virtual ~Command() = default;
  virtual int run() = 0;
  CLI::App* app = nullptr;
};

std::unique_ptr<Command> parameterize_command(CLI::App& app);
std::unique_ptr<Command> unwrap_command(CLI::App& app);
std::unique_ptr<Command> deform_command(CLI::App& app);
std::unique_ptr<Command> repair_command(CLI::App& app);
std::unique_ptr<Command> map_volume_command(CLI::App& app);
std::unique_ptr<Command> morph_command(CLI::App& app);
std::unique_ptr<Command> measure_command(CLI::App& app);
std::unique_ptr<Command> pack_command(CLI::App& app);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMANDS_H
