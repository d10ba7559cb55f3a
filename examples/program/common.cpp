// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "common.h"

#include <CGAL/Flip_free_maps/IO/volume_files.h>
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
#include <CGAL/Flip_free_maps/io.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/iterator.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <new>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

int exit_code(Status status) { return FFM::is_valid_map(status) ? 0 : static_cast<int>(status) - static_cast<int>(Status::empty_mesh) + 3; }

std::string exit_codes_text()
{
  std::string text = "Exit codes: 0 a valid map was written (converged, or ended by a limit); 2 wrong command line";
  for(int s = static_cast<int>(Status::empty_mesh); s <= static_cast<int>(Status::not_bijective); ++s)
    text += "; " + std::to_string(exit_code(static_cast<Status>(s))) + " " + FFM::status_name(static_cast<Status>(s));
  return text + ".";
}

void check(bool done, const std::string& message)
{
  if(!done)
    throw Failure{Status::file_error, message};
}

void write_json(const std::string& path, const nlohmann::json& json)
{
  if(path.empty())
    return;
  std::ofstream out(path);
  // Messages quote names of files, which need not be UTF-8.
  out << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  check(bool(out.flush()), "cannot write " + path);
}

namespace {

bool is_finite(const Kernel::Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

std::string why_not_manifold(const std::vector<std::vector<std::size_t>>& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> edges; // how many faces use an edge forwards and backwards
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % 3];
      ++(v < w ? edges[{v, w}].first : edges[{w, v}].second);
    }
  bool is_oriented = true;
  for(const auto& edge : edges) {
    if(edge.second.first + edge.second.second > 2)
      return "the edge between vertices " + std::to_string(edge.first.first) + " and " + std::to_string(edge.first.second) +
             " has more than two faces";
    is_oriented = is_oriented && edge.second.first <= 1 && edge.second.second <= 1;
  }
  return is_oriented ? "several sheets of the surface meet at a vertex"
                     : "neighbouring faces are oriented differently: orient them alike first; a Moebius strip cannot be";
}

} // namespace

namespace {

// CGAL's reader of PLY trusts that each property belongs to an element.
bool is_header_ordered(std::istream& in)
{
  std::string line, word;
  while(std::getline(in, line)) {
    word.clear();
    std::istringstream(line) >> word;
    if(word == "property")
      return false;
    if(word == "element" || word == "end_header")
      return true;
  }
  return true;
}

} // namespace

bool read_soup(const std::string& path, std::vector<Kernel::Point_3>& points, std::vector<std::vector<std::size_t>>& polygons)
{
  std::ifstream in(path, std::ios::binary);
  check(bool(in), "cannot open " + path);
  return (FFM::internal::lower_case_extension(path) != ".ply" || is_header_ordered(in)) &&
         CGAL::IO::read_polygon_soup(path, points, polygons);
}

