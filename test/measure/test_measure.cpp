// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Distortion measures against closed forms on maps that are known, and the way through a file and back.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/io.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_measure)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;
using FFM::Status;
using Mesh = Plain_mesh;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Point_2 = Plain_point_2;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool near(double a, double b, double tolerance = 1e-13) { return std::abs(a - b) <= tolerance * (1 + std::abs(b)); }

// A flat sheet, turned in space, with areas that differ: its rows grow in height. The parameters are the plane's coordinates.
struct Sheet
{
  Soup soup;
  std::vector<std::array<double, 2>> parameters;
  Mesh mesh;
  std::vector<Vertex> vertices;
  Mesh::Property_map<Vertex, Point_2> uv;

  Sheet()
  {
    soup = bumpy_soup(4, 3);
    for(auto& p : soup.points) {
      const double x = p[0], y = p[1] * (1 + p[1]);
      parameters.push_back({x, y});
      // Orthonormal directions (2, 2, 1) / 3 and (1, -2, 2) / 3.
      p = {5 + (2 * x + y) / 3, (2 * x - 2 * y) / 3, (x + 2 * y) / 3 - 1};
    }
    vertices = add_soup(soup, mesh);
    uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  }

  FFM::Distortion_report measure(const std::function<Point_2(double, double)>& map)
  {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      uv[vertices[i]] = map(parameters[i][0], parameters[i][1]);
    const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
    BOOST_TEST(report.elements == static_cast<std::int64_t>(soup.triangles.size()));
    BOOST_TEST(near(report.rest_area, 0.75 * 1.75));
    return report;
  }

  double area(Face f) const
  {
    const auto& t = soup.triangles[f];
    const auto &p = parameters[t[0]], &q = parameters[t[1]], &r = parameters[t[2]];
    return 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(isometry, Sheet)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const FFM::Distortion_report report = measure([=](double x, double y) { return Point_2(c * x - s * y + 3, s * x + c * y - 2); });
  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::success));
  BOOST_TEST(report.flips == 0);
  BOOST_TEST(near(report.image_area, report.rest_area));
  for(double value : {report.energy, report.energy_of_similarity, report.max_energy, report.mean_angle_distortion,
                      report.mean_area_distortion, report.min_singular_value, report.max_singular_value, report.stretch_95})
    BOOST_TEST(near(value, 1));
}

BOOST_FIXTURE_TEST_CASE(scaling, Sheet)
{
  for(const double t : {0.01, 0.5, 3., 1000.}) {
    const FFM::Distortion_report report = measure([=](double x, double y) { return Point_2(t * x, t * y); });
    BOOST_TEST(near(report.energy, 0.5 * (t * t + 1 / (t * t))));
    BOOST_TEST(near(report.max_energy, report.energy));
    BOOST_TEST(near(report.energy_of_similarity, 1));
    BOOST_TEST(near(report.mean_angle_distortion, 1));
    BOOST_TEST(near(report.mean_area_distortion, report.energy));
    BOOST_TEST(near(report.min_singular_value, t));
    BOOST_TEST(near(report.max_singular_value, t));
    BOOST_TEST(near(report.stretch_95, 1));
    BOOST_TEST(near(report.image_area, t * t * report.rest_area));
  }
}

BOOST_FIXTURE_TEST_CASE(shear_and_stretch, Sheet)
{
  // Squared singular values of ((1, k), (0, 1)) have the sum 2 + k^2 and the product 1.
  for(const double k : {0.1, 1., 7.}) {
    const FFM::Distortion_report report = measure([=](double x, double y) { return Point_2(x + k * y, y); });
    BOOST_TEST(near(report.energy, 1 + k * k / 2));
    BOOST_TEST(near(report.energy_of_similarity, report.energy));
    BOOST_TEST(near(report.mean_angle_distortion, 1 + k * k / 2));
    BOOST_TEST(near(report.mean_area_distortion, 1));
    BOOST_TEST(near(report.max_singular_value, 0.5 * (k + std::sqrt(k * k + 4))));
    BOOST_TEST(near(report.stretch_95, report.max_singular_value));
    BOOST_TEST(near(report.min_singular_value, 0.5 * (std::sqrt(k * k + 4) - k), 1e-12));
  }
  const double a = 3, b = 0.25;
  const FFM::Distortion_report report = measure([=](double x, double y) { return Point_2(a * x, b * y); });
  BOOST_TEST(near(report.energy, 0.25 * (a * a + b * b + 1 / (a * a) + 1 / (b * b))));
  BOOST_TEST(near(report.energy_of_similarity, 0.5 * (a / b + b / a)));
  BOOST_TEST(near(report.mean_angle_distortion, 0.5 * (a / b + b / a)));
  BOOST_TEST(near(report.mean_area_distortion, 0.5 * (a * b + 1 / (a * b))));
  BOOST_TEST(near(report.max_singular_value, a));
  BOOST_TEST(near(report.stretch_95, std::sqrt(a / b)));
  BOOST_TEST(near(report.min_singular_value, b));
}

