// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The options of sub-commands that minimise an energy.

#ifndef FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H
#define FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H

#include "types.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>

#include <CLI/CLI.hpp>

#include <string>

namespace program {

// The options of all sub-commands that minimise an energy.
struct Method_arguments
{
  std::string method = "default", energy = "symmetric-dirichlet", preconditioner = "default", reference = "default",
              acceleration = "default", criterion = "auto", linear_solver = "default", json, trace;
  double tolerance = -1;
  int max_iterations = FFM::Map_options().max_iterations;
  double time_limit = 0;
  double energy_parameter = 0, memory_budget = 0;
  int threads = 0;
  bool quiet = false, polish = false;

  bool is_splitting() const { return method == "splitting"; }

  // Whether nothing but the default method is asked for.
  bool is_default() const
  {
    return method == "default" && energy == "symmetric-dirichlet" && preconditioner == "default" && reference == "default" &&
           acceleration == "default" && linear_solver == "default";
  }
};

void add_method_options(CLI::App& command, Method_arguments& arguments);

// Those of them that tell when to stop and what to report.
void add_limit_options(CLI::App& command, Method_arguments& arguments);

// Why the options contradict each other; empty if they do not.
std::string why_not_available(const Method_arguments& arguments, int dimension);

FFM::Any_map_traits make_traits(const Method_arguments& arguments);

// Sets limits and tolerances.
void set_limits(const Method_arguments& arguments, FFM::Map_options& options);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_METHOD_ARGUMENTS_H