namespace {

void read_polygons(const std::string& path, Triangles& triangles)
{
  if(!read_soup(path, triangles.points, triangles.polygons))
    throw Failure{Status::file_error, path + " is not an OFF, OBJ, PLY or STL file, or is truncated or malformed: a coordinate may not be "
                                             "a finite number, or a face name a vertex that does not exist"};
  if(triangles.polygons.empty())
    throw Failure{Status::empty_mesh, "the file holds no faces"};
  for(std::size_t i = 0; i < triangles.polygons.size(); ++i)
    for(std::size_t v : triangles.polygons[i])
      if(v >= triangles.points.size())
        throw Failure{Status::file_error, "face number " + std::to_string(i) + " names a vertex that does not exist"};
}

void make_mesh(const std::string& path, Triangles& triangles)
{
  auto& points = triangles.points;
  auto& polygons = triangles.polygons;
  for(std::size_t i = 0; i < polygons.size(); ++i) {
    const auto& polygon = polygons[i];
    const std::string face = "face number " + std::to_string(i);
    if(polygon.size() != 3)
      throw Failure{Status::not_triangular, face + " has " + std::to_string(polygon.size()) + " corners; triangulate the mesh first"};
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Failure{Status::non_manifold, face + " names a vertex twice"};
  }
  for(const auto& p : points)
    if(!is_finite(p))
      throw Failure{Status::non_finite_input, "a coordinate of the mesh is NaN or infinite"};
  // STL has no shared vertices.
  if(path.size() > 4 && (path.substr(path.size() - 4) == ".stl" || path.substr(path.size() - 4) == ".STL"))
    PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Failure{Status::non_manifold, why_not_manifold(polygons)};
  PMP::polygon_soup_to_polygon_mesh(points, polygons, triangles.mesh);
}

// Leaves a mesh of triangles, or nothing.
std::string repair_polygons(Triangles& triangles)
{
  auto& points = triangles.points;
  auto& polygons = triangles.polygons;
  const std::size_t points_before = points.size(), polygons_before = polygons.size();
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                [&](const std::vector<std::size_t>& polygon) {
                                  return !std::all_of(polygon.begin(), polygon.end(), [&](std::size_t v) { return is_finite(points[v]); });
                                }),
                 polygons.end());
  const std::size_t finite_polygons = polygons.size();
  PMP::remove_isolated_points_in_polygon_soup(points, polygons);
  PMP::repair_polygon_soup(points, polygons);
  const std::size_t points_merged = points.size(), polygons_merged = polygons.size();
  std::vector<Kernel::Point_3> first_corners;
  for(const auto& polygon : polygons)
    first_corners.push_back(points[polygon[0]]);
  PMP::orient_polygon_soup(points, polygons);
  const std::size_t points_split = points.size();
  std::size_t reversed = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    reversed += points[polygons[i][0]] != first_corners[i];
  Mesh mesh;
  if(!polygons.empty())
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  const std::size_t faces_triangulated = mesh.number_of_faces();
  PMP::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  points.clear();
  polygons.clear();
  for(const Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(const auto face : mesh.faces()) {
    polygons.emplace_back();
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      polygons.back().push_back(v);
  }
  const auto step = [](std::size_t before, std::size_t after, const std::string& what) {
    return before == after ? "" : ", " + what + " (" + std::to_string(before) + " -> " + std::to_string(after) + ")";
  };
  const std::string text = step(polygons_before, finite_polygons, "faces with coordinates that are not finite were removed") +
                           step(points_before, points_merged, "equal and unused points were removed") +
                           step(finite_polygons, polygons_merged, "duplicated and collapsed faces were removed") +
                           (reversed == 0 ? "" : ", " + std::to_string(reversed) + " faces were turned over") +
                           step(points_merged, points_split, "points of several sheets were doubled") +
                           step(polygons_merged, faces_triangulated, "polygons were triangulated") +
                           step(faces_triangulated, polygons.size(), "faces without area were removed");
  return text.empty() ? "nothing had to be repaired" : "repaired: " + text.substr(2);
}

} // namespace

void read_triangles(const std::string& path, Triangles& triangles)
{
  read_polygons(path, triangles);
  make_mesh(path, triangles);
  auto components = triangles.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t number = PMP::connected_components(triangles.mesh, components);
  if(number != 1)
    throw Failure{Status::several_components, "the mesh has " + std::to_string(number) + " components"};
}

void read_surface(const std::string& path, bool repair, Triangles& triangles, std::string& repairs)
{
  read_polygons(path, triangles);
  if(repair)
    repairs = repair_polygons(triangles);
  if(triangles.polygons.empty())
    throw Failure{Status::empty_mesh, "nothing is left after the repair"};
  make_mesh(path, triangles);
}

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
    {"newton", FFM::Any_preconditioner(FFM::Projected_newton())},
    {"absolute-newton", FFM::Any_preconditioner(filtered_newton(FFM::Eigenvalue_filter::absolute))},
    {"trust-region-newton", FFM::Any_preconditioner(filtered_newton(FFM::Eigenvalue_filter::trust_region))},
    {"vertex-space-newton", FFM::Any_preconditioner(FFM::Vertex_space_newton())},
    {"plain-newton", FFM::Any_preconditioner(FFM::Newton())},
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

// A halfedge on the longest border, null on a closed surface. Lengths may be of any magnitude: squares of tiny ones vanish.
Mesh::Halfedge_index longest_border(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  Mesh::Halfedge_index longest = Mesh::null_halfedge();
  double greatest = -1;
  for(const Mesh::Halfedge_index border : borders) {
    double length = 0;
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(border, mesh)) {
      const Kernel::Point_3& p = mesh.point(mesh.source(h));
      const Kernel::Point_3& q = mesh.point(mesh.target(h));
      length += std::hypot(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
    }
    if(length > greatest) {
      longest = border;
      greatest = length;
    }
  }
  return longest;
}

} // namespace

