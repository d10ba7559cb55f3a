// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Makes disks of closed meshes by the constructions of Liu et al. 2018, Progressive Parameterizations, section 4.2: the sets D1
// (cut well), D2 (cut through far points) and D3 (a part is missing; for d3p the vertices are moved at random, too): see
// `--help`. On the standard output comes a table of the files. Points are joined by short paths that may branch anywhere, where
// the paper has a minimal spanning tree. Where the border of the rest of D3 touches itself, the faces around are taken away, too,
// where the paper drops the mesh.

#include "../support/Table.h"

#include <CGAL/Flip_free_maps/cut_to_disk.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Branches = FFM::Cut_options::Branches;

namespace {

struct Settings
{
  std::vector<std::string> files;
  std::string folder = ".", cut = "peaks";
  std::set<std::string> sets = {"d1", "d2", "d3", "d3p"};
  std::vector<int> points = {5, 9, 13};
  std::vector<double> ratios = {0.3, 0.5, 0.7};
  int subdivisions = 0;
  unsigned int seed = 1;
};

// Faces of a patch that is missing are marked; grows it where a border of the rest touches itself and where the rest falls apart.
// `false` if the rest is no disk.
bool leave_disk(const Mesh& mesh, std::vector<char>& is_missing)
{
  const auto is_left = [&](Mesh::Halfedge_index h) { return !mesh.is_border(h) && !is_missing[mesh.face(h)]; };
  for(bool is_changed = true; is_changed;) {
    is_changed = false;
    for(const Vertex v : mesh.vertices()) {
      int ends = 0;
      for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        ends += is_left(h) && !is_left(mesh.opposite(h));
      if(ends < 2)
        continue;
      for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if(!mesh.is_border(h))
          is_missing[mesh.face(h)] = 1;
      is_changed = true;
    }
    std::vector<char> is_seen = is_missing;
    std::vector<Face> largest;
    for(const Face start : mesh.faces()) {
      if(is_seen[start])
        continue;
      is_seen[start] = 1;
      std::vector<Face> part{start};
      for(std::size_t q = 0; q < part.size(); ++q)
        for(const auto h : mesh.halfedges_around_face(mesh.halfedge(part[q])))
          if(is_left(mesh.opposite(h)) && !is_seen[mesh.face(mesh.opposite(h))]) {
            is_seen[mesh.face(mesh.opposite(h))] = 1;
            part.push_back(mesh.face(mesh.opposite(h)));
          }
      if(part.size() > largest.size())
        largest.swap(part);
    }
    std::vector<char> others(is_missing.size(), 1);
    for(const Face f : largest)
      others[f] = 0;
    is_changed = is_changed || others != is_missing;
    is_missing.swap(others);
  }
  int borders = 0, faces_left = 0, edges = 0, vertices = 0;
  std::set<Mesh::Halfedge_index> seen;
  for(const Vertex v : mesh.vertices()) {
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    vertices += std::any_of(around.begin(), around.end(), is_left);
  }
  for(const Face f : mesh.faces())
    faces_left += !is_missing[f];
  for(const Edge e : mesh.edges())
    edges += is_left(mesh.halfedge(e)) || is_left(mesh.opposite(mesh.halfedge(e)));
  for(const auto start : mesh.halfedges()) {
    if(!is_left(start) || is_left(mesh.opposite(start)) || !seen.insert(start).second)
      continue;
    ++borders;
    for(auto h = start;;) {
      h = mesh.next(h);
      while(is_left(mesh.opposite(h)))
        h = mesh.next(mesh.opposite(h));
      if(!seen.insert(h).second)
        break;
    }
  }
  return borders == 1 && vertices - edges + faces_left == 1;
}

// The patch that grows breadth first from a random face, until it has more than a part of all faces.
std::vector<char> random_patch(const Mesh& mesh, double ratio, CGAL::Random& random)
{
  const std::size_t n = mesh.number_of_faces();
  std::vector<char> is_missing(n, 0);
  std::vector<Face> queue{Face(static_cast<Mesh::size_type>(random.get_int(0, static_cast<int>(n))))};
  is_missing[queue.front()] = 1;
  for(std::size_t q = 0; q < queue.size() && !(queue.size() > ratio * n); ++q)
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(queue[q]))) {
      const Face f = mesh.face(mesh.opposite(h));
      if(f != Mesh::null_face() && !is_missing[f] && !(queue.size() > ratio * n)) {
        is_missing[f] = 1;
        queue.push_back(f);
      }
    }
  return is_missing;
}

