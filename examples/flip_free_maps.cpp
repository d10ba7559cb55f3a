// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The package at work on files: see `flip_free_maps --help`.

#include <CGAL/Flip_free_maps/energies/Amips.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Conformal.h>
#include <CGAL/Flip_free_maps/energies/Exponential_amips.h>
#include <CGAL/Flip_free_maps/energies/Exponential_symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Hencky.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_arap.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/io.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using FFM::Status;

namespace {

// 0 for valid maps; 2 is the command line's; the other statuses follow in their order.
int exit_code(Status status)
{
  return FFM::is_valid_map(status) ? 0 : static_cast<int>(status) - static_cast<int>(Status::empty_mesh) + 3;
}

std::string exit_codes_text()
{
  std::string text = "Exit codes: 0 a valid map was written (converged, or ended by a limit); 2 wrong command line";
  for(int s = static_cast<int>(Status::empty_mesh); s <= static_cast<int>(Status::out_of_memory); ++s)
    text += "; " + std::to_string(exit_code(static_cast<Status>(s))) + " " + FFM::status_name(static_cast<Status>(s));
  return text + ".";
}

struct Failure
{
  Status status;
  std::string message;
};

struct Triangles
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh mesh; // vertex i is point i
};

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

// Reads and checks a file, so that every fault has a name of its own before the mesh is built.
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

struct Arguments
{
  std::string input, output, energy = "symmetric-dirichlet", preconditioner = "default", start = "auto", border = "circle", weights = "uniform",
                             criterion = "auto", linear_solver = "default", json, svg, png, trace;
  double tolerance = -1;
  int max_iterations = FFM::Map_options().max_iterations;
  double time_limit = 0;
  int threads = 0;
  int picture_width = FFM::Layout_picture_options().width;
  bool place_flaps = false;
  bool unit_square = false;
  bool quiet = false;
};

// What a run leaves behind besides the map.
class Reporter
{
public:
  explicit Reporter(const Arguments& arguments) : m_quiet(arguments.quiet || !isatty(STDERR_FILENO))
  {
    if(!arguments.trace.empty()) {
      m_trace.open(arguments.trace);
      m_trace << "iteration,seconds,energy,gradient_norm,step,flips\n";
      m_trace.precision(17);
      if(!m_trace)
        throw Failure{Status::file_error, "cannot write " + arguments.trace};
    }
  }

  bool operator()(const FFM::Iteration_report& report)
  {
    if(m_trace.is_open())
      m_trace << report.iteration << ',' << report.seconds << ',' << report.energy << ',' << report.gradient_norm << ',' << report.step
              << ',' << report.flips << '\n';
    if(!m_quiet)
      std::fprintf(stderr, "\riteration %d  energy %.8f  gradient %.2e  %.1f s   ", report.iteration, report.energy,
                   report.characteristic_gradient_norm, report.seconds);
    return true;
  }

  void finish()
  {
    if(!m_quiet)
      std::fputc('\n', stderr);
    if(m_trace.is_open() && !m_trace.flush())
      throw Failure{Status::file_error, "cannot write the trace"};
  }

private:
  bool m_quiet;
  std::ofstream m_trace;
};

// The energies of --energy besides the default, which is compiled in.
const std::map<std::string, FFM::Any_energy>& other_energies()
{
  static const std::map<std::string, FFM::Any_energy> energies{
    {"exponential-symmetric-dirichlet", FFM::Any_energy(FFM::Exponential_symmetric_dirichlet())},
    {"symmetric-gradient", FFM::Any_energy(FFM::Symmetric_gradient())},
    {"symmetric-arap", FFM::Any_energy(FFM::Symmetric_arap())},
    {"hencky", FFM::Any_energy(FFM::Hencky())},
    {"conformal", FFM::Any_energy(FFM::Conformal())},
    {"amips", FFM::Any_energy(FFM::Amips())},
    {"exponential-amips", FFM::Any_energy(FFM::Exponential_amips())},
    {"neo-hookean", FFM::Any_energy(FFM::Neo_hookean())}};
  return energies;
}

