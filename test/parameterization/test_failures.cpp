// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Everything that can be wrong with a mesh, an option or the machine: each has its status and a message, and leaves the map
// alone. And inputs that look wrong but are not.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_failures)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Point_2f = CGAL::Simple_cartesian<float>::Point_2;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

struct Fixture
{
  Mesh mesh;
  FFM::Summary summary;
  bool is_strict = false;

  Halfedge any_border() const
  {
    for(const auto h : mesh.halfedges())
      if(mesh.is_border(h))
        return h;
    return Mesh::null_halfedge();
  }

  // Fails as expected, with a sentence, and without touching the map.
  template <typename Point_2 = Plain_point_2, typename Traits = FFM::Flip_free_map_traits<>>
  void check_failure(Halfedge h, Status status, const Traits& traits = Traits())
  {
    const Point_2 sentinel(12345, -54321);
    auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv", sentinel).first;
    summary = FFM::parameterize(mesh, h, uv, traits, FFM::parameters::strict(is_strict));
    BOOST_TEST_CONTEXT(summary.message)
    {
      BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
      BOOST_TEST(!summary.is_valid());
      BOOST_TEST(!summary.converged());
      BOOST_TEST(summary.message.size() > 10);
      for(const auto v : mesh.vertices())
        BOOST_TEST((uv[v] == sentinel));
    }
    mesh.remove_property_map(uv);
  }

  bool message_has(const std::string& text) const { return summary.message.find(text) != std::string::npos; }

  void check_success(Halfedge h, double energy, double tolerance = 1e-9)
  {
    auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
    summary = FFM::parameterize(mesh, h, uv, tight_traits());
    BOOST_TEST_CONTEXT(summary.message)
    {
      BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::success));
      BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
      BOOST_TEST(std::abs(summary.energy - energy) <= tolerance);
    }
    mesh.remove_property_map(uv);
  }
};

Soup transformed(Soup soup, double scale, double shift)
{
  for(auto& p : soup.points)
    for(double& c : p)
      c = scale * c + shift;
  return soup;
}

// A grid of cells around the z axis that ends in a disk of triangles; open at the bottom. It is not round, so that the images of
// its rings do not shrink towards the origin, where numbers are dense.
Soup tube(int around, int rings, double step)
{
  Soup soup;
  for(int j = 0; j < rings; ++j)
    for(int i = 0; i < around; ++i)
      soup.points.push_back({1.7 * std::cos(2 * CGAL_PI * i / around + 0.4), std::sin(2 * CGAL_PI * i / around + 0.4), step * j});
  soup.points.push_back({0, 0, step * rings});
  for(int j = 0; j < rings; ++j)
    for(int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around;
      if(j + 1 == rings) {
        soup.triangles.push_back({a, b, around * rings});
        continue;
      }
      soup.triangles.push_back({a, b, b + around});
      soup.triangles.push_back({a, b + around, a + around});
    }
  return soup;
}

// A planar web: rings of triangles around a point, each a quarter as large as the one before.
Soup web(int rings)
{
  Soup soup;
  double radius = 1;
  for(int j = 0; j < rings; ++j, radius /= 4)
    for(int i = 0; i < 6; ++i)
      soup.points.push_back({radius * std::cos(CGAL_PI * i / 3), radius * std::sin(CGAL_PI * i / 3), 0});
  // The center of the rings is far from the center of the border.
  for(int i = 0; i < 6; ++i)
    soup.points[i][0] += 0.6;
  soup.points.push_back({0, 0, 0});
  for(int j = 0; j + 1 < rings; ++j)
    for(int i = 0; i < 6; ++i) {
      const int a = 6 * j + i, b = 6 * j + (i + 1) % 6;
      soup.triangles.push_back({a, b, b + 6});
      soup.triangles.push_back({a, b + 6, a + 6});
    }
  for(int i = 0; i < 6; ++i)
    soup.triangles.push_back({6 * (rings - 1) + i, 6 * (rings - 1) + (i + 1) % 6, 6 * rings});
  return soup;
}

// Factorizes nothing.
struct Failing_solver
{
  std::string name() const { return "failing"; }
  std::string ordering() const { return "none"; }
  bool analyze_pattern(const FFM::Block_sparse_matrix&) { return true; }
  bool factorize(const FFM::Block_sparse_matrix&) { return false; }
  bool solve(const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }
  std::int64_t factor_entries() const { return -1; }
};

// Says it factorizes, but solves nothing.
struct Unsolving_solver : Failing_solver
{
  bool factorize(const FFM::Block_sparse_matrix&) { return true; }
};

