// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Solids and surfaces in parts over the ranks of MPI: the same maps as in one process, the same bits each time, and failures that end all ranks.
// The suite runs in one process, and over several ranks where there is a program to start them.

#include "support/unit_test.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include "support/generated_domains.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/deform_volume_over_mpi.h>
#include <CGAL/Flip_free_maps/distribution/Distributed_volume_domain.h>
#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/parameterize_over_mpi.h>

#include <mpi.h>
#include <petscsys.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#endif

BOOST_AUTO_TEST_SUITE(test_over_mpi)

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

namespace FFM = CGAL::Flip_free_maps;
namespace FFP = CGAL::Flip_free_maps::parameters;
using namespace test_support;

namespace {

typedef std::array<double, 3> Point;

// MPI from the first case to the end of the program.
struct Mpi
{
  Mpi()
  {
    static const Session session;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
  }

  struct Session
  {
    Session() { MPI_Init(nullptr, nullptr); }
    ~Session()
    {
      if(PetscInitializeCalled && !PetscFinalizeCalled)
        PetscFinalize();
      MPI_Finalize();
    }
  };

  int rank = 0, size = 1;
};

// What one rank of several has of a range.
template <typename T>
std::vector<T> slice_of(const std::vector<T>& all, const Mpi& mpi)
{
  return std::vector<T>(all.begin() + all.size() * mpi.rank / mpi.size, all.begin() + all.size() * (mpi.rank + 1) / mpi.size);
}

// A bar whose ends are handles: the first stays, the other is where the bar would end if it were bent along an arc of `angle`.
struct Bar
{
  std::vector<Point> points;
  std::vector<std::array<std::int64_t, 4>> tetrahedra;
  std::vector<std::pair<std::int64_t, Point>> handles;

  Bar(int length, int width, double angle)
  {
    const Volume volume = bar(length, width, width, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p + Eigen::Vector3d(1, 2, 3)); });
    for(const auto& t : volume.tetrahedra)
      tetrahedra.push_back({t[0], t[1], t[2], t[3]});
    for(const auto& p : volume.points) {
      const std::int64_t v = static_cast<std::int64_t>(points.size());
      points.push_back({p[0], p[1], p[2]});
      const double arm = p[2] - 3 - 0.5 * width, radius = length / angle;
      if(p[0] == 1)
        handles.push_back({v, points.back()});
      if(p[0] == 1 + length)
        handles.push_back({v, {1 + (radius - arm) * std::sin(angle), p[1], 3 + 0.5 * width + radius - (radius - arm) * std::cos(angle)}});
    }
  }
};

FFM::Map_traits_over_mpi tight_traits()
{
  FFM::Map_traits_over_mpi traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  return traits;
}

struct Deformed
{
  FFM::Summary summary;
  std::vector<Point> slice;

  template <typename NamedParameters>
  Deformed(const Bar& bar, const Mpi& mpi, const NamedParameters& np)
  {
    summary = FFM::deform_volume_over_mpi(MPI_COMM_WORLD, slice_of(bar.points, mpi), slice_of(bar.tetrahedra, mpi),
                                          slice_of(bar.handles, mpi), slice, np);
  }

  // The points of all ranks, on each of them.
  std::vector<Point> all() const { return FFM::Mpi_world(MPI_COMM_WORLD).gather(slice); }
};

} // namespace