BOOST_FIXTURE_TEST_CASE(means_are_weighted_by_area, Sheet)
{
  // Stretched by 2 above a row: triangles below have energy 1, those above (1 + 4 + 1 + 1/4) / 4.
  const double bend = parameters[5][1];
  const FFM::Distortion_report report = measure([=](double x, double y) { return Point_2(x, y > bend ? 2 * y - bend : y); });
  auto distortion = mesh.add_property_map<Face, double>("f:distortion").first;
  BOOST_TEST(FFM::status_name(FFM::face_distortions(mesh, uv, distortion)) == FFM::status_name(Status::success));
  double sum = 0, total = 0;
  for(const Face f : mesh.faces()) {
    const bool is_stretched = f >= 8;
    BOOST_TEST(near(distortion[f], is_stretched ? 1.5625 : 1.));
    sum += area(f) * (is_stretched ? 1.5625 : 1.);
    total += area(f);
  }
  BOOST_TEST(near(report.energy, sum / total));
  BOOST_TEST(near(report.max_energy, 1.5625));
  BOOST_TEST(report.energy_of_similarity < report.energy);
}

BOOST_FIXTURE_TEST_CASE(mirrored, Sheet)
{
  const FFM::Distortion_report report = measure([](double x, double y) { return Point_2(-x, y); });
  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::success));
  BOOST_TEST(report.flips == report.elements);
  BOOST_TEST(report.energy == infinity);
  BOOST_TEST(report.energy_of_similarity == infinity);
  BOOST_TEST(near(report.image_area, -report.rest_area));
  BOOST_TEST(near(report.min_singular_value, -1));
  BOOST_TEST(near(report.max_singular_value, 1));
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == report.elements);
  BOOST_TEST(!FFM::is_flip_free(mesh, uv));
}

BOOST_FIXTURE_TEST_CASE(one_flipped_and_one_collapsed, Sheet)
{
  auto distortion = mesh.add_property_map<Face, double>("f:distortion").first;
  measure([](double x, double y) { return Point_2(x, y); });
  BOOST_TEST(FFM::is_flip_free(mesh, uv));

  // The last vertex is a corner of the sheet, with one triangle or two. It goes to the other side of its cell,
  // or onto a neighbour.
  int incident = 0;
  const int tip = static_cast<int>(vertices.size()) - 1;
  for(const auto& t : soup.triangles)
    incident += t[0] == tip || t[1] == tip || t[2] == tip ? 1 : 0;
  const Point_2 before = uv[vertices[tip]];
  const Point_2 left = uv[vertices[tip - 1]], diagonal = uv[vertices[tip - 6]];
  BOOST_TEST_REQUIRE((incident == 1 || incident == 2));
  for(const bool collapsed : {false, true}) {
    uv[vertices[tip]] = collapsed ? left : Point_2(2 * diagonal.x() - before.x(), 2 * diagonal.y() - before.y());
    const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
    const int expected = collapsed ? 1 : incident;
    BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::success));
    BOOST_TEST(report.flips == expected);
    BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) == expected);
    BOOST_TEST(report.energy == infinity);
    BOOST_TEST(report.max_energy == infinity);
    if(collapsed)
      BOOST_TEST(std::abs(report.min_singular_value) < 1e-14);
    else
      BOOST_TEST(report.min_singular_value < 0);
    BOOST_TEST(FFM::status_name(FFM::face_distortions(mesh, uv, distortion)) == FFM::status_name(Status::success));
    int infinite = 0;
    for(const Face f : mesh.faces())
      infinite += distortion[f] == infinity ? 1 : 0;
    BOOST_TEST(infinite == expected);
  }
}

BOOST_AUTO_TEST_CASE(nearly_collapsed_triangles_are_told_by_exact_predicates)
{
  Soup one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  Mesh triangle;
  const auto v = add_soup(one, triangle);
  std::vector<Point_2> images(3);
  const auto map = boost::make_iterator_property_map(images.begin(), get(boost::vertex_index, triangle));
  const double unit = std::numeric_limits<double>::epsilon();
  // The sign of these areas is beyond what a cross product in double precision can tell.
  images = {Point_2(12, 12), Point_2(24, 24), Point_2(0.5, 0.5 + unit / 2)};
  BOOST_TEST(FFM::number_of_flipped_elements(triangle, map) == 0);
  images[2] = Point_2(0.5, 0.5 - unit / 4);
  BOOST_TEST(FFM::number_of_flipped_elements(triangle, map) == 1);
  images[2] = Point_2(0.5, 0.5);
  BOOST_TEST(FFM::number_of_flipped_elements(triangle, map) == 1);
  images[2] = Point_2(not_a_number, 0.5);
  BOOST_TEST(FFM::number_of_flipped_elements(triangle, map) == 1);
}