struct Greedy_solver : Failing_solver
{
  bool factorize(const FFM::Block_sparse_matrix&) { throw std::bad_alloc(); }
};

template <typename Solver>
using Traits_with = FFM::Flip_free_map_traits<CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default, Solver>;

} // namespace

BOOST_FIXTURE_TEST_CASE(closed_surface, Fixture)
{
  add_soup(sphere_soup(), mesh);
  check_failure(*mesh.halfedges().begin(), Status::no_border);
  check_failure(any_border(), Status::no_border);
}

BOOST_FIXTURE_TEST_CASE(halfedge_not_on_the_border, Fixture)
{
  add_soup(bumpy_soup(3, 3), mesh);
  check_failure(mesh.opposite(corner_halfedge(mesh)), Status::no_border);
  check_failure(Mesh::null_halfedge(), Status::no_border);
  BOOST_TEST(summary.vertices == -1);
  BOOST_TEST(summary.elements == -1);
}

BOOST_FIXTURE_TEST_CASE(edge_without_faces, Fixture)
{
  const auto v = mesh.add_vertex(Mesh::Point(0, 0, 0)), w = mesh.add_vertex(Mesh::Point(1, 0, 0));
  check_failure(mesh.add_edge(v, w), Status::empty_mesh);
}

BOOST_FIXTURE_TEST_CASE(polygons, Fixture)
{
  CGAL::make_grid(3, 3, mesh);
  is_strict = true;
  check_failure(any_border(), Status::not_triangular);
}

BOOST_FIXTURE_TEST_CASE(one_polygon_among_triangles, Fixture)
{
  const auto vertices = add_soup(bumpy_soup(3, 3), mesh);
  mesh.add_face(vertices[3], vertices[2], mesh.add_vertex(Mesh::Point(1, -1, 0)), mesh.add_vertex(Mesh::Point(2, -1, 0)));
  is_strict = true;
  check_failure(any_border(), Status::not_triangular);
  BOOST_TEST(message_has("18"));
}

BOOST_FIXTURE_TEST_CASE(face_of_two_edges, Fixture)
{
  const auto vertices = add_soup(bumpy_soup(1, 1), mesh);
  const Halfedge inner = mesh.halfedge(vertices[1], vertices[2]);
  BOOST_TEST_REQUIRE(inner.is_valid());
  // A digon between the two triangles.
  const Halfedge g = mesh.add_edge(vertices[1], vertices[2]), back = mesh.opposite(g);
  const auto digon = mesh.add_face();
  const Halfedge other = mesh.opposite(inner), next = mesh.next(other), prev = mesh.prev(other);
  const auto f = mesh.face(other);
  mesh.set_next(back, next);
  mesh.set_next(prev, back);
  mesh.set_face(back, f);
  mesh.set_halfedge(f, back);
  mesh.set_next(g, other);
  mesh.set_next(other, g);
  mesh.set_face(g, digon);
  mesh.set_face(other, digon);
  mesh.set_halfedge(digon, g);
  BOOST_TEST_REQUIRE(mesh.degree(digon) == 2u);
  is_strict = true;
  check_failure(any_border(), Status::not_triangular);
  // It has the image of an edge.
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
  summary = FFM::parameterize(mesh, any_border(), uv);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::success));
  BOOST_TEST(summary.elements == 2);
  BOOST_TEST(summary.faces_without_area == 1);
}

BOOST_FIXTURE_TEST_CASE(handle, Fixture)
{
  // A torus without one face has a single border.
  Soup soup;
  const int n = 6;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * j / n;
      soup.points.push_back({(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)});
      const int a = n * i + j, b = n * ((i + 1) % n) + j, c = n * ((i + 1) % n) + (j + 1) % n, d = n * i + (j + 1) % n;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  soup.triangles.pop_back();
  add_soup(soup, mesh);
  check_failure(any_border(), Status::not_a_disk);
  BOOST_TEST(message_has("genus 1"));
  BOOST_TEST(message_has("-1"));
  BOOST_TEST(message_has("cut_to_disk"));
  // Nor does a second hole make it a disk with holes.
  mesh.clear();
  soup.triangles.erase(soup.triangles.begin() + 30);
  add_soup(soup, mesh);
  check_failure(any_border(), Status::not_a_disk);
  BOOST_TEST(message_has("genus 1"));
  BOOST_TEST(message_has("2 borders"));
}