void read_patch(const std::string& path, Patch& patch)
{
  read_triangles(path, patch.triangles);
  patch.border = longest_border(patch.triangles.mesh);
  if(patch.border == Mesh::null_halfedge())
    throw Failure{Status::no_border, "the surface is closed; it must be cut open before it can be flattened"};
  patch.uv = patch.triangles.mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
}

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

Reporter::Reporter(const Method_arguments& arguments) : m_quiet(arguments.quiet || !isatty(STDERR_FILENO))
{
  if(arguments.trace.empty())
    return;
  m_trace.open(arguments.trace);
  m_trace << "iteration,seconds,energy,gradient_norm,step,flips,factorizations\n";
  m_trace.precision(17);
  if(!m_trace)
    throw Failure{Status::file_error, "cannot write " + arguments.trace};
}

bool Reporter::operator()(const FFM::Iteration_report& report)
{
  if(m_trace.is_open())
    m_trace << report.iteration << ',' << report.seconds << ',' << report.energy << ',' << report.gradient_norm << ',' << report.step << ','
            << report.flips << ',' << report.factorizations << '\n';
  if(!m_quiet)
    std::fprintf(stderr, "\riteration %d  energy %.8f  gradient %.2e  %.1f s   ", report.iteration, report.energy,
                 report.characteristic_gradient_norm, report.seconds);
  return true;
}

void Reporter::finish()
{
  if(!m_quiet)
    std::fputc('\n', stderr);
  if(m_trace.is_open() && !m_trace.flush())
    throw Failure{Status::file_error, "cannot write the trace"};
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

void set_options(const Method_arguments& arguments, const std::shared_ptr<Reporter>& reporter, FFM::Map_options& options)
{
  set_limits(arguments, options);
  options.memory_budget = arguments.memory_budget * 1024 * 1024 * 1024;
  options.observer = [reporter](const FFM::Iteration_report& report) { return (*reporter)(report); };
}

void run_guarded(const Method_arguments& arguments, const std::function<void()>& body,
                 const std::function<void(Status, const std::string&)>& fail)
{
  try {
#ifdef CGAL_LINKED_WITH_TBB
    std::unique_ptr<tbb::global_control> control;
    if(arguments.threads > 0)
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
#else
    static_cast<void>(arguments);
#endif
    body();
  } catch(const Failure& failure) {
    fail(failure.status, failure.message);
  } catch(const std::bad_alloc&) {
    fail(Status::out_of_memory, "memory was exhausted");
  } catch(const std::exception& exception) {
    fail(Status::file_error, exception.what());
  }
}

int report(const Method_arguments& arguments, Status status, const std::string& message, const nlohmann::json& json,
           const std::string& text)
{
  try {
    write_json(arguments.json, json);
  } catch(const Failure& failure) {
    std::cerr << "flip_free_maps: " << failure.message << '\n';
    return exit_code(failure.status);
  }
  if(!FFM::is_valid_map(status))
    std::cerr << "flip_free_maps: " << FFM::status_name(status) << ": " << message << '\n';
  else if(!arguments.quiet)
    std::cout << text;
  return exit_code(status);
}

int run_reported(const Method_arguments& arguments, const std::function<void(FFM::Summary&)>& body)
{
  FFM::Summary summary;
  run_guarded(
    arguments, [&] { body(summary); },
    [&](Status status, const std::string& message) {
      summary.status = status;
      summary.message = message;
    });
  std::ostringstream text;
  text << summary;
  return report(arguments, summary.status, summary.message, summary, text.str());
}

void add_picture_options(CLI::App& command, Picture_arguments& arguments)
{
  command.add_option("--svg", arguments.svg, "draw the result, coloured by distortion");
  command.add_option("--png", arguments.png, "draw the result, coloured by distortion");
  command.add_option("--picture-width", arguments.width, "width of the drawings in pixels")
    ->check(CLI::Range(320, 16000))
    ->capture_default_str();
}

void write_pictures(const Picture_arguments& arguments, const std::string& input, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion, const FFM::Summary& summary)
{
  char title[200];
  std::snprintf(title, sizeof title, "%s   %s %.6f", input.substr(input.rfind('/') + 1).c_str(),
                summary.energy_name == FFM::Symmetric_dirichlet::name() ? "energy" : summary.energy_name.c_str(), summary.energy);
  write_pictures(arguments, title, layout, distortion);
}

void write_pictures(const Picture_arguments& arguments, const std::string& title, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion)
{
  FFM::Layout_picture_options options;
  options.title = title;
  options.width = arguments.width;
  options.distortion_label = "symmetric Dirichlet";
  std::string message;
  if(!arguments.svg.empty())
    check(FFM::write_layout_SVG(arguments.svg, layout.texture, layout.texture_triangles, distortion, options, &message), message);
  if(!arguments.png.empty())
    check(FFM::write_layout_PNG(arguments.png, layout.texture, layout.texture_triangles, distortion, options, &message), message);
}

namespace {

FFM::Textured_mesh textured(const Triangles& triangles, const UV_map& uv, bool unit_square)
{
  FFM::Textured_mesh result;
  for(const auto& p : triangles.points)
    result.points.push_back({p.x(), p.y(), p.z()});
  std::vector<int> texture_of_point(triangles.points.size(), -1);
  std::array<double, 2> low{}, high{};
  for(const auto& polygon : triangles.polygons) {
    std::array<int, 3> triangle, texture;
    for(int k = 0; k < 3; ++k) {
      const std::size_t v = polygon[k];
      if(texture_of_point[v] < 0) {
        texture_of_point[v] = static_cast<int>(result.texture.size());
        const Kernel::Point_2 p = uv[Vertex(static_cast<Mesh::size_type>(v))];
        const bool first = result.texture.empty();
        for(int c = 0; c < 2; ++c) {
          low[c] = first ? p[c] : (std::min)(low[c], p[c]);
          high[c] = first ? p[c] : (std::max)(high[c], p[c]);
        }
        result.texture.push_back({p.x(), p.y()});
      }
      triangle[k] = static_cast<int>(v);
      texture[k] = texture_of_point[v];
    }
    result.triangles.push_back(triangle);
    result.texture_triangles.push_back(texture);
  }
  if(unit_square) {
    const double extent = (std::max)(high[0] - low[0], high[1] - low[1]);
    for(auto& p : result.texture)
      p = {(p[0] - low[0]) / extent, (p[1] - low[1]) / extent};
    // Scaling rounds, and what is written must be certified.
    const auto point = [&](int t) { return Kernel::Point_2(result.texture[t][0], result.texture[t][1]); };
    for(const auto& t : result.texture_triangles)
      if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::LEFT_TURN)
        throw Failure{Status::result_not_representable, "triangles flip when the texture coordinates are scaled into the unit square"};
  }
  return result;
}

} // namespace

