// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "common.h"

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
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <unistd.h>
#include <utility>

namespace program {

namespace PMP = CGAL::Polygon_mesh_processing;

int exit_code(Status status)
{
  return FFM::is_valid_map(status) ? 0 : static_cast<int>(status) - static_cast<int>(Status::empty_mesh) + 3;
}

std::string exit_codes_text()
{
  std::string text = "Exit codes: 0 a valid map was written (converged, or ended by a limit); 2 wrong command line";
  for(int s = static_cast<int>(Status::empty_mesh); s <= static_cast<int>(Status::flips_remain); ++s)
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
  out << json.dump(2) << '\n';
  check(bool(out.flush()), "cannot write " + path);
}

namespace {

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

void read_triangles(const std::string& path, Triangles& triangles)
{
  auto& points = triangles.points;
  auto& polygons = triangles.polygons;
  if(!std::ifstream(path))
    throw Failure{Status::file_error, "cannot open " + path};
  if(!CGAL::IO::read_polygon_soup(path, points, polygons))
    throw Failure{Status::file_error, path + " is not an OFF, OBJ, PLY or STL file, or is truncated or malformed: a coordinate may not be "
                                             "a finite number, or a face name a vertex that does not exist"};
  if(polygons.empty())
    throw Failure{Status::empty_mesh, "the file holds no faces"};
  for(std::size_t i = 0; i < polygons.size(); ++i) {
    const auto& polygon = polygons[i];
    const std::string face = "face number " + std::to_string(i);
    for(std::size_t v : polygon)
      if(v >= points.size())
        throw Failure{Status::file_error, face + " names a vertex that does not exist"};
    if(polygon.size() != 3)
      throw Failure{Status::not_triangular, face + " has " + std::to_string(polygon.size()) + " corners; triangulate the mesh first"};
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Failure{Status::non_manifold, face + " names a vertex twice"};
  }
  for(const auto& p : points)
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Failure{Status::non_finite_input, "a coordinate of the mesh is NaN or infinite"};
  // STL has no shared vertices.
  if(path.size() > 4 && (path.substr(path.size() - 4) == ".stl" || path.substr(path.size() - 4) == ".STL"))
    PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Failure{Status::non_manifold, why_not_manifold(polygons)};
  PMP::polygon_soup_to_polygon_mesh(points, polygons, triangles.mesh);

  auto components = triangles.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t number = PMP::connected_components(triangles.mesh, components);
  if(number != 1)
    throw Failure{Status::several_components, "the mesh has " + std::to_string(number) + " components"};
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

} // namespace

void add_method_options(CLI::App& command, Method_arguments& arguments)
{
  command
    .add_option("--method", arguments.method,
                "the methods of the literature by their names; a p- in front: with progressive references. The options below change parts "
                "of the method")
    ->check(CLI::IsMember({"default", "pp", "cm", "slim", "akvf", "p-cm", "p-slim", "p-akvf", "aqp", "sobolev", "newton",
                           "projected-newton"}))
    ->capture_default_str();
  command.add_option("--energy", arguments.energy, "what is minimised")
    ->check(CLI::IsMember(names(energies(0))))
    ->capture_default_str();
  command
    .add_option("--energy-parameter", arguments.energy_parameter,
                "the factor of exponential energies, mu of neo-hookean (kappa is 1); by default 1")
    ->check(CLI::PositiveNumber);
  command
    .add_option("--preconditioner", arguments.preconditioner,
                "how directions are found; other than default: with a factorization in each iteration, from a Tutte embedding")
    ->check(CLI::IsMember(names(preconditioners())))
    ->capture_default_str();
  command.add_option("--reference", arguments.reference, "what distortion is measured against on the way")
    ->check(CLI::IsMember({"default", "fixed", "progressive"}))
    ->capture_default_str();
  command.add_option("--acceleration", arguments.acceleration, "what is made of successive directions")
    ->check(CLI::IsMember({"default", "none", "nesterov", "lbfgs"}))
    ->capture_default_str();
  command
    .add_option("--criterion", arguments.criterion,
                "stopping rule that --tolerance is for: characteristic norm of the gradient (default tolerance 1e-5), norm of the "
                "gradient (1e-3), relative change of the energy (1e-6); 'auto' is the first, for symmetric-arap the last")
    ->check(CLI::IsMember({"auto", "characteristic", "gradient", "energy"}))
    ->capture_default_str();
  command.add_option("--tolerance", arguments.tolerance, "see --criterion")->check(CLI::NonNegativeNumber);
  command.add_option("--max-iterations", arguments.max_iterations)->check(CLI::NonNegativeNumber)->capture_default_str();
  command.add_option("--time-limit", arguments.time_limit, "seconds; the map found by then is valid")->check(CLI::PositiveNumber);
  std::vector<std::string> solvers{"default", "eigen"};
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  solvers.push_back("cholmod");
#endif
  command.add_option("--linear-solver", arguments.linear_solver)->check(CLI::IsMember(solvers))->capture_default_str();
  command.add_option("--threads", arguments.threads, "at most this many; results do not depend on it")->check(CLI::PositiveNumber);
  command.add_option("--json", arguments.json, "write the summary");
  command.add_option("--trace", arguments.trace, "write a CSV row per iteration");
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

std::string why_not_available(const Method_arguments& arguments, int dimension)
{
  FFM::Any_map_traits traits = make_traits(arguments);
  const std::string name = traits.preconditioner.preconditioner_name();
  if(traits.preconditioner.is_planar() && dimension != 2)
    return name + " is a method of the plane";
  if(traits.preconditioner.is_planar() && !traits.energy.is_convex_concave())
    return name + " needs an energy with a convex-concave decomposition, which " + arguments.energy + " has not; choose newton, slim or killing";
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
  }
  if(arguments.linear_solver == "eigen")
    traits.use_linear_solver<FFM::Eigen_simplicial_solver>();
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

void set_options(const Method_arguments& arguments, const std::shared_ptr<Reporter>& reporter, FFM::Map_options& options)
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
  options.observer = [reporter](const FFM::Iteration_report& report) { return (*reporter)(report); };
}

int run_reported(const Method_arguments& arguments, const std::function<void(FFM::Summary&)>& body)
{
  FFM::Summary summary;
  try {
#ifdef CGAL_LINKED_WITH_TBB
    std::unique_ptr<tbb::global_control> control;
    if(arguments.threads > 0)
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
#endif
    body(summary);
  } catch(const Failure& failure) {
    summary.status = failure.status;
    summary.message = failure.message;
  } catch(const std::bad_alloc&) {
    summary.status = Status::out_of_memory;
    summary.message = "memory was exhausted";
  } catch(const std::exception& exception) {
    summary.status = Status::file_error;
    summary.message = exception.what();
  }

  try {
    write_json(arguments.json, summary);
  } catch(const Failure& failure) {
    std::cerr << "flip_free_maps: " << failure.message << '\n';
    return exit_code(failure.status);
  }
  if(!summary.is_valid())
    std::cerr << "flip_free_maps: " << FFM::status_name(summary.status) << ": " << summary.message << '\n';
  else if(!arguments.quiet)
    std::cout << summary;
  return exit_code(summary.status);
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
  FFM::Layout_picture_options options;
  char title[200];
  std::snprintf(title, sizeof title, "%s   %s %.6f", input.substr(input.rfind('/') + 1).c_str(),
                summary.energy_name == FFM::Symmetric_dirichlet::name() ? "energy" : summary.energy_name.c_str(), summary.energy);
  options.title = title;
  options.width = arguments.width;
  options.distortion_label = "symmetric Dirichlet energy";
  std::string message;
  if(!arguments.svg.empty())
    check(FFM::write_layout_SVG(arguments.svg, layout.texture, layout.texture_triangles, distortion, options, &message), message);
  if(!arguments.png.empty())
    check(FFM::write_layout_PNG(arguments.png, layout.texture, layout.texture_triangles, distortion, options, &message), message);
}

namespace {

FFM::Textured_mesh textured(const Triangles& triangles, const Mesh::Property_map<Vertex, Kernel::Point_2>& uv, bool unit_square)
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

void write_layout(Triangles& triangles, const UV_map& uv, bool unit_square, const std::string& output, const Picture_arguments& pictures,
                  const std::string& input, const FFM::Summary& summary)
{
  Mesh& mesh = triangles.mesh;
  std::vector<double> distortion;
  auto distortion_map = mesh.add_property_map<Mesh::Face_index, double>("f:distortion").first;
  FFM::face_distortions(mesh, uv, distortion_map);
  for(const auto face : mesh.faces())
    distortion.push_back(distortion_map[face]);
  const FFM::Textured_mesh layout = textured(triangles, uv, unit_square);
  write_pictures(pictures, input, layout, distortion, summary);
  std::string message;
  if(!output.empty())
    check(FFM::write_textured_OBJ(output, layout, &message), message);
}

} // namespace program