BOOST_FIXTURE_TEST_CASE(border_touches_itself, Fixture)
{
  // Two vertices of the border of a strip become one.
  const auto vertices = add_soup(bumpy_soup(6, 1), mesh);
  const Halfedge h = corner_halfedge(mesh);
  const Vertex kept = vertices[0], merged = vertices[6];
  std::vector<Halfedge> around;
  for(const auto g : CGAL::halfedges_around_target(mesh.halfedge(merged), mesh))
    around.push_back(g);
  for(const auto g : around)
    mesh.set_target(g, kept);
  mesh.remove_vertex(merged);
  check_failure(h, Status::non_manifold);
  BOOST_TEST(message_has("twice"));
}

BOOST_FIXTURE_TEST_CASE(holes_that_touch, Fixture)
{
  // Two removed cells share a vertex only. Read as a soup, such a vertex is doubled or shared;
  // it is no disk with holes either way.
  Soup soup = bumpy_soup(4, 4);
  const int first = 2 * (4 * 1 + 1), second = 2 * (4 * 2 + 2);
  soup.triangles.erase(soup.triangles.begin() + second, soup.triangles.begin() + second + 2);
  soup.triangles.erase(soup.triangles.begin() + first, soup.triangles.begin() + first + 2);
  add_soup(soup, mesh);
  BOOST_TEST_REQUIRE(mesh.number_of_faces() == soup.triangles.size());
  check_failure(corner_halfedge(mesh), Status::non_manifold);
}

BOOST_FIXTURE_TEST_CASE(sheets_that_meet_inside, Fixture)
{
  // Two inner vertices of a sheet become one: the border is a single one without repetitions.
  const auto vertices = add_soup(bumpy_soup(6, 4), mesh);
  const Halfedge h = corner_halfedge(mesh);
  const Vertex kept = vertices[7 * 2 + 1], merged = vertices[7 * 2 + 5];
  std::vector<Halfedge> around;
  for(const auto g : CGAL::halfedges_around_target(mesh.halfedge(merged), mesh))
    around.push_back(g);
  for(const auto g : around)
    mesh.set_target(g, kept);
  mesh.remove_vertex(merged);
  check_failure(h, Status::non_manifold);
  BOOST_TEST(message_has("several sheets"));
}

BOOST_FIXTURE_TEST_CASE(degenerate_triangles, Fixture)
{
  is_strict = true;
  for(const bool collinear : {false, true}) {
    mesh.clear();
    Soup soup = bumpy_soup(5, 4);
    // The last cell's corner moves onto a side of the last triangle, or onto a vertex of the last two triangles.
    const auto t = soup.triangles.back();
    for(int c = 0; c < 3; ++c)
      soup.points[t[1]][c] = collinear ? 0.5 * (soup.points[t[0]][c] + soup.points[t[2]][c]) : soup.points[t[0]][c];
    add_soup(soup, mesh);
    check_failure(corner_halfedge(mesh), Status::degenerate_rest_element);
    // The mesh' own number of the face, not that of some walk.
    BOOST_TEST_CONTEXT(summary.message)
    BOOST_TEST((message_has("number " + std::to_string(soup.triangles.size() - 1)) ||
                (!collinear && message_has("number " + std::to_string(soup.triangles.size() - 2)))));
  }
}

BOOST_FIXTURE_TEST_CASE(all_points_coincide, Fixture)
{
  add_soup(bumpy_soup(3, 3), mesh);
  const Halfedge h = corner_halfedge(mesh);
  for(const auto v : mesh.vertices())
    mesh.point(v) = Mesh::Point(3, 4, 5);
  check_failure(h, Status::degenerate_rest_element);
}

BOOST_FIXTURE_TEST_CASE(not_finite, Fixture)
{
  const auto vertices = add_soup(bumpy_soup(3, 3), mesh);
  const Halfedge h = corner_halfedge(mesh);
  const auto p = mesh.point(vertices[5]);
  for(const auto& q : {Mesh::Point(not_a_number, 0, 0), Mesh::Point(0, infinity, 0), Mesh::Point(0, 0, -infinity)}) {
    mesh.point(vertices[5]) = q;
    check_failure(h, Status::non_finite_input);
  }
  // Finite, but the distance is not.
  mesh.point(vertices[5]) = Mesh::Point(p.x(), p.y(), 1.7e308);
  mesh.point(vertices[6]) = Mesh::Point(p.x(), p.y(), -1.7e308);
  check_failure(h, Status::non_finite_input);
  BOOST_TEST(message_has("range"));
}

