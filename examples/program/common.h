// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What the sub-commands of the program flip_free_maps share.

#ifndef FLIP_FREE_MAPS_PROGRAM_COMMON_H
#define FLIP_FREE_MAPS_PROGRAM_COMMON_H

#include <CGAL/Flip_free_maps/IO/Textured_mesh.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace program {

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

struct Failure
{
  Status status;
  std::string message;
};

// 0 for valid maps; 2 is the command line's; the other statuses follow in their order.
int exit_code(Status status);
std::string exit_codes_text();

void check(bool done, const std::string& message);
void write_json(const std::string& path, const nlohmann::json& json);

struct Triangles
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh mesh; // vertex i is point i
};

// Reads polygons of whatever kind from an OFF, OBJ, PLY or STL file. Returns whether it could be understood.
bool read_soup(const std::string& path, std::vector<Kernel::Point_3>& points, std::vector<std::vector<std::size_t>>& polygons);

// Reads and checks a file, so that every fault has a name of its own before the mesh is built.
void read_triangles(const std::string& path, Triangles& triangles);

// The same for any number of components. With `repair`, first removes what makes a mesh unfit: duplicated points and faces, faces
// without area, sheets that meet at a vertex or an edge, different orientations, polygons of more than three corners;
// `repairs` says what it did.
void read_surface(const std::string& path, bool repair, Triangles& triangles, std::string& repairs);

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// A connected surface with a border, and a map of it.
struct Patch
{
  Triangles triangles;
  Mesh::Halfedge_index border; // on the longest border
  UV_map uv;
};

void read_patch(const std::string& path, Patch& patch);

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

// What a run leaves behind besides the map.
class Reporter
{
public:
  explicit Reporter(const Method_arguments& arguments);
  bool operator()(const FFM::Iteration_report& report);
  void finish();

private:
  bool m_quiet;
  std::ofstream m_trace;
};

// Sets limits and tolerances.
void set_limits(const Method_arguments& arguments, FFM::Map_options& options);

// The same and an observer that calls `*reporter`.
void set_options(const Method_arguments& arguments, const std::shared_ptr<Reporter>& reporter, FFM::Map_options& options);

// Runs `body` on the asked number of threads and hands its failures to `fail`.
void run_guarded(const Method_arguments& arguments, const std::function<void()>& body,
                 const std::function<void(Status, const std::string&)>& fail);

// Writes a report, prints it, and returns the exit code.
int report(const Method_arguments& arguments, Status status, const std::string& message, const nlohmann::json& json,
           const std::string& text);

// Runs `body` on the asked number of threads, turns failures into a summary, writes it, prints it, and returns the exit code.
int run_reported(const Method_arguments& arguments, const std::function<void(FFM::Summary&)>& body);

// The options of sub-commands that draw a layout.
struct Picture_arguments
{
  std::string svg, png;
  int width = 1200;
};

void add_picture_options(CLI::App& command, Picture_arguments& arguments);

void write_pictures(const Picture_arguments& arguments, const std::string& input, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion, const FFM::Summary& summary);

// The same with a title.
void write_pictures(const Picture_arguments& arguments, const std::string& title, const FFM::Textured_mesh& layout,
                    const std::vector<double>& distortion);

// The texture coordinates of an OBJ with the same faces, one pair for each vertex.
std::vector<Kernel::Point_2> vertex_texture(const std::string& path, const Triangles& triangles);

// The files of sub-commands that map a patch to the plane.
struct Layout_arguments
{
  std::string input, output;
  bool unit_square = false;
  Picture_arguments pictures;
};

// Those but the pictures' options, which come last.
void add_layout_options(CLI::App& command, Layout_arguments& arguments, const std::string& input, const std::string& output);

// Writes and draws a map, whatever of it is asked for.
void write_layout(const Layout_arguments& arguments, Patch& patch, const FFM::Summary& summary);

// The sub-commands: each adds itself to the application, and runs if it was chosen.
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
std::unique_ptr<Command> measure_command(CLI::App& app);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_COMMON_H
