// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "method_arguments.h"

#include <cmath>
#include <string>

namespace program {

namespace {

// PETSc is no part of most programs, and its solvers are asked for by name.
void refuse_without_petsc([[maybe_unused]] CLI::Option* option)
{
#ifndef CGAL_FLIP_FREE_MAPS_USE_PETSC
  option->check(
    [](const std::string& name) {
      return name == "petsc-gamg" || name == "petsc-mumps"
               ? "this program was built without PETSc, which is switched on by -DFLIP_FREE_MAPS_WITH_PETSC=ON"
               : "";
    },
    "");
#endif
}

} // namespace

void add_method_options(CLI::App& command, Method_arguments& arguments)
{
  command
    .add_option("--method", arguments.method,
                "the methods of the literature by their names, as published; a p- in front: with progressive references; a + at the end: "
                "with this package's line search. The options below change parts of the method. splitting may begin with flips, and drops "
                "handles at their targets")
    ->check(CLI::IsMember(method_names()))
    ->capture_default_str();
  command.add_option("--energy", arguments.energy, "what is minimised")->check(CLI::IsMember(energy_names()))->capture_default_str();
  CLI::Option* parameter = command
                             .add_option("--energy-parameter", arguments.energy_parameter,
                                         "the factor of exponential energies, mu of neo-hookean (kappa is 1); by default 1")
                             ->check(CLI::PositiveNumber);
  CLI::Option* poisson = command
                           .add_option("--poisson", arguments.poisson,
                                       "Poisson's ratio of the material that neo-hookean models, below 0.5; in the plane: plane strain")
                           ->check(CLI::Range(-0.999999, 0.499999))
                           ->excludes(parameter);
  command.add_option("--young", arguments.young, "Young's modulus of that material, 1 by default: the unit of the energy")
    ->check(CLI::PositiveNumber)
    ->needs(poisson);
  command
    .add_option("--preconditioner", arguments.preconditioner,
                "how directions are found; other than default: with a factorization in each iteration, unless --acceleration keeps "
                "them, from a Tutte embedding")
    ->check(CLI::IsMember(preconditioner_names()))
    ->capture_default_str();
  command.add_option("--reference", arguments.reference, "what distortion is measured against on the way")
    ->check(CLI::IsMember(reference_names()))
    ->capture_default_str();
  command
    .add_option("--acceleration", arguments.acceleration,
                "what is made of successive directions; inexact-newton: the direction of the current matrix, by conjugate gradients "
                "with the last factorization, for high accuracy with few factorizations")
    ->check(CLI::IsMember(acceleration_names()))
    ->capture_default_str();
  CLI::Option* linear_solver =
    command.add_option("--linear-solver", arguments.linear_solver,
                       "by default direct while the factor fits into memory, conjugate gradients (cg, petsc-gamg) beyond");
  refuse_without_petsc(linear_solver);
  linear_solver->check(CLI::IsMember(linear_solver_names()))->capture_default_str();
  command.add_option("--memory-budget", arguments.memory_budget, "GiB that the factor may take; 0: half of the memory")
    ->check(CLI::NonNegativeNumber);
  command.add_option("--trace", arguments.trace, "write a CSV row per iteration");
  command.add_flag("--polish", arguments.polish, "method splitting: its map is improved by the default method");
  add_limit_options(command, arguments);
}

void add_summary_options(CLI::App& command, Method_arguments& arguments)
{
  command.add_option("--json", arguments.json, "write the summary");
  command.add_option("--report", arguments.report, "write the summary as a page of HTML, with the pictures that this call writes");
}

void add_limit_options(CLI::App& command, Method_arguments& arguments)
{
  command
    .add_option("--criterion", arguments.criterion,
                "stopping rule that --tolerance is for: characteristic norm of the gradient (default tolerance 1e-5), norm of the "
                "gradient (1e-3), relative change of the energy (1e-6); 'auto' is the first, for symmetric-arap the last")
    ->check(CLI::IsMember(criterion_names()))
    ->capture_default_str();
  command.add_option("--tolerance", arguments.tolerance, "see --criterion")->check(CLI::NonNegativeNumber);
  command.add_option("--max-iterations", arguments.max_iterations)->check(CLI::NonNegativeNumber)->capture_default_str();
  command.add_option("--time-limit", arguments.time_limit, "seconds; the map found by then is valid")->check(CLI::PositiveNumber);
  command.add_option("--threads", arguments.threads, "at most this many; results do not depend on it")->check(CLI::PositiveNumber);
  add_summary_options(command, arguments);
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
  command
    .add_option("--progress", arguments.progress,
                "json: lines of JSON on the standard error stream, for programs that call this one; with the phase and the share that is "
                "done, the iteration and the energy or charts and faces; the last has the phase 'end', the status and the message")
    ->check(CLI::IsMember({"json"}));
}

std::string option_without_number(const CLI::App& command)
{
  for(const CLI::Option* option : command.get_options())
    if(option->count() > 0 && option->get_type_name().rfind("FLOAT", 0) == 0 && std::isnan(option->as<double>()))
      return option->get_name();
  return "";
}

} // namespace program
