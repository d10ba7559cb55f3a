// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Seams of which the two sides fit together: the term against finite differences, and maps of a cube that was inflated.

#include "support/unit_test.h"

#include "support/constraint_checks.h"
#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/io.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/parameterize_with_seams.h>

#include <CGAL/boost/graph/Seam_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seam_constraints)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_map = Mesh::Property_map<Vertex, bool>;
using Cut_mesh = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;
using Vector_2 = Eigen::Vector2d;

namespace {

const Plain_point_2 sentinel(12345, -54321);

// A cube of n x n squares a face, on the way to a sphere,
// cut along a path of three edges of its bottom and its four vertical edges.
struct Inflated_cube
{
  Mesh mesh;
  Edge_map edges;
  Vertex_map vertices;
  Mesh::Property_map<Halfedge, Plain_point_2> uv;
  std::vector<Vertex> corners;

  Inflated_cube(int n, double inflation)
  {
    std::map<std::array<int, 3>, int> numbers;
    std::vector<std::array<int, 3>> lattice;
    Soup soup;
    const auto number = [&](std::array<int, 3> p) {
      const auto entry = numbers.emplace(p, static_cast<int>(soup.points.size()));
      if(entry.second) {
        lattice.push_back(p);
        const Eigen::Vector3d q = 2. / n * Eigen::Vector3d(p[0], p[1], p[2]) - Eigen::Vector3d::Ones();
        const Eigen::Vector3d r = (1 - inflation) * q + inflation * std::sqrt(2.) * q.normalized();
        soup.points.push_back({r.x(), r.y(), r.z()});
      }
      return entry.first->second;
    };
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j) {
            const auto at = [&](int a, int b) {
              std::array<int, 3> p;
              p[axis] = side * n;
              p[(axis + 1) % 3] = a;
              p[(axis + 2) % 3] = b;
              return number(p);
            };
            const int q[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            if(side == 1) {
              soup.triangles.push_back({q[0], q[1], q[2]});
              soup.triangles.push_back({q[0], q[2], q[3]});
            } else {
              soup.triangles.push_back({q[0], q[2], q[1]});
              soup.triangles.push_back({q[0], q[3], q[2]});
            }
          }
    add_soup(soup, mesh);
    edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    vertices = mesh.add_property_map<Vertex, bool>("v:seam", false).first;
    uv = mesh.add_property_map<Halfedge, Plain_point_2>("h:uv", sentinel).first;
    const auto end = [n](int c) { return c == 0 || c == n; };
    for(const auto e : mesh.edges()) {
      const std::array<int, 3> p = lattice[mesh.vertex(e, 0)], q = lattice[mesh.vertex(e, 1)];
      const bool vertical = p[0] == q[0] && p[1] == q[1] && end(p[0]) && end(p[1]);
      const bool bottom = p[2] == 0 && q[2] == 0 && ((p[0] == q[0] && end(p[0])) || (p[1] == q[1] && p[1] == 0));
      if(vertical || bottom)
        edges[e] = vertices[mesh.vertex(e, 0)] = vertices[mesh.vertex(e, 1)] = true;
    }
    for(std::size_t v = 0; v < lattice.size(); ++v)
      if(end(lattice[v][0]) && end(lattice[v][1]) && end(lattice[v][2]))
        corners.push_back(Vertex(static_cast<Mesh::size_type>(v)));
  }

  boost::graph_traits<Cut_mesh>::halfedge_descriptor border(const Cut_mesh& cut) const
  {
    for(const auto h : halfedges(cut))
      if(is_border(h, cut))
        return h;
    return boost::graph_traits<Cut_mesh>::null_halfedge();
  }

  Vector_2 image(const Cut_mesh& cut, Halfedge h) const
  {
    using Cut_halfedge = boost::graph_traits<Cut_mesh>::halfedge_descriptor;
    const Plain_point_2& p = uv[Halfedge(target(Cut_halfedge(h), cut))];
    return {p.x(), p.y()};
  }

  Vector_2 edge_vector(const Cut_mesh& cut, Halfedge h) const { return image(cut, h) - image(cut, mesh.prev(h)); }

  // The angles of the map's triangles around a vertex of the uncut mesh.
  double cone_angle(const Cut_mesh& cut, Vertex v) const
  {
    double sum = 0;
    for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
      const Vector_2 a = edge_vector(cut, mesh.next(h)), b = -edge_vector(cut, h);
      sum += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    }
    return sum;
  }
};

// How far an edge is from a quarter turn of another one.
double quarter_turn_distance(const Vector_2& u, const Vector_2& v)
{
  double smallest = std::numeric_limits<double>::infinity();
  Vector_2 turned = u;
  for(int i = 0; i < 4; ++i) {
    turned = Vector_2(-turned[1], turned[0]);
    smallest = (std::min)(smallest, (v - turned).norm());
  }
  return smallest;
}

} // namespace

