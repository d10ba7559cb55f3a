// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The accounts of all functions: what they print, and what they become as JSON.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/atlas/Packing_options.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/internal/parallel_invoke.h>
#include <CGAL/Flip_free_maps/measure/Distortion_report.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/seams/meet_seam_constraints.h>

#include <CGAL/tags.h>

#if __has_include(<nlohmann/json.hpp>)
#define HAS_JSON
#include <nlohmann/json.hpp>
#endif

#include <atomic>
#include <cstddef>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_summaries)

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;

namespace {

template <typename T>
std::string text(const T& value)
{
  std::ostringstream os;
  os << value;
  return os.str();
}

template <typename Account>
void check_outcome()
{
  Account account;
  const FFM::Outcome& outcome = account;
  account.status = Status::time_limit;
  account.message = "the time is up";
  BOOST_TEST(outcome.is_valid());
  BOOST_TEST(!outcome.is_success());
  BOOST_TEST(text(account).find("time_limit: the time is up\n") == 0u);
  account.status = Status::no_border;
  BOOST_TEST(!account.is_valid());
  BOOST_TEST(text(account).find("no_border: the time is up\n") == 0u);
#ifdef HAS_JSON
  const nlohmann::json json = account;
  BOOST_TEST(json.at("status") == "no_border");
  BOOST_TEST(json.at("message") == "the time is up");
#endif
}

} // namespace

// As programs and scripts know them, in the order that numbers give them.
BOOST_AUTO_TEST_CASE(names_of_statuses)
{
  const std::vector<std::string> names{"success",
                                       "iteration_limit",
                                       "time_limit",
                                       "stopped_by_observer",
                                       "empty_mesh",
                                       "not_triangular",
                                       "no_border",
                                       "several_components",
                                       "not_a_disk",
                                       "non_manifold",
                                       "degenerate_rest_element",
                                       "non_finite_input",
                                       "start_not_flip_free",
                                       "unreachable_constraints",
                                       "linear_solver_failed",
                                       "line_search_failed",
                                       "result_not_representable",
                                       "invalid_option",
                                       "file_error",
                                       "out_of_memory",
                                       "not_planar",
                                       "flips_remain",
                                       "not_bijective",
                                       "interrupted",
                                       "unknown"};
  for(std::size_t i = 0; i < names.size(); ++i) {
    const Status status = static_cast<Status>(i);
    BOOST_TEST(FFM::status_name(status) == names[i]);
    BOOST_TEST(text(status) == names[i]);
    BOOST_TEST(FFM::is_valid_map(status) == (i < 4));
  }
}

BOOST_AUTO_TEST_CASE(status_prints_its_name)
{
  BOOST_TEST(text(Status::success) == "success");
  BOOST_TEST(text(Status::not_bijective) == "not_bijective");
  BOOST_TEST(text(Status::interrupted) == "interrupted");
}

BOOST_AUTO_TEST_CASE(all_accounts_begin_with_how_it_ended)
{
  check_outcome<FFM::Summary>();
  check_outcome<FFM::Seam_summary>();
  check_outcome<FFM::Unwrap_summary>();
  check_outcome<FFM::Chart_summary>();
  check_outcome<FFM::Cut_summary>();
  check_outcome<FFM::Packing_summary>();
  check_outcome<FFM::Distortion_report>();
}

BOOST_AUTO_TEST_CASE(text_holds_what_was_reached)
{
  FFM::Summary summary;
  BOOST_TEST(text(summary) == "invalid_option: not run\n  iterations 0, factorizations 0\n");
  summary.elements = 12;
  summary.vertices = 7;
  summary.flips = 0;
  summary.energy = 1.25;
  summary.is_bijective = true;
  summary.seconds.total = 0.5;
  const std::string lines = text(summary);
  for(const char* entry : {"vertices 7, faces 12, flips 0, bijective yes, energy 1.25", "seconds: load 0, ", "total 0.5\n"})
    BOOST_TEST(lines.find(entry) != std::string::npos, entry);
  BOOST_TEST(lines.find("singular") == std::string::npos);
  summary.dimension = 3;
  BOOST_TEST(text(summary).find("tetrahedra 12") != std::string::npos);
}

#ifdef HAS_JSON
BOOST_AUTO_TEST_CASE(faces_are_no_tetrahedra)
{
  FFM::Summary summary;
  summary.elements = 12;
  nlohmann::json json = summary;
  BOOST_TEST(json.at("faces") == 12);
  BOOST_TEST(json.at("dimension") == 2);
  BOOST_TEST(!json.contains("tetrahedra"));
  summary.dimension = 3;
  json = summary;
  BOOST_TEST(json.at("tetrahedra") == 12);
  BOOST_TEST(json.at("dimension") == 3);
  BOOST_TEST(!json.contains("faces"));
}