BOOST_AUTO_TEST_CASE(every_tetrahedron_is_counted_once, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(12, 4, 1);
  const FFM::Mpi_world world(MPI_COMM_WORLD);
  FFM::Distributed_volume_domain volume(world);
  const std::vector<Point> slice = slice_of(bar.points, mpi);
  FFM::Positions<3> points(3, slice.size());
  for(std::size_t i = 0; i < slice.size(); ++i)
    points.col(i) << slice[i][0], slice[i][1], slice[i][2];
  std::string message;
  BOOST_TEST_REQUIRE((volume.load(points, slice_of(bar.tetrahedra, mpi), {}, message) == FFM::Status::success), message);
  const FFM::Simplicial_domain<3>& domain = volume.domain();
  BOOST_TEST(world.sum(world.counted_elements(domain.number_of_elements())) == double(bar.tetrahedra.size()));
  BOOST_TEST(world.sum(world.owned_vertices(domain.number_of_vertices)) == double(bar.points.size()));
  BOOST_TEST(volume.number_of_components() == 1);
  double volume_of_counted = 0;
  for(std::int64_t e = 0; e < world.counted_elements(domain.number_of_elements()); ++e)
    volume_of_counted += domain.measures[e];
  BOOST_TEST(std::abs(world.sum(volume_of_counted) - 1) <= 1e-12);
  // Ghosts are those of their owners, and slices come back as they were.
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v) {
    const Point& p = bar.points[volume.vertices()[v]];
    BOOST_TEST((volume.from_domain(domain.rest_points.col(v)) - Eigen::Vector3d(p[0], p[1], p[2])).norm() <= 1e-12);
  }
  FFM::Positions<3> back = FFM::Positions<3>::Zero(3, points.cols());
  volume.to_slices(volume.to_parts(points), back);
  BOOST_TEST((back == points));
}

BOOST_AUTO_TEST_CASE(parts_without_common_vertices_are_refused, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  Bar bar(6, 2, 1);
  const Bar other(6, 2, 1);
  const std::int64_t n = static_cast<std::int64_t>(bar.points.size());
  for(auto t : other.tetrahedra) {
    for(std::int64_t& v : t)
      v += n;
    bar.tetrahedra.push_back(t);
  }
  for(Point p : other.points) {
    p[1] += 10;
    bar.points.push_back(p);
  }
  const Deformed deformed(bar, mpi, FFP::map_traits(tight_traits()));
  BOOST_TEST(deformed.summary.status == FFM::Status::several_components);
  BOOST_TEST(deformed.slice.empty());
}

BOOST_AUTO_TEST_CASE(the_energy_is_that_of_one_process, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(16, 4, 1.2);
  FFM::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  std::vector<Point> expected;
  const FFM::Summary alone = FFM::deform_volume(bar.points, bar.tetrahedra, bar.handles, expected, FFP::map_traits(traits));
  BOOST_TEST_REQUIRE(alone.converged());

  const Deformed deformed(bar, mpi, FFP::map_traits(tight_traits()));
  BOOST_TEST_REQUIRE(deformed.summary.converged(), deformed.summary.message);
  BOOST_TEST(std::abs(deformed.summary.energy - alone.energy) <= 1e-9 * alone.energy);
  BOOST_TEST(deformed.summary.flips == 0);
  BOOST_TEST(deformed.summary.elements == std::int64_t(bar.tetrahedra.size()));
  BOOST_TEST(deformed.summary.vertices == std::int64_t(bar.points.size()));

  // The whole map, measured by one process.
  const std::vector<Point> all = deformed.all();
  BOOST_TEST_REQUIRE(all.size() == bar.points.size());
  FFM::Tetrahedral_domain volume;
  std::string message;
  BOOST_TEST_REQUIRE((volume.load(bar.points, bar.tetrahedra, message) == FFM::Status::success));
  FFM::Positions<3> x(3, all.size());
  double distance = 0;
  for(std::size_t v = 0; v < all.size(); ++v) {
    x.col(v) = volume.to_domain(Eigen::Vector3d(all[v][0], all[v][1], all[v][2]));
    for(int i = 0; i < 3; ++i)
      distance = (std::max)(distance, std::abs(all[v][i] - expected[v][i]));
  }
  const FFM::Map_measure<3> measure(volume.domain());
  BOOST_TEST(measure.number_of_flips(x) == 0);
  BOOST_TEST(std::abs(measure.mean_energy(FFM::Symmetric_dirichlet(), x) - alone.energy) <= 1e-9 * alone.energy);
  BOOST_TEST(distance <= 1e-3);
  for(const auto& handle : bar.handles)
    BOOST_TEST((all[handle.first] == handle.second));
}

BOOST_AUTO_TEST_CASE(the_bits_are_the_same_each_time, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(16, 4, 1.8);
  const Deformed first(bar, mpi, CGAL::parameters::default_values()), second(bar, mpi, CGAL::parameters::default_values());
  BOOST_TEST_REQUIRE((first.summary.converged() && second.summary.converged()));
  BOOST_TEST((first.slice == second.slice));
  BOOST_TEST(first.summary.energy == second.summary.energy);
}

