// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// CGAL's package Surface_mesh_parameterization with square borders, with its parameterizer exchanged: the border makes the start.

#include "support/unit_test.h"

#include "support/mesh_checks.h"

#include <CGAL/Flip_free_maps/Flip_free_parameterizer_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_drop_in_square)

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Polyhedron_3<Kernel> PolyMesh;
typedef boost::graph_traits<PolyMesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<PolyMesh>::vertex_descriptor vertex_descriptor;
typedef CGAL::Unique_hash_map<vertex_descriptor, Point_2> UV_uhm;
typedef boost::associative_property_map<UV_uhm> UV_pmap;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace FFM = CGAL::Flip_free_maps;
using test_support::add_soup;
using test_support::bumpy_soup;

namespace {

// A border parameterizer without success.
struct Refusing
{
  template <typename VertexUVMap, typename VertexIndexMap, typename VertexParameterizedMap>
  SMP::Error_code parameterize(const PolyMesh&, halfedge_descriptor, VertexUVMap, VertexIndexMap, VertexParameterizedMap)
  {
    return SMP::ERROR_BORDER_TOO_SHORT;
  }
};

struct Fixture
{
  test_support::Soup soup;
  PolyMesh sm;
  std::vector<vertex_descriptor> vertices;
  UV_uhm uv_uhm;
  UV_pmap uv_map{uv_uhm};
  FFM::Flip_free_map_traits<> traits;
  FFM::Summary summary;
  double energy;

  explicit Fixture(const test_support::Soup& s = bumpy_soup())
    : soup(s), vertices(add_soup(soup, sm)), energy(test_support::plain_result(soup).summary.energy)
  {}

  template <typename Parameterizer>
  void check(const Parameterizer& parameterizer)
  {
    halfedge_descriptor bhd = CGAL::Polygon_mesh_processing::longest_border(sm).first;
    BOOST_TEST(SMP::parameterize(sm, parameterizer, bhd, uv_map) == SMP::OK);
    BOOST_TEST(summary.converged());
    BOOST_TEST(FFM::number_of_flipped_elements(sm, uv_map) == 0);
    // The border is only a start.
    BOOST_TEST(std::abs(summary.energy - energy) <= 1e-6);
    BOOST_TEST(std::abs(FFM::measure_distortion(sm, uv_map).energy - summary.energy) <= 1e-10);
  }

  template <typename Border>
  FFM::Flip_free_parameterizer_3<PolyMesh, Border> parameterizer(const Border& border)
  {
    typedef FFM::Flip_free_parameterizer_3<PolyMesh, Border> Parameterizer;
    return Parameterizer(border, typename Parameterizer::Solver_traits(), traits, &summary);
  }

  bool start_has(const std::string& text) const { return summary.start.find(text) != std::string::npos; }
};

typedef SMP::Square_border_uniform_parameterizer_3<PolyMesh> Uniform;
typedef SMP::Square_border_arc_length_parameterizer_3<PolyMesh> Arc_length;

} // namespace

BOOST_FIXTURE_TEST_CASE(corners_are_given, Fixture)
{
  // Every side of the square gets a side of the sheet.
  const vertex_descriptor a = vertices[0], b = vertices[11], c = vertices[119], d = vertices[108];
  check(parameterizer(Uniform(a, b, c, d)));
  BOOST_TEST_CONTEXT(summary.start)
  {
    BOOST_TEST(start_has("given border"));
    BOOST_TEST(!start_has("circle"));
  }
  check(parameterizer(Arc_length(a, b, c, d)));
  BOOST_TEST_CONTEXT(summary.start)
  {
    BOOST_TEST(start_has("given border"));
    BOOST_TEST(!start_has("circle"));
  }
}

BOOST_FIXTURE_TEST_CASE(corners_are_chosen, Fixture)
{
  check(parameterizer(Uniform()));
  BOOST_TEST(start_has("given border"));
  check(parameterizer(Arc_length()));
  BOOST_TEST(start_has("given border"));
}

BOOST_FIXTURE_TEST_CASE(default_template_arguments, Fixture)
{
  check(FFM::Flip_free_parameterizer_3<PolyMesh>(&summary));
  BOOST_TEST(start_has("tutte (circle"));
  check(FFM::Flip_free_parameterizer_3<PolyMesh, CGAL::Default, CGAL::Default, CGAL::Default>(&summary));
}

BOOST_FIXTURE_TEST_CASE(triangle_on_one_side, Fixture)
{
  // The sheet's corner at the origin is not a corner of the square, and its triangle has all vertices on the border.
  BOOST_TEST_REQUIRE((soup.triangles[0] == std::array<int, 3>{0, 1, 12}));
  check(parameterizer(Uniform(vertices[4], vertices[11], vertices[119], vertices[108])));
}

// All corners at one end of a strip: most of its triangles are on a single side.
struct Strip : Fixture
{
  Strip() : Fixture(bumpy_soup(6, 1)) {}

  Uniform border() const { return Uniform(vertices[4], vertices[6], vertices[13], vertices[11]); }
};

BOOST_FIXTURE_TEST_CASE(strip_on_one_side, Strip)
{
  // It has no vertex inside, so that it can be laid flat as it is.
  check(parameterizer(border()));
  BOOST_TEST_CONTEXT(summary.start)
  {
    BOOST_TEST(start_has("unfolded"));
    BOOST_TEST(start_has("given border"));
    BOOST_TEST(start_has("flipped"));
  }
}

BOOST_FIXTURE_TEST_CASE(strip_without_fallbacks, Strip)
{
  traits.start.fall_back = false;
  UV_uhm other_uhm(Point_2(7, 7));
  UV_pmap other(other_uhm);
  halfedge_descriptor bhd = CGAL::Polygon_mesh_processing::longest_border(sm).first;
  BOOST_TEST(SMP::parameterize(sm, parameterizer(border()), bhd, other) == SMP::ERROR_NO_1_TO_1_MAPPING);
  BOOST_TEST(FFM::status_name(summary.status) == FFM::status_name(FFM::Status::start_not_flip_free));
  BOOST_TEST(summary.message.find("given border") != std::string::npos);
  for(vertex_descriptor v : vertices)
    BOOST_TEST((other_uhm[v] == Point_2(7, 7)));
}

BOOST_FIXTURE_TEST_CASE(border_parameterizer_that_fails, Fixture)
{
  check(parameterizer(Refusing()));
  BOOST_TEST_CONTEXT(summary.start)
  {
    BOOST_TEST(start_has("circle"));
    BOOST_TEST(start_has("failed"));
  }
}

BOOST_AUTO_TEST_SUITE_END() // test_drop_in_square
