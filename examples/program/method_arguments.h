// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The options of sub-commands that minimise an energy.

#ifndef FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H
#define FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H

#include "methods.h"
#include "types.h"

#include <CLI/CLI.hpp>

#include <string>

namespace program {

// The options of all sub-commands that minimise an energy.
struct Method_arguments : Method_choice
{
  std::string json, report, trace, progress;
  double memory_budget = 0;
  int threads = 0;
  bool quiet = false, polish = false;
};

void add_method_options(CLI::App& command, Method_arguments& arguments);

// The files of the summary.
void add_summary_options(CLI::App& command, Method_arguments& arguments);

// Those of them that tell when to stop and what to report.
void add_limit_options(CLI::App& command, Method_arguments& arguments);

// Names an option whose number is NaN, which no comparison of a check finds; empty if there is none.
std::string option_without_number(const CLI::App& command);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H