BOOST_AUTO_TEST_CASE(a_start_in_slices_is_taken, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(16, 4, 1.2);
  const Deformed first(bar, mpi, FFP::map_traits(tight_traits()));
  BOOST_TEST_REQUIRE(first.summary.converged());
  FFM::Deform_volume_options options;
  options.start.resize(3, first.slice.size());
  for(std::size_t i = 0; i < first.slice.size(); ++i)
    options.start.col(i) << first.slice[i][0], first.slice[i][1], first.slice[i][2];
  const Deformed again(bar, mpi, FFP::volume_options(options, FFP::map_traits(tight_traits())));
  BOOST_TEST_REQUIRE(again.summary.converged());
  BOOST_TEST(again.summary.start == "given");
  BOOST_TEST(again.summary.iterations <= 2);
  BOOST_TEST(std::abs(again.summary.energy - first.summary.energy) <= 1e-9 * first.summary.energy);
}

BOOST_AUTO_TEST_CASE(what_looks_at_the_whole_mesh_is_refused, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  Bar bar(6, 2, 1);
  const auto status_with = [&](auto&& change) {
    FFM::Map_traits_over_mpi traits = tight_traits();
    FFM::Deform_volume_options options;
    change(traits.options, options);
    const Deformed deformed(bar, mpi, FFP::volume_options(options, FFP::map_traits(traits)));
    BOOST_TEST(deformed.slice.empty());
    BOOST_TEST(!deformed.summary.message.empty());
    return deformed.summary.status;
  };
  BOOST_TEST(status_with([](auto& map, auto&) { map.free_blocked_vertices = true; }) == FFM::Status::invalid_option);
  BOOST_TEST(status_with([](auto& map, auto&) { map.renew_factorization = true; }) == FFM::Status::invalid_option);
  BOOST_TEST(status_with([](auto&, auto& volume) { volume.soft_weight = 1; }) == FFM::Status::invalid_option);
  bar.tetrahedra[5][1] = 100000;
  BOOST_TEST(status_with([](auto&, auto&) {}) == FFM::Status::invalid_option);
}

BOOST_AUTO_TEST_CASE(a_rank_that_fails_ends_all, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(12, 4, 1.2);
  // Only the last rank observes.
  const auto status_with = [&](std::function<bool(const FFM::Iteration_report&)> observer) {
    FFM::Map_traits_over_mpi traits = tight_traits();
    if(mpi.rank == mpi.size - 1)
      traits.options.observer = observer;
    return Deformed(bar, mpi, FFP::map_traits(traits)).summary.status;
  };
  BOOST_TEST(status_with([](const FFM::Iteration_report& report) -> bool {
               if(report.iteration > 0)
                 throw std::runtime_error("the observer has seen enough");
               return true;
             }) == FFM::Status::interrupted);
  BOOST_TEST(status_with([](const FFM::Iteration_report& report) -> bool {
               if(report.iteration > 0)
                 throw std::bad_alloc();
               return true;
             }) == FFM::Status::out_of_memory);
  BOOST_TEST(status_with([](const FFM::Iteration_report&) { return false; }) == FFM::Status::stopped_by_observer);
}

BOOST_AUTO_TEST_CASE(the_time_of_one_rank_holds_for_all, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Bar bar(20, 6, 1.8);
  FFM::Map_traits_over_mpi traits = tight_traits();
  traits.options.characteristic_gradient_tolerance = 0;
  if(mpi.rank == mpi.size - 1)
    traits.options.max_seconds = 0.5;
  const Deformed deformed(bar, mpi, FFP::map_traits(traits));
  const double status = static_cast<double>(deformed.summary.status);
  const FFM::Mpi_world world(MPI_COMM_WORLD);
  BOOST_TEST(world.minimum(status) == -world.minimum(-status));
  BOOST_TEST((deformed.summary.status != FFM::Status::out_of_memory && deformed.summary.status != FFM::Status::invalid_option));
}

namespace {

typedef std::array<double, 2> Place;

// A sheet with hills, which is curved.
struct Sheet
{
  std::vector<Point> points;
  std::vector<std::array<std::int64_t, 3>> triangles;

