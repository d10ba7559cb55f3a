// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "methods.h"

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
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_direct_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid.h>
#endif

#include <CGAL/number_type_config.h>

#include <cmath>
#include <map>
#include <vector>

namespace program {

namespace {

// The energies of --energy; some take --energy-parameter.
std::map<std::string, FFM::Any_energy> energies(const Method_choice& choice)
{
  const double parameter = choice.energy_parameter;
  FFM::Exponential_symmetric_dirichlet exponential_symmetric_dirichlet;
  FFM::Exponential_amips exponential_amips;
  FFM::Neo_hookean neo_hookean;
  if(choice.is_material_given())
    neo_hookean = FFM::Neo_hookean::of_material(choice.young, choice.poisson, choice.dimension);
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

std::vector<std::string> method_names()
{
  std::vector<std::string> result{"default", "splitting", "splitting+"};
  for(const FFM::Published_method& method : FFM::Any_map_traits::published_methods())
    for(const char* search : {"", "+"})
      result.push_back(method.name + search);
  return result;
}

std::vector<std::string> energy_names() { return names(energies(Method_choice())); }

std::vector<std::string> preconditioner_names() { return names(preconditioners()); }

std::vector<std::string> reference_names() { return {"default", "fixed", "progressive"}; }

std::vector<std::string> acceleration_names() { return {"default", "none", "nesterov", "lbfgs", "inexact-newton"}; }

std::vector<std::string> linear_solver_names()
{
  std::vector<std::string> solvers{"default", "eigen"};
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  solvers.push_back("cholmod");
#endif
  solvers.push_back("cg");
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
  solvers.push_back("petsc-gamg");
  solvers.push_back("petsc-mumps");
#endif
  return solvers;
}

std::vector<std::string> criterion_names() { return {"auto", "characteristic", "gradient", "energy"}; }

std::vector<std::string> border_names() { return {"circle", "triangle", "square", "octagon"}; }

std::vector<std::string> weight_names() { return {"uniform", "mean-value", "cotangent"}; }

std::string why_not_available(const Method_choice& choice, int dimension)
{
  FFM::Any_map_traits traits = make_traits(choice);
  if(choice.is_material_given() && choice.energy != "neo-hookean")
    return "--poisson is for the energy neo-hookean";
  if(choice.is_splitting()) {
    if(choice.energy != "symmetric-gradient" && choice.energy != "symmetric-dirichlet")
      return "the splitting scheme is for the energies symmetric-gradient and symmetric-dirichlet";
    if(choice.preconditioner != "default" || choice.reference != "default" || choice.acceleration != "default" ||
       choice.criterion != "auto")
      return "the splitting scheme has no preconditioner, reference, acceleration nor criterion to choose";
  }
  const std::string name = traits.preconditioner.preconditioner_name();
  if(traits.preconditioner.is_planar() && dimension != 2)
    return name + " is a method of the plane";
  if(traits.preconditioner.is_planar() && !traits.energy.is_convex_concave())
    return name + " needs an energy with a convex-concave decomposition, which " + choice.energy +
           " has not; choose newton, slim or killing";
  return "";
}

FFM::Any_map_traits make_traits(const Method_choice& choice)
{
  FFM::Any_map_traits traits;
  traits.use_method(choice.method);
  traits.energy = energies(choice).at(choice.energy);
  if(choice.preconditioner != "default") {
    // It takes the place of another in a method of the literature.
    if(choice.method == "default")
      traits.use_method("projected-newton+");
    traits.preconditioner = preconditioners().at(choice.preconditioner);
  }
  if(choice.reference == "progressive")
    traits.use_progressive_reference();
  else if(choice.reference == "fixed")
    traits.use_fixed_reference();
  if(choice.acceleration == "none") {
    traits.acceleration = FFM::Any_acceleration(FFM::No_acceleration());
    traits.refactorization_rule = FFM::Every_iteration();
  } else if(choice.acceleration == "nesterov") {
    traits.acceleration = FFM::Any_acceleration(FFM::Nesterov());
    traits.refactorization_rule = FFM::Every_iteration();
  } else if(choice.acceleration == "lbfgs") {
    traits.acceleration = FFM::Any_acceleration(FFM::Lbfgs());
    traits.refactorization_rule = FFM::On_demand();
    traits.options.begin_with_largest_step = false;
  } else if(choice.acceleration == "inexact-newton") {
    traits.acceleration = FFM::Any_acceleration(FFM::Inexact_newton());
    traits.refactorization_rule = FFM::On_demand();
  }
  if(choice.linear_solver == "eigen")
    traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
  else if(choice.linear_solver == "cg")
    traits.use_linear_solver<FFM::Conjugate_gradient_solver<>>();
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  else if(choice.linear_solver == "cholmod")
    traits.use_linear_solver<FFM::Cholmod_solver>();
#endif
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
  else if(choice.linear_solver == "petsc-gamg")
    traits.use_linear_solver<FFM::Conjugate_gradient_solver<FFM::Petsc_multigrid>>();
  else if(choice.linear_solver == "petsc-mumps")
    traits.use_linear_solver<FFM::Petsc_direct_solver>();
#endif
  return traits;
}

void set_limits(const Method_choice& choice, FFM::Map_options& options)
{
  options.max_iterations = choice.max_iterations;
  if(choice.time_limit > 0)
    options.max_seconds = choice.time_limit;
  const double default_tolerance = options.characteristic_gradient_tolerance;
  options.characteristic_gradient_tolerance = 0;
  // Where the gradient jumps at the optimum it tells nothing.
  if(choice.criterion == "energy" || (choice.criterion == "auto" && choice.energy == "symmetric-arap"))
    options.relative_energy_tolerance = choice.tolerance >= 0 ? choice.tolerance : 1e-6;
  else if(choice.criterion == "gradient")
    options.gradient_tolerance = choice.tolerance >= 0 ? choice.tolerance : 1e-3;
  else
    options.characteristic_gradient_tolerance = choice.tolerance >= 0 ? choice.tolerance : default_tolerance;
}

void set_splitting(const Method_choice& choice, FFM::Splitting_options& options)
{
  if(choice.method == "splitting")
    options = FFM::Splitting_options::published();
  if(choice.tolerance >= 0)
    options.relative_tolerance = choice.tolerance;
}

void set_start(const Start_choice& choice, bool has_fixed_vertices, FFM::Start_options& options)
{
  options.weights = choice.weights == "mean-value"  ? FFM::Tutte_weights::mean_value
                    : choice.weights == "cotangent" ? FFM::Tutte_weights::cotangent
                                                    : FFM::Tutte_weights::uniform;
  const int corners = choice.border == "triangle" ? 3 : choice.border == "octagon" ? 8 : 0;
  for(int i = 0; i < corners; ++i)
    options.polygon.push_back({std::cos(2 * CGAL_PI * i / corners), std::sin(2 * CGAL_PI * i / corners)});
  options.border = corners > 0                 ? FFM::Border_shape::polygon
                   : choice.border == "square" ? FFM::Border_shape::square
                                               : FFM::Border_shape::circle;
  if(choice.start == "tutte" || (choice.start == "auto" && has_fixed_vertices))
    options.multilevel_size = -1;
  else if(choice.start == "multilevel")
    options.multilevel_size = 0;
}

} // namespace program