BOOST_AUTO_TEST_CASE(what_nobody_asked_is_null)
{
  FFM::Summary summary;
  BOOST_TEST(nlohmann::json(summary).at("bijective").is_null());
  BOOST_TEST(nlohmann::json(summary).at("factorization_units") == 0.);
  summary.is_bijective = false;
  BOOST_TEST(nlohmann::json(summary).at("bijective") == false);
  summary.is_bijective = true;
  BOOST_TEST(nlohmann::json(summary).at("bijective") == true);
  summary.factorizations = 4;
  summary.cpu_seconds = 3;
  summary.factorize_cpu_seconds = 2;
  BOOST_TEST(nlohmann::json(summary).at("factorization_units") == 6.);
  summary.energy_initial = 2.5;
  BOOST_TEST(nlohmann::json(summary).at("energy_initial") == 2.5);
}

// The names that programs read.
BOOST_AUTO_TEST_CASE(json_keeps_its_names)
{
  const nlohmann::json json = FFM::Summary();
  for(const char* name : {"status",         "message",       "converged",
                          "vertices",       "faces",         "iterations",
                          "factorizations", "linear_solves", "inner_iterations",
                          "fallbacks",      "energy",        "energy_evaluations",
                          "energy_initial", "gradient_norm", "energy_of_terms",
                          "flips",          "bijective",     "characteristic_gradient_norm",
                          "cpu_seconds",    "start",         "min_singular_value",
                          "factor_entries", "ordering",      "max_singular_value",
                          "linear_solver",  "energy_name",   "factorize_cpu_seconds",
                          "preconditioner", "reference",     "peak_memory_mb",
                          "acceleration"})
    BOOST_TEST(json.contains(name), name);
  for(const char* name : {"load", "start", "assemble", "analyze", "factorize", "solve", "line_search", "certify", "total"})
    BOOST_TEST(json.at("seconds").contains(name), name);

  FFM::Unwrap_summary atlas;
  atlas.charts.resize(2);
  atlas.charts[1].faces = 5;
  atlas.cut_seconds = 0.25;
  atlas.cut.genus = 3;
  const nlohmann::json unwrapped = atlas;
  BOOST_TEST(unwrapped.at("number_of_charts") == 2);
  BOOST_TEST(unwrapped.at("charts").at(1).at("faces") == 5);
  BOOST_TEST(unwrapped.at("charts").at(0).at("status") == "success");
  BOOST_TEST(unwrapped.at("seconds").at("cut") == 0.25);
  BOOST_TEST(unwrapped.at("cut").at("genus") == 3);
}

BOOST_AUTO_TEST_CASE(seams_are_part_of_their_account)
{
  FFM::Seam_summary summary;
  summary.residual = 0.125;
  summary.transformations = {{0., 1.}, {-1., 0.}};
  const nlohmann::json json = summary;
  BOOST_TEST(json.at("residual") == 0.125);
  BOOST_TEST(json.at("transformations") == nlohmann::json::parse("[[0.0, 1.0], [-1.0, 0.0]]"));
  BOOST_TEST(json.contains("iterations"));
}
#endif

// What other threads of the process do is not of the call, what tasks of the call do is, and once only.
BOOST_AUTO_TEST_CASE(cpu_seconds_are_those_of_the_call)
{
  using namespace FFM::internal;
  const auto burn = [](double seconds) {
    const double begin = thread_cpu_seconds();
    while(thread_cpu_seconds() - begin < seconds) {}
  };
  std::atomic<bool> is_done{false};
  double others = 0;
  std::thread other([&] {
    while(!is_done)
      burn(0.001);
    others = thread_cpu_seconds();
  });
  double wall = 0, cpu = 0;
  {
    const Phase_timer timer(wall, &cpu);
    for_each_index<CGAL::Parallel_if_available_tag>(4, [&](std::size_t) {
      burn(0.01);
      for_each_index<CGAL::Parallel_if_available_tag>(4, [&](std::size_t) { burn(0.005); });
    });
    parallel_invoke<CGAL::Parallel_if_available_tag>([&] { burn(0.02); }, [&] { burn(0.02); });
  }
  is_done = true;
  other.join();
  BOOST_TEST(cpu >= 0.16 * 0.999);
  BOOST_TEST(cpu < 0.16 + 0.5 * others);
}

BOOST_AUTO_TEST_SUITE_END() // test_summaries
