// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Functions that flatten surfaces by a method of the caller's choice.

#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace python {

program::Method_choice method_choice(const py::dict& options)
{
  program::Method_choice choice;
  read(options, "method", choice.method);
  read(options, "energy", choice.energy);
  read(options, "energy_parameter", choice.energy_parameter);
  read(options, "preconditioner", choice.preconditioner);
  read(options, "reference", choice.reference);
  read(options, "acceleration", choice.acceleration);
  read(options, "linear_solver", choice.linear_solver);
  read(options, "criterion", choice.criterion);
  read(options, "tolerance", choice.tolerance);
  read(options, "max_iterations", choice.max_iterations);
  read(options, "time_limit", choice.time_limit);
  return choice;
}

program::Start_choice start_choice(const py::dict& options)
{
  program::Start_choice choice;
  read(options, "start", choice.start);
  read(options, "border", choice.border);
  read(options, "weights", choice.weights);
  return choice;
}

namespace {

using Uv = std::vector<std::array<double, 2>>;
using Soft_position = std::tuple<FFM::internal::Surface_vertex, std::array<double, 2>, double>;

// What is asked of the vertices of a map.
struct Constraints
{
  bool border_is_fixed = false, is_bijective = false;
  std::vector<char> is_fixed; // by vertex
  std::vector<Soft_position> soft;
  Uv start; // by vertex, or empty
};

template <typename Traits>
FFM::Summary flatten(const Points& points, const Triangles& triangles, const Traits& traits, Constraints& constraints, Uv& uv)
{
  using FFM::internal::Array_map;
  const auto np = FFM::parameters::map_traits(
    traits, FFM::parameters::bijective(constraints.is_bijective,
                                       FFM::parameters::border_is_fixed(
                                         constraints.border_is_fixed,
                                         FFM::parameters::soft_positions(constraints.soft, CGAL::parameters::vertex_is_constrained_map(
                                                                                             Array_map<char>{&constraints.is_fixed})))));
  if(constraints.start.empty())
    return FFM::parameterize(points, triangles, uv, np);
  return FFM::parameterize(points, triangles, uv, FFM::parameters::start_map(Array_map<std::array<double, 2>>{&constraints.start}, np));
}

Constraints read_constraints(const py::dict& given, std::size_t number_of_points)
{
  Constraints constraints;
  read(given, "fix_border", constraints.border_is_fixed);
  read(given, "bijective", constraints.is_bijective);
  constraints.is_fixed.assign(number_of_points, 0);
  if(given.contains("fixed"))
    for(const auto& v : Rows<std::int64_t, 1>(given["fixed"], "fixed"))
      constraints.is_fixed[v[0]] = 1;
  if(given.contains("soft_vertices")) {
    const Rows<std::int64_t, 1> vertices(given["soft_vertices"], "soft vertices");
    const Rows<double, 3> places(given["soft_places"], "soft places");
    for(std::size_t i = 0; i < vertices.size(); ++i)
      constraints.soft.emplace_back(FFM::internal::vertex_of_index(vertices[i][0], number_of_points),
                                    std::array<double, 2>{{places[i][0], places[i][1]}}, places[i][2]);
  }
  if(given.contains("given_start")) {
    const Planar_points start(given["given_start"], "start");
    constraints.start.assign(start.begin(), start.end());
  }
  return constraints;
}

// The corners of the polygon to which the border is mapped.
void read_polygon(const py::dict& given, FFM::Start_options& start)
{
  if(!given.contains("polygon"))
    return;
  const Planar_points polygon(given["polygon"], "border");
  start.border = FFM::Border_shape::polygon;
  start.polygon.assign(polygon.begin(), polygon.end());
}

} // namespace

py::dict names()
{
  py::dict result;
  result["method"] = program::method_names();
  result["energy"] = program::energy_names();
  result["preconditioner"] = program::preconditioner_names();
  result["reference"] = program::reference_names();
  result["acceleration"] = program::acceleration_names();
  result["linear_solver"] = program::linear_solver_names();
  result["criterion"] = program::criterion_names();
  result["border"] = program::border_names();
  result["weights"] = program::weight_names();
  return result;
}

py::tuple parameterize(const py::array& points, const py::array& triangles, const py::dict& given, const py::object& progress)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const program::Method_choice choice = method_choice(given);
  const std::string reason = why_not_available(choice, 2);
  if(!reason.empty())
    return refusal(reason);
  Constraints constraints = read_constraints(given, p.size());
  const auto set_up = [&](auto& traits) {
    set_limits(choice, traits.options);
    set_start(start_choice(given), constraints.border_is_fixed || given.contains("fixed"), traits.start);
    read_polygon(given, traits.start);
  };
  Watch watch(progress);
  Uv uv;
  FFM::Summary summary;
  if(choice.is_default()) {
    FFM::Flip_free_map_traits<> traits;
    set_up(traits);
    traits.options.observer = watch.observer<FFM::Iteration_report>();
    const py::gil_scoped_release unlocked;
    summary = flatten(p, t, traits, constraints, uv);
  } else {
    FFM::Any_map_traits traits = make_traits(choice);
    set_up(traits);
    traits.options.observer = watch.observer<FFM::Iteration_report>();
    const py::gil_scoped_release unlocked;
    summary = flatten(p, t, traits, constraints, uv);
    traits.name_choices(summary);
  }
  watch.raise();
  return py::make_tuple(array_of(uv), account(summary));
}

py::tuple repair(const py::array& points, const py::array& triangles, const py::array& uv, const py::dict& given,
                 const py::object& progress)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Planar_points images(uv, "uv");
  const program::Method_choice choice = method_choice(given);
  Watch watch(progress);
  FFM::Repair_options options;
  read(given, "polish", options.polish);
  read(given, "fix_border", options.fix_border);
  set_limits(choice, options);
  options.splitting.observer = watch.observer<FFM::Splitting_report>();
  FFM::Map_options map_options;
  set_limits(choice, map_options);
  map_options.observer = watch.observer<FFM::Iteration_report>();
  Uv result(images.begin(), images.end());
  FFM::Summary summary;
  {
    const py::gil_scoped_release unlocked;
    summary = FFM::repair_map(p, t, result, FFM::parameters::repair_options(options, FFM::parameters::map_options(map_options)));
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

} // namespace python