// What the other energies are not compiled for; empty if the combination exists.
std::string why_not_available(const Arguments& arguments)
{
  if(other_energies().count(arguments.energy) == 0)
    return "";
  if(arguments.preconditioner == "laplacian" || arguments.preconditioner == "cm")
    return "--preconditioner " + arguments.preconditioner + " is available with --energy symmetric-dirichlet only, not with " +
           arguments.energy + "; choose default, newton, slim or killing";
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  if(arguments.linear_solver == "eigen")
    return "--linear-solver eigen is available with --energy symmetric-dirichlet only, not with " + arguments.energy;
#endif
  return "";
}

template <typename Traits, typename UVMap>
FFM::Summary run_with_traits(const Arguments& arguments, const Mesh& mesh, Mesh::Halfedge_index border, UVMap uv,
                             Traits traits = Traits())
{
  traits.start.border = arguments.border == "square" ? FFM::Border_shape::square : FFM::Border_shape::circle;
  traits.start.weights = arguments.weights == "mean-value"  ? FFM::Tutte_weights::mean_value
                         : arguments.weights == "cotangent" ? FFM::Tutte_weights::cotangent
                                                            : FFM::Tutte_weights::uniform;
  traits.start.place_flaps = arguments.place_flaps;
  // The papers' methods begin with a Tutte embedding.
  if(arguments.start == "tutte" || (arguments.start == "auto" && arguments.preconditioner != "default"))
    traits.start.multilevel_size = -1;
  else if(arguments.start == "multilevel")
    traits.start.multilevel_size = 0;
  FFM::Map_options& options = traits.options;
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

  const auto reporter = std::make_shared<Reporter>(arguments);
  options.observer = [reporter](const FFM::Iteration_report& report) { return (*reporter)(report); };
  const FFM::Summary summary = FFM::parameterize(mesh, border, uv, traits);
  reporter->finish();
  return summary;
}

template <typename LinearSolver, typename UVMap>
FFM::Summary run_with_solver(const Arguments& arguments, const Mesh& mesh, Mesh::Halfedge_index border, UVMap uv)
{
  using D = CGAL::Default;
  const auto plain = [&](auto preconditioner) {
    return run_with_traits<FFM::Flip_free_map_traits<D, D, decltype(preconditioner), D, LinearSolver, FFM::No_acceleration,
                                                     FFM::Every_iteration>>(arguments, mesh, border, uv);
  };
  if(arguments.preconditioner == "laplacian")
    return plain(FFM::Laplacian());
  if(arguments.preconditioner == "killing")
    return plain(FFM::Killing());
  if(arguments.preconditioner == "slim")
    return plain(FFM::Slim());
  if(arguments.preconditioner == "cm")
    return plain(FFM::Composite_majorization<>());
  if(arguments.preconditioner == "newton")
    return plain(FFM::Projected_newton());
  return run_with_traits<FFM::Flip_free_map_traits<D, D, D, D, LinearSolver>>(arguments, mesh, border, uv);
}

template <typename UVMap>
FFM::Summary run_with_other_energy(const Arguments& arguments, const Mesh& mesh, Mesh::Halfedge_index border, UVMap uv)
{
  using D = CGAL::Default;
  const FFM::Any_energy& energy = other_energies().at(arguments.energy);
  const auto run = [&](auto traits) {
    traits.energy = energy;
    return run_with_traits(arguments, mesh, border, uv, traits);
  };
  const auto plain = [&](auto preconditioner) {
    return run(FFM::Flip_free_map_traits<D, FFM::Any_energy, decltype(preconditioner), D, D, FFM::No_acceleration,
                                         FFM::Every_iteration>());
  };
  FFM::Summary summary = arguments.preconditioner == "newton"    ? plain(FFM::Projected_newton())
                         : arguments.preconditioner == "slim"    ? plain(FFM::Slim())
                         : arguments.preconditioner == "killing" ? plain(FFM::Killing())
                                                                 : run(FFM::Flip_free_map_traits<D, FFM::Any_energy>());
  summary.energy_name = energy.energy_name();
  return summary;
}

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