BOOST_FIXTURE_TEST_CASE(any_scale_and_place_will_do, Fixture)
{
  const Soup soup = bumpy_soup();
  const double energy = plain_result(soup).summary.energy;
  for(const double scale : {1e150, 1e-170, 1e300, 1e-290}) {
    mesh.clear();
    const auto vertices = add_soup(transformed(soup, scale, 0), mesh);
    BOOST_TEST_CONTEXT("scale " << scale)
    {
      check_success(corner_halfedge(mesh), energy);
      auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
      FFM::parameterize(mesh, corner_halfedge(mesh), uv);
      // In the surface's own units.
      const double length =
        std::hypot((uv[vertices[0]].x() - uv[vertices[11]].x()) / scale, (uv[vertices[0]].y() - uv[vertices[11]].y()) / scale);
      BOOST_TEST(length > 0.9);
      BOOST_TEST(length < 1.5);
    }
  }
  // The sheet has coordinates of 24 bits at most; so far out it is rounded a little.
  mesh.clear();
  add_soup(transformed(soup, 1, 1048576), mesh);
  check_success(any_border(), energy, 1e-5);
}

BOOST_FIXTURE_TEST_CASE(long_thin_tube, Fixture)
{
  // With three vertices around, each ring's image is a small part of the one outside.
  add_soup(tube(3, 12, 0.7), mesh);
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
  summary = FFM::parameterize(mesh, any_border(), uv);
  BOOST_TEST(summary.converged());
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  mesh.remove_property_map(uv);

  // The embedding of a much longer one is beyond double precision.
  mesh.clear();
  add_soup(tube(3, 600, 0.7), mesh);
  FFM::Flip_free_map_traits<> traits;
  traits.start.fall_back = false;
  traits.start.multilevel_size = -1;
  for(const auto weights : {FFM::Tutte_weights::uniform, FFM::Tutte_weights::mean_value, FFM::Tutte_weights::cotangent}) {
    traits.start.weights = weights;
    check_failure(any_border(), Status::start_not_flip_free, traits);
    BOOST_TEST(message_has(FFM::weights_name(weights)));
  }

  // With fallbacks there is a map without flips, or none.
  traits.start.fall_back = true;
  traits.options.max_iterations = 10;
  uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv", Plain_point_2(7, 7)).first;
  summary = FFM::parameterize(mesh, any_border(), uv, traits);
  if(summary.is_valid()) {
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  } else {
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(Status::start_not_flip_free));
    for(const auto weights : {FFM::Tutte_weights::uniform, FFM::Tutte_weights::mean_value, FFM::Tutte_weights::cotangent})
      BOOST_TEST(message_has(FFM::weights_name(weights)));
    for(const auto v : mesh.vertices())
      BOOST_TEST((uv[v] == Plain_point_2(7, 7)));
  }
}

BOOST_FIXTURE_TEST_CASE(invalid_options, Fixture)
{
  add_soup(bumpy_soup(3, 3), mesh);
  const Halfedge h = corner_halfedge(mesh);
  const FFM::Flip_free_map_traits<> valid;
  const auto check = [&](auto&& change) {
    auto traits = valid;
    change(traits);
    check_failure(h, Status::invalid_option, traits);
  };
  check([](auto& traits) { traits.options.characteristic_gradient_tolerance = -1; });
  check([](auto& traits) { traits.options.gradient_tolerance = not_a_number; });
  check([](auto& traits) { traits.options.max_iterations = -1; });
  check([](auto& traits) { traits.options.max_seconds = not_a_number; });
  check([](auto& traits) { traits.options.step_fraction = 1; });
  check([](auto& traits) { traits.options.armijo = 0; });
  check([](auto& traits) { traits.start.border = FFM::Border_shape::polygon; });
  check([](auto& traits) {
    traits.start.border = FFM::Border_shape::polygon;
    traits.start.polygon = {{0, 0}, {0, 1}, {1, 0}}; // clockwise
  });
}

BOOST_FIXTURE_TEST_CASE(result_leaves_the_range_of_float, Fixture)
{
  for(const double scale : {1e60, 1e-60}) {
    mesh.clear();
    add_soup(transformed(bumpy_soup(4, 4), scale, 0), mesh);
    check_failure<Point_2f>(corner_halfedge(mesh), Status::result_not_representable);
    BOOST_TEST(summary.flips > 0);
  }
}

BOOST_FIXTURE_TEST_CASE(result_is_too_fine_for_float, Fixture)
{
  add_soup(web(16), mesh);
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:double").first;
  summary = FFM::parameterize(mesh, any_border(), uv);
  BOOST_TEST(summary.is_valid());
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
  check_failure<Point_2f>(any_border(), Status::result_not_representable);
}