// Moves each vertex to a random point of the ball around it whose radius is the length of one of its edges.
void move_vertices(Mesh& mesh, CGAL::Random& random)
{
  std::vector<Mesh::Point> moved;
  for(const Vertex v : mesh.vertices()) {
    std::vector<Vertex> neighbors;
    for(const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
      neighbors.push_back(w);
    const Vertex w = neighbors[random.get_int(0, static_cast<int>(neighbors.size()))];
    const double radius = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
    double x, y, z;
    do {
      x = random.get_double(-1, 1);
      y = random.get_double(-1, 1);
      z = random.get_double(-1, 1);
    } while(x * x + y * y + z * z > 1);
    const Mesh::Point& p = mesh.point(v);
    moved.emplace_back(p.x() + radius * x, p.y() + radius * y, p.z() + radius * z);
  }
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = moved[v];
}

class Maker
{
public:
  explicit Maker(const Settings& settings)
    : m_settings(settings),
      m_random(settings.seed),
      m_table({"file", "set", "source", "status", "vertices", "faces", "seam_edges", "seam_length", "seconds"})
  {}

  void make_sets(Mesh mesh, const std::string& name)
  {
    const auto has = [this](const char* set) { return m_settings.sets.count(set) != 0; };
    if(has("d1")) {
      Mesh subdivided = mesh;
      for(int level = 0; level <= m_settings.subdivisions; ++level) {
        if(level > 0)
          CGAL::Subdivision_method_3::Loop_subdivision(subdivided, CGAL::parameters::number_of_iterations(1));
        FFM::Cut_options options;
        options.branches = m_settings.cut == "peaks" ? Branches::curvature_peaks : Branches::extremities;
        add_cut_mesh(subdivided, "d1", name, level == 0 ? "" : "_s" + std::to_string(level), options);
      }
    }
    if(has("d2"))
      for(int n : m_settings.points) {
        FFM::Cut_options options;
        options.branches = Branches::farthest_points;
        options.number_of_points = n;
        options.crease_preference = 0;
        add_cut_mesh(mesh, "d2", name, "_n" + std::to_string(n), options);
      }
    for(const char* set : {"d3", "d3p"})
      if(has(set))
        for(double ratio : m_settings.ratios)
          add_part(mesh, set, name, ratio);
  }

  const Table& table() const { return m_table; }
  int failures() const { return m_failures; }

private:
  void add_cut_mesh(Mesh& mesh, const std::string& set, const std::string& name, const std::string& ending, const FFM::Cut_options& options)
  {
    auto cut = mesh.add_property_map<Edge, bool>("e:cut", false).first;
    auto on_cut = mesh.add_property_map<Vertex, bool>("v:on_cut", false).first;
    const FFM::Cut_summary summary = FFM::cut_to_disk(mesh, cut, options);
    Mesh disk;
    if(summary.is_valid()) {
      for(const Edge e : mesh.edges())
        if(cut[e])
          on_cut[mesh.vertex(e, 0)] = on_cut[mesh.vertex(e, 1)] = true;
      const CGAL::Seam_mesh<Mesh, decltype(cut), decltype(on_cut)> opened(mesh, cut, on_cut);
      CGAL::copy_face_graph(opened, disk);
    }
    mesh.remove_property_map(cut);
    mesh.remove_property_map(on_cut);
    write(disk, set, name, ending, summary.is_valid() ? "ok" : summary.message,
          {std::to_string(summary.seam_edges), format(summary.seam_length), format(summary.seconds)});
  }

  void add_part(const Mesh& mesh, const std::string& set, const std::string& name, double ratio)
  {
    const int trials = 50;
    Mesh part;
    for(int trial = 0; trial < trials && part.is_empty(); ++trial) {
      std::vector<char> is_missing = random_patch(mesh, ratio, m_random);
      // Where nearly nothing is left, the patch has closed in on itself.
      if(!leave_disk(mesh, is_missing) || std::count(is_missing.begin(), is_missing.end(), 0) < 0.5 * (1 - ratio) * is_missing.size())
        continue;
      std::vector<Face> left;
      for(const Face f : mesh.faces())
        if(!is_missing[f])
          left.push_back(f);
      CGAL::copy_face_graph(CGAL::Face_filtered_graph<Mesh>(mesh, left), part);
    }
    if(set == "d3p")
      move_vertices(part, m_random);
    write(part, set, name, "_b" + std::to_string(static_cast<int>(std::lround(100 * ratio))),
          part.is_empty() ? "no disk in " + std::to_string(trials) + " trials" : "ok", {"", "", ""});
  }

  void write(const Mesh& disk, const std::string& set, const std::string& name, const std::string& ending, std::string status,
             const std::vector<std::string>& seams)
  {
    const std::string file = set + "_" + name + ending + ".off";
    if(status == "ok" && !CGAL::IO::write_polygon_mesh((std::filesystem::path(m_settings.folder) / file).string(), disk,
                                                       CGAL::parameters::stream_precision(17)))
      status = "cannot be written";
    m_failures += status != "ok";
    m_table.add_row({file, set, name, status, std::to_string(disk.number_of_vertices()), std::to_string(disk.number_of_faces()), seams[0],
                     seams[1], seams[2]});
  }

  const Settings& m_settings;
  CGAL::Random m_random;
  Table m_table;
  int m_failures = 0;
};

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  CLI::App app("Makes disks of closed meshes: the benchmark sets of Liu et al. 2018, section 4.2.");
  app.add_option("MESH", settings.files, "files with one closed triangle mesh each; d3 and d3p need genus 0")->required();
  app.add_option("--output", settings.folder, "folder for the files, which is made if need be")->capture_default_str();
  app.add_option("--sets", settings.sets, "which of d1, d2, d3, d3p (d3 with vertices moved at random); default: all")
    ->check(CLI::IsMember({"d1", "d2", "d3", "d3p"}))
    ->allow_extra_args(false)
    ->delimiter(',');
  app.add_option("--cut", settings.cut, "d1: through peaks of the curvature, or through extremities as cut_to_disk() does by default")
    ->check(CLI::IsMember({"peaks", "extremities"}))
    ->capture_default_str();
  app.add_option("--subdivide", settings.subdivisions, "d1: also after so many steps of Loop's subdivision, all up to it")
    ->check(CLI::Range(0, 6))
    ->capture_default_str();
  app.add_option("--points", settings.points, "d2: numbers of points")
    ->check(CLI::Range(2, 1000))
    ->allow_extra_args(false)
    ->delimiter(',')
    ->capture_default_str();
  app.add_option("--ratios", settings.ratios, "d3: parts of the faces that are missing, at least")
    ->check(CLI::Range(0., 0.95))
    ->allow_extra_args(false)
    ->delimiter(',')
    ->capture_default_str();
  app.add_option("--seed", settings.seed, "of the random choices of d3 and d3p")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::error_code error;
  std::filesystem::create_directories(settings.folder, error);
  Maker maker(settings);
  int refused = 0;
  for(const std::string& file : settings.files) {
    Mesh mesh;
    const bool is_read = CGAL::IO::read_polygon_mesh(file, mesh);
    if(!is_read || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh) || !CGAL::is_closed(mesh)) {
      std::cerr << file << (is_read ? " is not a closed triangle mesh.\n" : " cannot be read.\n");
      ++refused;
      continue;
    }
    std::string name = std::filesystem::path(file).stem().string();
    if(name.rfind("closed_g", 0) == 0)
      name = name.substr(name.find('_', 8) + 1);
    maker.make_sets(mesh, name);
  }
  maker.table().write(std::cout);
  std::cerr << maker.table().number_of_rows() - maker.failures() << " files written, " << maker.failures() << " failures, " << refused
            << " meshes refused.\n";
  return maker.failures() + refused == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