void write_pictures(const Arguments& arguments, const FFM::Textured_mesh& layout, const std::vector<double>& distortion,
                    const FFM::Summary& summary)
{
  FFM::Layout_picture_options options;
  char title[200];
  std::snprintf(title, sizeof title, "%s   %s %.6f", arguments.input.substr(arguments.input.rfind('/') + 1).c_str(),
                other_energies().count(arguments.energy) == 0 ? "energy" : summary.energy_name.c_str(), summary.energy);
  options.title = title;
  options.width = arguments.picture_width;
  options.distortion_label = "symmetric Dirichlet energy";
  std::string message;
  if(!arguments.svg.empty())
    check(FFM::write_layout_SVG(arguments.svg, layout.texture, layout.texture_triangles, distortion, options, &message), message);
  if(!arguments.png.empty())
    check(FFM::write_layout_PNG(arguments.png, layout.texture, layout.texture_triangles, distortion, options, &message), message);
}

int run_parameterize(const Arguments& arguments)
{
  FFM::Summary summary;
  try {
    Triangles triangles;
    read_triangles(arguments.input, triangles);
    Mesh& mesh = triangles.mesh;
    std::vector<Mesh::Halfedge_index> borders;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
    if(borders.empty())
      throw Failure{Status::no_border, "the surface is closed; it must be cut open before it can be flattened"};
    const Mesh::Halfedge_index border = borders.front();
    auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;

#ifdef CGAL_LINKED_WITH_TBB
    std::unique_ptr<tbb::global_control> control;
    if(arguments.threads > 0)
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
#endif
    if(other_energies().count(arguments.energy) != 0)
      summary = run_with_other_energy(arguments, mesh, border, uv);
    else
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
    if(arguments.linear_solver != "eigen")
      summary = run_with_solver<FFM::Cholmod_solver>(arguments, mesh, border, uv);
    else
#endif
      summary = run_with_solver<FFM::Eigen_simplicial_solver>(arguments, mesh, border, uv);

    if(summary.is_valid()) {
      std::vector<double> distortion;
      auto distortion_map = mesh.add_property_map<Mesh::Face_index, double>("f:distortion").first;
      FFM::face_distortions(mesh, uv, distortion_map);
      for(const auto face : mesh.faces())
        distortion.push_back(distortion_map[face]);
      FFM::Textured_mesh layout = textured(triangles, uv, arguments.unit_square);
      write_pictures(arguments, layout, distortion, summary);
      std::string message;
      if(!arguments.output.empty())
        check(FFM::write_textured_OBJ(arguments.output, layout, &message), message);
    }
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

int run_measure(const std::string& input, const std::string& json_path)
{
  FFM::Distortion_report report;
  FFM::Textured_mesh mesh;
  if(!FFM::read_textured_OBJ(input, mesh, &report.message))
    report.status = Status::file_error;
  else
    report = FFM::measure_distortion(mesh);
  nlohmann::json json = {{"status", FFM::status_name(report.status)}, {"message", report.message}, {"faces", report.elements},
                         {"flips", report.flips}, {"energy", report.energy}, {"energy_of_similarity", report.energy_of_similarity},
                         {"max_energy", report.max_energy}, {"mean_angle_distortion", report.mean_angle_distortion},
                         {"mean_area_distortion", report.mean_area_distortion}, {"min_singular_value", report.min_singular_value},
                         {"max_singular_value", report.max_singular_value}, {"rest_area", report.rest_area},
                         {"image_area", report.image_area}};
  try {
    write_json(json_path, json);
  } catch(const Failure& failure) {
    std::cerr << "flip_free_maps: " << failure.message << '\n';
    return exit_code(failure.status);
  }
  if(report.status != Status::success) {
    std::cerr << "flip_free_maps: " << FFM::status_name(report.status) << ": " << report.message << '\n';
    return exit_code(report.status);
  }
  std::cout << report.elements << " faces, " << report.flips << " flipped\n"
            << "symmetric Dirichlet energy " << report.energy << " (" << report.energy_of_similarity << " after the best scaling), largest "
            << report.max_energy << '\n'
            << "mean angle distortion " << report.mean_angle_distortion << ", mean area distortion " << report.mean_area_distortion << '\n'
            << "singular values [" << report.min_singular_value << ", " << report.max_singular_value << "]\n";
  return report.flips == 0 ? 0 : exit_code(Status::start_not_flip_free);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Low-distortion maps of meshes in which no element is flipped.");
  app.require_subcommand(1);
  app.footer(exit_codes_text());
  app.set_version_flag("--version", "flip_free_maps 0.1.0");

  Arguments arguments;
  CLI::App* flatten = app.add_subcommand("parameterize", "Flatten a surface patch, a topological disk, into the plane");
  flatten->add_option("input", arguments.input, "mesh: OFF, OBJ, PLY or STL")->required();
  flatten->add_option("-o,--output", arguments.output, "OBJ with texture coordinates, in the units of the surface");
  flatten->add_flag("--unit-square", arguments.unit_square, "scale the texture coordinates into the unit square");
  std::vector<std::string> energies{"symmetric-dirichlet"};
  for(const auto& energy : other_energies())
    energies.push_back(energy.first);
  flatten
    ->add_option("--energy", arguments.energy,
                 "what is minimised; those other than symmetric-dirichlet with the preconditioners default, newton, slim and killing")
    ->check(CLI::IsMember(energies))
    ->capture_default_str();
  flatten
    ->add_option("--preconditioner", arguments.preconditioner,
                 "method; 'default' is SLIM's proxy on badly distorted elements, Newton's elsewhere, with L-BFGS")
    ->check(CLI::IsMember({"default", "laplacian", "killing", "slim", "cm", "newton"}))
    ->capture_default_str();
  flatten
    ->add_option("--start", arguments.start,
                 "Tutte embedding, or from coarse to fine; 'auto' is from coarse to fine for the default method on large meshes, and either "
                 "where the other fails")
    ->check(CLI::IsMember({"auto", "tutte", "multilevel"}))
    ->capture_default_str();
  flatten->add_option("--border", arguments.border, "border of the start")->check(CLI::IsMember({"circle", "square"}))->capture_default_str();
  flatten->add_option("--weights", arguments.weights, "weights of the start")
    ->check(CLI::IsMember({"uniform", "mean-value", "cotangent"}))
    ->capture_default_str();
  flatten->add_flag("--flaps", arguments.place_flaps, "begin with border vertices of a single triangle at their optimum");
  flatten
    ->add_option("--criterion", arguments.criterion,
                 "stopping rule that --tolerance is for: characteristic norm of the gradient (default tolerance 1e-5), norm of the "
                 "gradient (1e-3), relative change of the energy (1e-6); 'auto' is the first, for symmetric-arap the last")
    ->check(CLI::IsMember({"auto", "characteristic", "gradient", "energy"}))
    ->capture_default_str();
  flatten->add_option("--tolerance", arguments.tolerance, "see --criterion")->check(CLI::NonNegativeNumber);
  flatten->add_option("--max-iterations", arguments.max_iterations)->check(CLI::NonNegativeNumber)->capture_default_str();
  flatten->add_option("--time-limit", arguments.time_limit, "seconds; the map found by then is valid")->check(CLI::PositiveNumber);
  std::vector<std::string> solvers{"default", "eigen"};
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  solvers.push_back("cholmod");
#endif
  flatten->add_option("--linear-solver", arguments.linear_solver)->check(CLI::IsMember(solvers))->capture_default_str();
  flatten->add_option("--threads", arguments.threads, "at most this many; results do not depend on it")->check(CLI::PositiveNumber);
  flatten->add_option("--json", arguments.json, "write the summary");
  flatten->add_option("--svg", arguments.svg, "draw the layout, coloured by distortion");
  flatten->add_option("--png", arguments.png, "draw the layout, coloured by distortion");
  flatten->add_option("--picture-width", arguments.picture_width, "width of the drawings in pixels")
    ->check(CLI::Range(320, 16000))
    ->capture_default_str();
  flatten->add_option("--trace", arguments.trace, "write a CSV row per iteration");
  flatten->add_flag("--quiet", arguments.quiet, "print nothing but errors");

  std::string measured, measured_json;
  CLI::App* measure = app.add_subcommand("measure", "Measure the texture coordinates of an OBJ; exit code 0 only without flips");
  measure->add_option("input", measured, "OBJ with texture coordinates")->required();
  measure->add_option("--json", measured_json, "write the figures");

  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if(!*flatten)
    return run_measure(measured, measured_json);
  const std::string reason = why_not_available(arguments);
  if(!reason.empty()) {
    std::cerr << "flip_free_maps: " << reason << '\n';
    return 2;
  }
  return run_parameterize(arguments);
}