  explicit Sheet(int size)
  {
    const Surface surface =
      grid(size, size, [](double u, double v) { return Eigen::Vector3d(u, v, 0.3 * std::sin(6 * u) * std::cos(5 * v)); });
    for(const auto& p : surface.points)
      points.push_back({p[0], p[1], p[2]});
    for(const auto& t : surface.triangles)
      triangles.push_back({std::int64_t(t[0]), std::int64_t(t[1]), std::int64_t(t[2])});
  }
};

struct Flattened
{
  FFM::Summary summary;
  std::vector<Place> slice;

  template <typename NamedParameters>
  Flattened(const Sheet& sheet, const Mpi& mpi, const NamedParameters& np)
  {
    summary = FFM::parameterize_over_mpi(MPI_COMM_WORLD, slice_of(sheet.points, mpi), slice_of(sheet.triangles, mpi), slice, np);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_surface_is_flattened_to_the_energy_of_one_process, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Sheet sheet(24);
  FFM::Flip_free_map_traits<> traits;
  traits.options.characteristic_gradient_tolerance = 1e-9;
  std::vector<Place> expected;
  const FFM::Summary alone = FFM::parameterize(sheet.points, sheet.triangles, expected, FFP::map_traits(traits));
  BOOST_TEST_REQUIRE(alone.converged());

  const Flattened first(sheet, mpi, FFP::map_traits(tight_traits())), second(sheet, mpi, FFP::map_traits(tight_traits()));
  BOOST_TEST_REQUIRE(first.summary.converged(), first.summary.message);
  BOOST_TEST(first.summary.start == "tutte (circle, uniform)");
  BOOST_TEST(std::abs(first.summary.energy - alone.energy) <= 1e-9 * alone.energy);
  BOOST_TEST(first.summary.flips == 0);
  BOOST_TEST(first.summary.elements == std::int64_t(sheet.triangles.size()));
  BOOST_TEST((first.slice == second.slice));

  // The whole map in one process: no flips, and the same from there.
  const std::vector<Place> all = FFM::Mpi_world(MPI_COMM_WORLD).gather(first.slice);
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  std::int64_t flips = 0;
  for(const auto& t : sheet.triangles) {
    const auto point = [&](int k) { return Kernel::Point_2(all[t[k]][0], all[t[k]][1]); };
    flips += CGAL::orientation(point(0), point(1), point(2)) == CGAL::POSITIVE ? 0 : 1;
  }
  BOOST_TEST(flips == 0);
  const Flattened again(sheet, mpi, FFP::start_map(first.slice, FFP::map_traits(tight_traits())));
  BOOST_TEST_REQUIRE(again.summary.converged());
  BOOST_TEST(again.summary.start == "given");
  BOOST_TEST(again.summary.iterations <= 2);
  BOOST_TEST(std::abs(again.summary.energy - alone.energy) <= 1e-9 * alone.energy);
}

BOOST_AUTO_TEST_CASE(what_is_no_disk_is_refused, *boost::unit_test::label("needs_petsc"))
{
  const Mpi mpi;
  const Sheet sheet(12);
  const auto status_of = [&](auto&& change) {
    Sheet changed = sheet;
    change(changed.triangles);
    const Flattened flattened(changed, mpi, CGAL::parameters::default_values());
    BOOST_TEST(flattened.slice.empty());
    return flattened.summary.status;
  };
  BOOST_TEST(status_of([](auto& triangles) { triangles.clear(); }) == FFM::Status::empty_mesh);
  BOOST_TEST(status_of([](auto& triangles) { triangles.push_back(triangles[7]); }) == FFM::Status::non_manifold);
  BOOST_TEST(status_of([](auto& triangles) { triangles[7][1] = 1000000; }) == FFM::Status::invalid_option);
  // Without a triangle inside there is a hole.
  BOOST_TEST(status_of([](auto& triangles) { triangles.erase(triangles.begin() + triangles.size() / 2 + 12); }) == FFM::Status::not_a_disk);
}

#else
BOOST_AUTO_TEST_CASE(petsc, *boost::unit_test::label("needs_petsc")) { test_support::skip_case("built without PETSc"); }
#endif

BOOST_AUTO_TEST_SUITE_END() // test_over_mpi