std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Triangles& triangles)
{
  FFM::Textured_mesh given;
  std::string message;
  check(FFM::read_textured_OBJ(path, given, &message), message);
  bool is_same = given.triangles.size() == triangles.polygons.size();
  std::vector<Kernel::Point_2> uv(triangles.points.size(), Kernel::Point_2(0, 0));
  std::vector<int> texture(triangles.points.size(), -1);
  for(std::size_t i = 0; is_same && i < given.triangles.size(); ++i)
    for(int k = 0; k < 3; ++k) {
      const int v = given.triangles[i][k], t = given.texture_triangles[i][k];
      is_same = is_same && v == static_cast<int>(triangles.polygons[i][k]) && t >= 0 && (texture[v] < 0 || texture[v] == t);
      if(is_same) {
        texture[v] = t;
        uv[v] = Kernel::Point_2(given.texture[t][0], given.texture[t][1]);
      }
    }
  check(is_same, path + " does not give the faces of the mesh one pair of texture coordinates per vertex");
  return uv;
}

void add_layout_options(CLI::App& command, Layout_arguments& arguments, const std::string& input, const std::string& output)
{
  command.add_option("input", arguments.input, input)->required();
  command.add_option("-o,--output", arguments.output, output);
  command.add_flag("--unit-square", arguments.unit_square, "scale the texture coordinates into the unit square");
}

void write_layout(const Layout_arguments& arguments, Patch& patch, const FFM::Summary& summary)
{
  Mesh& mesh = patch.triangles.mesh;
  std::vector<double> distortion;
  auto distortion_map = mesh.add_property_map<Mesh::Face_index, double>("f:distortion").first;
  FFM::face_distortions(mesh, patch.uv, distortion_map);
  for(const auto face : mesh.faces())
    distortion.push_back(distortion_map[face]);
  const FFM::Textured_mesh layout = textured(patch.triangles, patch.uv, arguments.unit_square);
  write_pictures(arguments.pictures, arguments.input, layout, distortion, summary);
  std::string message;
  if(!arguments.output.empty())
    check(FFM::write_textured_OBJ(arguments.output, layout, &message), message);
}

} // namespace program
