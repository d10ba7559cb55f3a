// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "method_arguments.h"

#include <CGAL/Flip_free_maps/energies/Aigerman_isometric.h>
#include <CGAL/Flip_free_maps/energies/Amips.h>
#include <CGAL/Flip_free_maps/energies/Arap.h>
#include <CGAL/Flip_free_maps/energies/Conformal.h>
#include <CGAL/Flip_free_maps/energies/Exponential_amips.h>
#include <CGAL/Flip_free_maps/energies/Exponential_symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Hencky.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_arap.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>

#include <map>
#include <vector>

namespace program {

namespace {

// The energies of --energy; some take --energy-parameter.
std::map<std::string, FFM::Any_energy> energies(double parameter)
{
  FFM::Exponential_symmetric_dirichlet exponential_symmetric_dirichlet;
  FFM::Exponential_amips exponential_amips;
  FFM::Neo_hookean neo_hookean;
  if(parameter > 0) {
    exponential_symmetric_dirichlet.factor = parameter;
    exponential_amips.factor = parameter;
    neo_hookean.mu = parameter;
  }
  return {{"symmetric-dirichlet", FFM::Any_energy(FFM::Symmetric_dirichlet())},
          {"exponential-symmetric-dirichlet", FFM::Any_energy(exponential_symmetric_dirichlet)},
          {"symmetric-gradient", FFM::Any_energy(FFM::Symmetric_gradient())},
          {"symmetric-arap", FFM::Any_energy(FFM::Symmetric_arap())},
          {"arap", FFM::Any_energy(FFM::Arap())},
          {"hencky", FFM::Any_energy(FFM::Hencky())},
          {"conformal", FFM::Any_energy(FFM::Conformal())},
          {"amips", FFM::Any_energy(FFM::Amips())},
          {"exponential-amips", FFM::Any_energy(exponential_amips)},
          {"neo-hookean", FFM::Any_energy(neo_hookean)},
          {"aigerman-isometric", FFM::Any_energy(FFM::Aigerman_isometric())}};
}

FFM::Projected_newton filtered_newton(FFM::Eigenvalue_filter filter)
{
  FFM::Projected_newton newton;
  newton.filter = filter;
  return newton;
}

const std::map<std::string, FFM::Any_preconditioner>& preconditioners()
{
  static const std::map<std::string, FFM::Any_preconditioner> all{
    {"default", FFM::Any_preconditioner()},
    {"laplacian", FFM::Any_preconditioner(FFM::Laplacian())},
    {"killing", FFM::Any_preconditioner(FFM::Killing())},
    {"stiff-killing", FFM::Any_preconditioner(FFM::Killing{FFM::Killing_weight::stiffness})},
    {"slim", FFM::Any_preconditioner(FFM::Slim())},
    {"cm", FFM::Any_preconditioner(FFM::Composite_majorization<>())},
    {"cm-ungathered", FFM::Any_preconditioner(FFM::Composite_majorization<false>())},
    {"projected-newton", FFM::Any_preconditioner(FFM::Projected_newton())},
    {"absolute-newton", FFM::Any_preconditioner(filtered_newton(FFM::Eigenvalue_filter::absolute))},
    {"trust-region-newton", FFM::Any_preconditioner(filtered_newton(FFM::Eigenvalue_filter::trust_region))},
    {"vertex-space-newton", FFM::Any_preconditioner(FFM::Vertex_space_newton())},
    {"newton", FFM::Any_preconditioner(FFM::Newton())},
    {"hybrid", FFM::Any_preconditioner(FFM::Hybrid<>())}};
  return all;
}

template <typename Map>
std::vector<std::string> names(const Map& map)
{
  std::vector<std::string> result;
  for(const auto& entry : map)
    result.push_back(entry.first);
  return result;
}

} // namespace

void add_method_options(CLI::App& command, Method_arguments& arguments)
{
  command
    .add_option("--method", arguments.method,
                "the methods of the literature by their names; a p- in front: with progressive references. The options below change parts "
                "of the method. splitting may begin with flips, and drops handles at their targets")
    ->check(CLI::IsMember(
      {"default", "pp", "cm", "slim", "akvf", "p-cm", "p-slim", "p-akvf", "aqp", "sobolev", "newton", "projected-newton", "splitting"}))
    ->capture_default_str();
  command.add_option("--energy", arguments.energy, "what is minimised")->check(CLI::IsMember(names(energies(0))))->capture_default_str();
  command
    .add_option("--energy-parameter", arguments.energy_parameter,
                "the factor of exponential energies, mu of neo-hookean (kappa is 1); by default 1")
    ->check(CLI::PositiveNumber);
  command
    .add_option("--preconditioner", arguments.preconditioner,
                "how directions are found; other than default: with a factorization in each iteration, unless --acceleration keeps "
                "them, from a Tutte embedding")
    ->check(CLI::IsMember(names(preconditioners())))
    ->capture_default_str();
  command.add_option("--reference", arguments.reference, "what distortion is measured against on the way")
    ->check(CLI::IsMember({"default", "fixed", "progressive"}))
    ->capture_default_str();
  command
    .add_option("--acceleration", arguments.acceleration,
                "what is made of successive directions; inexact-newton: the direction of the current matrix, by conjugate gradients "
                "with the last factorization, for high accuracy with few factorizations")
    ->check(CLI::IsMember({"default", "none", "nesterov", "lbfgs", "inexact-newton"}))
    ->capture_default_str();
  std::vector<std::string> solvers{"default", "eigen"};
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  solvers.push_back("cholmod");
#endif
  solvers.push_back("cg");
  command
    .add_option("--linear-solver", arguments.linear_solver,
                "by default direct while the factor fits into memory, conjugate gradients (cg) beyond")
    ->check(CLI::IsMember(solvers))
    ->capture_default_str();
  command.add_option("--memory-budget", arguments.memory_budget, "GiB that the factor may take; 0: half of the memory")
    ->check(CLI::NonNegativeNumber);
  command.add_option("--trace", arguments.trace, "write a CSV row per iteration");
  command.add_flag("--polish", arguments.polish, "method splitting: its map is improved by the default method");
  add_limit_options(command, arguments);
}

void add_limit_options(CLI::App& command, Method_arguments& arguments)
{
  command
    .add_option("--criterion", arguments.criterion,
                "stopping rule that --tolerance is for: characteristic norm of the gradient (default tolerance 1e-5), norm of the "
                "gradient (1e-3), relative change of the energy (1e-6); 'auto' is the first, for symmetric-arap the last")
    ->check(CLI::IsMember({"auto", "characteristic", "gradient", "energy"}))
    ->capture_default_str();
  command.add_option("--tolerance", arguments.tolerance, "see --criterion")->check(CLI::NonNegativeNumber);
  command.add_option("--max-iterations", arguments.max_iterations)->check(CLI::NonNegativeNumber)->capture_default_str();
  command.add_option("--time-limit", arguments.time_limit, "seconds; the map found by then is valid")->check(CLI::PositiveNumber);
  command.add_option("--threads", arguments.threads, "at most this many; results do not depend on it")->check(CLI::PositiveNumber);
  command.add_option("--json", arguments.json, "write the summary");
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

std::string why_not_available(const Method_arguments& arguments, int dimension)
{
  FFM::Any_map_traits traits = make_traits(arguments);
  if(arguments.is_splitting()) {
    if(arguments.energy != "symmetric-gradient" && arguments.energy != "symmetric-dirichlet")
      return "the splitting scheme is for the energies symmetric-gradient and symmetric-dirichlet";
    if(arguments.preconditioner != "default" || arguments.reference != "default" || arguments.acceleration != "default" ||
       arguments.criterion != "auto")
      return "the splitting scheme has no preconditioner, reference, acceleration nor criterion to choose";
  }
  const std::string name = traits.preconditioner.preconditioner_name();
  if(traits.preconditioner.is_planar() && dimension != 2)
    return name + " is a method of the plane";
  if(traits.preconditioner.is_planar() && !traits.energy.is_convex_concave())
    return name + " needs an energy with a convex-concave decomposition, which " + arguments.energy +
           " has not; choose newton, slim or killing";
  return "";
}

FFM::Any_map_traits make_traits(const Method_arguments& arguments)
{
  FFM::Any_map_traits traits;
  traits.use_method(arguments.method);
  traits.energy = energies(arguments.energy_parameter).at(arguments.energy);
  if(arguments.preconditioner != "default") {
    // What is not asked for is taken from the methods of the literature.
    traits.use_method("projected-newton");
    traits.preconditioner = preconditioners().at(arguments.preconditioner);
    if(arguments.reference == "default" && arguments.method != "default") {
      FFM::Any_map_traits method;
      method.use_method(arguments.method);
      traits.reference = method.reference;
    }
  }
  if(arguments.reference == "progressive")
    traits.use_progressive_reference();
  else if(arguments.reference == "fixed")
    traits.use_fixed_reference();
  if(arguments.acceleration == "none") {
    traits.acceleration = FFM::Any_acceleration(FFM::No_acceleration());
    traits.refactorization_rule = FFM::Every_iteration();
  } else if(arguments.acceleration == "nesterov") {
    traits.acceleration = FFM::Any_acceleration(FFM::Nesterov());
    traits.refactorization_rule = FFM::Every_iteration();
  } else if(arguments.acceleration == "lbfgs") {
    traits.acceleration = FFM::Any_acceleration(FFM::Lbfgs());
    traits.refactorization_rule = FFM::On_demand();
    traits.options.begin_with_largest_step = false;
  } else if(arguments.acceleration == "inexact-newton") {
    traits.acceleration = FFM::Any_acceleration(FFM::Inexact_newton());
    traits.refactorization_rule = FFM::On_demand();
  }
  if(arguments.linear_solver == "eigen")
    traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
  else if(arguments.linear_solver == "cg")
    traits.use_linear_solver<FFM::Conjugate_gradient_solver<>>();
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  else if(arguments.linear_solver == "cholmod")
    traits.use_linear_solver<FFM::Cholmod_solver>();
#endif
  return traits;
}

void set_limits(const Method_arguments& arguments, FFM::Map_options& options)
{
  options.max_iterations = arguments.max_iterations;
  if(arguments.time_limit > 0)
    options.max_seconds = arguments.time_limit;
  const double default_tolerance = options.characteristic_gradient_tolerance;
  options.characteristic_gradient_tolerance = 0;
  // Where the gradient jumps at the optimum it tells nothing.
  if(arguments.criterion == "energy" || (arguments.criterion == "auto" && arguments.energy == "symmetric-arap"))
    options.relative_energy_tolerance = arguments.tolerance >= 0 ? arguments.tolerance : 1e-6;
  else if(arguments.criterion == "gradient")
    options.gradient_tolerance = arguments.tolerance >= 0 ? arguments.tolerance : 1e-3;
  else
    options.characteristic_gradient_tolerance = arguments.tolerance >= 0 ? arguments.tolerance : default_tolerance;
}

} // namespace program