BOOST_FIXTURE_TEST_CASE(linear_solvers_that_fail, Fixture)
{
  add_soup(bumpy_soup(4, 4), mesh);
  const Halfedge h = corner_halfedge(mesh);
  // The start by mean values has a solver of its own, and the minimizer falls back to one.
  auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:fallback").first;
  summary = FFM::parameterize(mesh, h, uv, Traits_with<Failing_solver>());
  BOOST_TEST_CONTEXT(summary.message)
  BOOST_TEST(summary.converged());
  BOOST_TEST(summary.linear_solver.find("failing, then ") == 0u);
  BOOST_TEST(summary.start.find("mean_value") != std::string::npos);
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);

  Traits_with<Failing_solver> traits;
  traits.start.fall_back = false;
  check_failure(h, Status::start_not_flip_free, traits);
  check_failure(h, Status::linear_solver_failed, Traits_with<Unsolving_solver>());
  check_failure(h, Status::out_of_memory, Traits_with<Greedy_solver>());
}

BOOST_FIXTURE_TEST_CASE(limits_leave_a_valid_map, Fixture)
{
  add_soup(bumpy_soup(), mesh);
  const auto check = [&](Status status, auto&& change) {
    auto uv = mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
    FFM::Flip_free_map_traits<> traits;
    change(traits.options);
    summary = FFM::parameterize(mesh, corner_halfedge(mesh), uv, traits);
    BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(status));
    BOOST_TEST(summary.is_valid());
    BOOST_TEST(!summary.converged());
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == 0);
    mesh.remove_property_map(uv);
  };
  check(Status::iteration_limit, [](auto& options) { options.max_iterations = 2; });
  check(Status::time_limit, [](auto& options) { options.max_seconds = 0; });
  check(Status::stopped_by_observer,
        [](auto& options) { options.observer = [](const FFM::Iteration_report& report) { return report.iteration < 2; }; });
}

BOOST_FIXTURE_TEST_CASE(smallest_meshes, Fixture)
{
  // One triangle and two triangles are flat: their maps are isometries.
  Soup soup;
  soup.points = {{0, 0, 0}, {3, 0, 1}, {0, 2, 5}, {4, 4, 4}};
  soup.triangles = {{0, 1, 2}};
  add_soup(soup, mesh);
  check_success(any_border(), 1, 1e-12);
  mesh.clear();
  soup.triangles.push_back({2, 1, 3});
  add_soup(soup, mesh);
  check_success(any_border(), 1, 1e-12);
}

BOOST_AUTO_TEST_CASE(files_of_faulty_meshes, *boost::unit_test::label("needs_data"))
{
  const std::string folder = FLIP_FREE_MAPS_SHARED_DATA_DIR;
  if(!std::ifstream(folder + "/bad_annulus.off")) {
    skip_case("there are no meshes in " + folder);
    return;
  }
  const struct
  {
    const char* name;
    Status status;
  } cases[] = {{"bad_annulus", Status::success},
               {"bad_closed_cube", Status::no_border},
               {"bad_closed_tetrahedron", Status::no_border},
               {"bad_collinear_triangle", Status::degenerate_rest_element},
               {"bad_zero_area_triangle", Status::degenerate_rest_element},
               {"bad_mixed_polygons", Status::not_triangular},
               {"bad_quads", Status::not_triangular},
               {"bad_cgal_issue_4290", Status::success},
               {"bad_far_from_origin", Status::success},
               {"bad_huge_coordinates", Status::success},
               {"bad_isolated_vertex", Status::success},
               {"bad_near_degenerate", Status::success},
               {"bad_single_triangle", Status::success},
               {"bad_tiny_coordinates", Status::success},
               {"bad_two_components", Status::success},
               {"bad_two_triangles", Status::success}};
  for(const auto& c : cases)
    BOOST_TEST_CONTEXT(c.name)
    {
      std::vector<Mesh::Point> points;
      std::vector<std::vector<std::size_t>> polygons;
      BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_soup(folder + "/" + c.name + ".off", points, polygons));
      Fixture fixture;
      CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, fixture.mesh);
      fixture.is_strict = c.status == Status::degenerate_rest_element || c.status == Status::not_triangular;
      if(!FFM::is_valid_map(c.status))
        fixture.check_failure(fixture.any_border(), c.status);
      if(!FFM::is_valid_map(c.status) && !fixture.is_strict)
        continue;
      auto uv = fixture.mesh.add_property_map<Vertex, Plain_point_2>("v:uv").first;
      fixture.summary = FFM::parameterize(fixture.mesh, fixture.any_border(), uv);
      BOOST_TEST(FFM::status_name(fixture.summary.status) == FFM::status_name(Status::success));
      if(std::string(c.name) != "bad_two_components" && c.status != Status::not_triangular)
        BOOST_TEST(FFM::number_of_flipped_elements(fixture.mesh, uv) == 0);
    }
}

BOOST_AUTO_TEST_SUITE_END() // test_failures