BOOST_FIXTURE_TEST_CASE(what_cannot_be_measured, Sheet)
{
  const auto identity = [](double x, double y) { return Point_2(x, y); };
  measure(identity);
  uv[vertices[7]] = Point_2(0, not_a_number);
  FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::non_finite_input));
  BOOST_TEST(!report.message.empty());
  BOOST_TEST(FFM::number_of_flipped_elements(mesh, uv) > 0);
  auto distortion = mesh.add_property_map<Face, double>("f:distortion").first;
  BOOST_TEST(FFM::status_name(FFM::face_distortions(mesh, uv, distortion)) == FFM::status_name(Status::non_finite_input));

  measure(identity);
  mesh.point(vertices[0]) = mesh.point(vertices[1]);
  report = FFM::measure_distortion(mesh, uv);
  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::degenerate_rest_element));
  BOOST_TEST(report.message.find("number 0") != std::string::npos);

  mesh.add_face(vertices[1], vertices[0], mesh.add_vertex(Mesh::Point(9, 0, 0)), mesh.add_vertex(Mesh::Point(9, 1, 0)));
  mesh.point(vertices[0]) = Mesh::Point(-1, -1, -1);
  report = FFM::measure_distortion(mesh, uv);
  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::not_triangular));

  mesh.clear();
  BOOST_TEST(FFM::status_name(FFM::measure_distortion(Mesh(), uv).status) == FFM::status_name(Status::empty_mesh));
  BOOST_TEST(FFM::status_name(FFM::measure_distortion(FFM::Textured_mesh()).status) == FFM::status_name(Status::empty_mesh));
}

BOOST_FIXTURE_TEST_CASE(units_of_any_magnitude, Sheet)
{
  const auto shear = [](double x, double y) { return Point_2(x + y, y); };
  const FFM::Distortion_report plain = measure(shear);
  for(const int exponent : {-900, -560, 3, 500, 990}) {
    const double t = std::ldexp(1, exponent);
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      const auto& p = soup.points[i];
      mesh.point(vertices[i]) = Mesh::Point(t * p[0], t * p[1], t * p[2]);
      const Point_2 q = shear(parameters[i][0], parameters[i][1]);
      uv[vertices[i]] = Point_2(t * q.x(), t * q.y());
    }
    const FFM::Distortion_report report = FFM::measure_distortion(mesh, uv);
    BOOST_TEST_CONTEXT("unit 2^" << exponent)
    {
      BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::success));
      BOOST_TEST(report.flips == 0);
      // The unit is a power of two: not a bit differs.
      BOOST_TEST(report.energy == plain.energy);
      BOOST_TEST(report.energy_of_similarity == plain.energy_of_similarity);
      BOOST_TEST(report.min_singular_value == plain.min_singular_value);
      BOOST_TEST(report.rest_area == std::ldexp(plain.rest_area, 2 * exponent));
    }
  }
}

BOOST_AUTO_TEST_CASE(through_a_file_and_back)
{
  const Soup soup = bumpy_soup();
  Mesh mesh;
  add_soup(soup, mesh);
  auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  BOOST_TEST_REQUIRE(FFM::parameterize(mesh, corner_halfedge(mesh), uv).converged());
  const FFM::Distortion_report direct = FFM::measure_distortion(mesh, uv);

  const std::string path = "measure_round_trip.obj";
  std::string message;
  BOOST_TEST_REQUIRE(FFM::write_textured_OBJ(path, FFM::textured_mesh(mesh, uv), &message), message);
  FFM::Textured_mesh read;
  BOOST_TEST_REQUIRE(FFM::read_textured_OBJ(path, read, &message), message);
  std::remove(path.c_str());
  const FFM::Distortion_report report = FFM::measure_distortion(read);

  BOOST_TEST(FFM::status_name(report.status) == FFM::status_name(Status::success));
  BOOST_TEST(report.elements == direct.elements);
  BOOST_TEST(report.flips == direct.flips);
  BOOST_TEST(report.rest_area == direct.rest_area);
  BOOST_TEST(report.image_area == direct.image_area);
  BOOST_TEST(report.energy == direct.energy);
  BOOST_TEST(report.energy_of_similarity == direct.energy_of_similarity);
  BOOST_TEST(report.max_energy == direct.max_energy);
  BOOST_TEST(report.mean_angle_distortion == direct.mean_angle_distortion);
  BOOST_TEST(report.mean_area_distortion == direct.mean_area_distortion);
  BOOST_TEST(report.min_singular_value == direct.min_singular_value);
  BOOST_TEST(report.max_singular_value == direct.max_singular_value);
}

BOOST_AUTO_TEST_SUITE_END() // test_measure