BOOST_AUTO_TEST_CASE(derivatives_of_the_term)
{
  // Two seams, one of which ends inside: its sides share vertex 2.
  FFM::Seam first, second;
  first.edges = {{0, 1, 4, 3}, {1, 2, 3, 2}};
  first.lengths = {0.7, 0.4};
  second.edges = {{5, 6, 1, 0}};
  second.lengths = {0.3};
  FFM::Seam_constraints term({first, second}, 7);
  term.weight = 3;
  term.quarter_turn_weight = 2;
  FFM::Positions<2> x(2, 9);
  for(Eigen::Index i = 0; i < x.size(); ++i)
    x.data()[i] = std::sin(1 + 2.3 * static_cast<double>(i));
  term.update_multipliers(0.5 * x);
  FFM::Positions<2> gradient = FFM::Positions<2>::Zero(2, 9);
  term.add_derivatives(x, gradient, nullptr);
  const FFM::Positions<2> differences = gradient_by_differences<2>([&](const FFM::Positions<2>& y) { return term.value(y); }, x);
  BOOST_TEST((gradient - differences).norm() <= 1e-9 * gradient.norm());
  BOOST_TEST(gradient.norm() > 1);

  // Where all residuals vanish the matrix is the Hessian.
  FFM::Seam_constraints exact({first, second}, 7);
  exact.weight = 3;
  exact.quarter_turn_weight = 2;
  x.col(7) << 0, 1;
  x.col(8) << -1, 0;
  const auto turned = [](const Vector_2& u) { return Vector_2(u[1], -u[0]); };
  x.col(3) = x.col(2) - turned(x.col(2) - x.col(1));
  x.col(4) = x.col(3) - turned(x.col(1) - x.col(0));
  x.col(6) = x.col(5) - (x.col(0) - x.col(1));
  BOOST_TEST(exact.value(x) <= 1e-28);
  std::vector<std::int32_t> rows(9);
  for(int i = 0; i < 9; ++i)
    rows[i] = i;
  FFM::Block_sparse_matrix matrix;
  matrix.build_pattern(9, 2, std::vector<std::array<std::int32_t, 3>>(), exact.stencils());
  FFM::Term_matrix<2> entries(matrix, rows);
  gradient.setZero();
  exact.add_derivatives(x, gradient, &entries);
  for(Eigen::Index j = 0; j < x.size(); ++j) {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(x.size(), j), column;
    const auto gradient_at = [&](double h) {
      FFM::Positions<2> moved = x, g = FFM::Positions<2>::Zero(2, 9);
      moved.data()[j] += h;
      exact.add_derivatives(moved, g, nullptr);
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(g.data(), g.size()));
    };
    const Eigen::VectorXd expected = (gradient_at(1e-5) - gradient_at(-1e-5)) / 2e-5;
    column = matrix.lower().selfadjointView<Eigen::Lower>() * unit;
    BOOST_TEST((column - expected).norm() <= 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(a_cube_unfolds_seamlessly)
{
  Inflated_cube cube(3, 0);
  const Cut_mesh cut(cube.mesh, cube.edges, cube.vertices);
  const FFM::Seam_summary summary = FFM::parameterize_with_seams(cut, cube.border(cut), cube.uv);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  BOOST_TEST(summary.transformations.size() == 7u);
  BOOST_TEST(summary.energy == 1, boost::test_tools::tolerance(1e-9));
  for(const Vertex v : cube.corners)
    BOOST_TEST(cube.cone_angle(cut, v) == 1.5 * pi, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(seamless_map_of_an_inflated_cube)
{
  Inflated_cube cube(6, 0.6);
  const Cut_mesh cut(cube.mesh, cube.edges, cube.vertices);
  const FFM::Summary free = FFM::parameterize(cut, cube.border(cut), cube.uv);
  BOOST_TEST_REQUIRE(free.is_valid());
  double apart = 0;
  for(const auto e : cube.mesh.edges())
    if(cube.edges[e])
      apart = (std::max)(
        apart, quarter_turn_distance(cube.edge_vector(cut, cube.mesh.halfedge(e, 0)), cube.edge_vector(cut, cube.mesh.halfedge(e, 1))));
  BOOST_TEST(apart > 0.01);

  FFM::Seam_options options;
  options.cone_curvature = 0.3;
  const FFM::Seam_summary summary = FFM::parameterize_with_seams(cut, cube.border(cut), cube.uv, options);
  BOOST_TEST_REQUIRE(summary.is_valid(), summary.message);
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(summary.transformations.size() == 7u);
  BOOST_TEST(summary.residual <= 1e-8);
  BOOST_TEST(summary.energy > free.energy);
  BOOST_TEST(FFM::measure_distortion(FFM::textured_mesh(cut, cube.uv)).energy == summary.energy, boost::test_tools::tolerance(1e-9));
  for(const auto e : cube.mesh.edges())
    if(cube.edges[e])
      BOOST_TEST(quarter_turn_distance(cube.edge_vector(cut, cube.mesh.halfedge(e, 0)), cube.edge_vector(cut, cube.mesh.halfedge(e, 1))) <=
                 1e-7);
  // Eight equal corners share the curvature of the sphere.
  for(const auto v : cube.mesh.vertices())
    if(cube.vertices[v]) {
      const double expected = std::count(cube.corners.begin(), cube.corners.end(), v) > 0 ? 1.5 * pi : 2 * pi;
      BOOST_TEST(std::abs(cube.cone_angle(cut, v) - expected) <= 1e-6);
    }

  options.relation = FFM::Seam_relation::similarity;
  const FFM::Seam_summary similar = FFM::parameterize_with_seams(cut, cube.border(cut), cube.uv, options);
  BOOST_TEST_REQUIRE(similar.is_valid(), similar.message);
  BOOST_TEST(similar.residual <= 1e-8);
  // Less is asked for.
  BOOST_TEST(similar.energy <= summary.energy * (1 + 1e-9));
  BOOST_TEST(similar.energy >= free.energy * (1 - 1e-9));
}

BOOST_AUTO_TEST_CASE(prescribed_rotations_and_impossible_ones)
{
  Inflated_cube cube(4, 0.6);
  const Cut_mesh cut(cube.mesh, cube.edges, cube.vertices);
  FFM::Face_graph_domain<Cut_mesh> graph;
  std::string name, message;
  BOOST_TEST_REQUIRE((graph.load(cut, cube.border(cut), get(CGAL::vertex_point, cut), message) == FFM::Status::success));
  FFM::Positions<2> start;
  BOOST_TEST_REQUIRE(
    (FFM::internal::make_start(graph.domain(), FFM::Flip_free_map_traits<>(), start, name, message) == FFM::Status::success));
  const std::vector<FFM::Seam> seams = FFM::find_seams(cut, graph, 0.3);
  BOOST_TEST_REQUIRE(seams.size() == 7u);
  double length = 0;
  for(const FFM::Seam& seam : seams)
    length += seam.length();
  double expected = 0;
  for(const auto e : cube.mesh.edges())
    if(cube.edges[e])
      expected += std::sqrt(CGAL::squared_distance(cube.mesh.point(cube.mesh.vertex(e, 0)), cube.mesh.point(cube.mesh.vertex(e, 1))));
  BOOST_TEST(length * graph.domain().scale == expected, boost::test_tools::tolerance(1e-12));

  FFM::Positions<2> free = start;
  const FFM::Seam_summary chosen = FFM::meet_seam_constraints(graph.domain(), free, seams);
  BOOST_TEST_REQUIRE(chosen.is_valid(), chosen.message);
  std::vector<double> rotations;
  for(const auto& p : chosen.transformations)
    rotations.push_back(std::atan2(-p[1], p[0]));
  FFM::Positions<2> prescribed = start;
  const FFM::Seam_summary same =
    FFM::meet_seam_constraints(graph.domain(), prescribed, seams, FFM::Seam_options(), FFM::Flip_free_map_traits<>(), rotations);
  BOOST_TEST_REQUIRE(same.is_valid(), same.message);
  BOOST_TEST(same.energy == chosen.energy, boost::test_tools::tolerance(1e-7));

  // Without a rotation at any seam there is no cone, but a sphere has curvature.
  FFM::Positions<2> impossible = start;
  FFM::Seam_options options;
  options.largest_weight = 1e3;
  const FFM::Seam_summary none = FFM::meet_seam_constraints(graph.domain(), impossible, seams, options, FFM::Flip_free_map_traits<>(),
                                                            std::vector<double>(seams.size(), 0.));
  BOOST_TEST(FFM::status_name(none.status) == FFM::status_name(FFM::Status::unreachable_constraints));
  BOOST_TEST(none.residual > 1e-3);
  BOOST_TEST((impossible.array() == start.array()).all());

  const FFM::Seam_summary wrong =
    FFM::meet_seam_constraints(graph.domain(), impossible, seams, options, FFM::Flip_free_map_traits<>(), {0.});
  BOOST_TEST(FFM::status_name(wrong.status) == FFM::status_name(FFM::Status::invalid_option));
  options.factor = 1;
  const FFM::Seam_summary invalid = FFM::meet_seam_constraints(graph.domain(), impossible, seams, options);
  BOOST_TEST(FFM::status_name(invalid.status) == FFM::status_name(FFM::Status::invalid_option));
}

BOOST_AUTO_TEST_SUITE_END() // test_seam_constraints
