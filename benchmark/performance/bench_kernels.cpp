// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What one iteration is made of, each part alone, on generated maps of 5000 and 50000 triangles. Counters say how many elements
// (or matrices) go through in a second.

#include "../support/generated_shapes.h"
#include "../support/machine.h"

#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Map_objective.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>
#include <CGAL/Flip_free_maps/preconditioners/Vertex_space_newton.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace benchmark_support;
using D = CGAL::Default;

namespace {

// A rectangle, and a map of it that bends and stretches every triangle.
struct Problem
{
  explicit Problem(std::int64_t triangles)
  {
    const int rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 4)));
    Planar_shape shape = make_rectangle(2 * rows, rows, 0.2);
    domain = shape.domain;
    rest = shape.x;
    x = rest;
    for(Eigen::Index v = 0; v < x.cols(); ++v)
      x.col(v) << 1.3 * rest(0, v) + 0.2 * std::sin(3 * rest(1, v)), 0.8 * rest(1, v) + 0.15 * std::sin(4 * rest(0, v));
  }

  FFM::Simplicial_domain<2> domain;
  FFM::Positions<2> rest, x;
};

template <typename Preconditioner>
using Traits = FFM::Flip_free_map_traits<D, D, Preconditioner, D, D, FFM::No_acceleration, FFM::Every_iteration, CGAL::Sequential_tag>;

template <typename Preconditioner>
struct Objective
{
  explicit Objective(std::int64_t triangles) : problem(triangles), function(problem.domain, traits.energy, traits.preconditioner)
  {
    function.build_pattern();
  }

  Problem problem;
  Traits<Preconditioner> traits;
  FFM::internal::Map_objective<2, Traits<Preconditioner>> function;
  Eigen::VectorXd gradient;
};

void count(benchmark::State& state, std::int64_t number) { state.SetItemsProcessed(state.iterations() * number); }

template <int dimension>
void signed_svd(benchmark::State& state)
{
  std::mt19937_64 generator(1);
  std::vector<FFM::internal::Matrix<dimension>> matrices(1000);
  for(auto& matrix : matrices)
    for(Eigen::Index i = 0; i < matrix.size(); ++i)
      matrix.data()[i] = static_cast<double>(generator() >> 11) / 4503599627370496. - 1;
  FFM::internal::Signed_svd<dimension> svd;
  for(auto _ : state)
    for(const auto& matrix : matrices) {
      FFM::internal::signed_svd(matrix, svd);
      benchmark::DoNotOptimize(svd);
    }
  count(state, matrices.size());
}

void energy_value(benchmark::State& state)
{
  const Objective<FFM::Slim> objective(state.range(0));
  for(auto _ : state)
    benchmark::DoNotOptimize(objective.function.energy(objective.traits.reference, objective.problem.x));
  count(state, objective.problem.domain.number_of_elements());
}

template <typename Preconditioner, bool with_matrix>
void derivatives(benchmark::State& state)
{
  Objective<Preconditioner> objective(state.range(0));
  for(auto _ : state) {
    objective.function.derivatives(objective.traits.reference, objective.problem.x, with_matrix, objective.gradient);
    benchmark::ClobberMemory();
  }
  count(state, objective.problem.domain.number_of_elements());
}

void largest_step(benchmark::State& state)
{
  const Objective<FFM::Slim> objective(state.range(0));
  const FFM::Positions<2> direction = objective.problem.rest - objective.problem.x;
  for(auto _ : state)
    benchmark::DoNotOptimize(objective.function.largest_step(objective.problem.x, direction));
  count(state, objective.problem.domain.number_of_elements());
}

void exact_flips(benchmark::State& state)
{
  const Objective<FFM::Slim> objective(state.range(0));
  for(auto _ : state)
    benchmark::DoNotOptimize(FFM::internal::count_flips<Traits<FFM::Slim>::Kernel, CGAL::Sequential_tag>(
      objective.problem.domain, objective.function.schedule(), objective.problem.x));
  count(state, objective.problem.domain.number_of_elements());
}

// The matrix of projected Newton, with one vertex held.
struct Linear_system
{
  explicit Linear_system(std::int64_t triangles) : objective(triangles)
  {
    objective.function.derivatives(objective.traits.reference, objective.problem.x, true, objective.gradient);
    FFM::Block_sparse_matrix& m = matrix();
    for(int i = 0; i < 2; ++i)
      m.diagonal(i) *= 2;
    for(FFM::Block_sparse_matrix::Index i = 0; i < m.rows(); ++i)
      m.diagonal(i) *= 1 + 1e-9;
  }
  FFM::Block_sparse_matrix& matrix() { return objective.function.matrix(); }

  Objective<FFM::Projected_newton> objective;
};

template <typename Solver>
void analyze(benchmark::State& state)
{
  Linear_system system(state.range(0));
  Solver solver;
  for(auto _ : state)
    benchmark::DoNotOptimize(solver.analyze_pattern(system.matrix()));
  count(state, 1);
}

template <typename Solver>
void factorize(benchmark::State& state)
{
  Linear_system system(state.range(0));
  Solver solver;
  if(!solver.analyze_pattern(system.matrix())) {
    state.SkipWithError("the pattern was not analysed");
    return;
  }
  for(auto _ : state)
    if(!solver.factorize(system.matrix())) {
      state.SkipWithError("not factorized");
      break;
    }
  state.counters["factor_entries"] = static_cast<double>(solver.factor_entries());
  count(state, 1);
}

template <typename Solver>
void solve(benchmark::State& state)
{
  Linear_system system(state.range(0));
  Solver solver;
  if(!solver.analyze_pattern(system.matrix()) || !solver.factorize(system.matrix())) {
    state.SkipWithError("not factorized");
    return;
  }
  Eigen::VectorXd solution;
  for(auto _ : state)
    benchmark::DoNotOptimize(solver.solve(system.objective.gradient, solution));
  count(state, 1);
}

void sizes(benchmark::internal::Benchmark* b) { b->Arg(5000)->Arg(50000)->ArgName("triangles")->Unit(benchmark::kMillisecond); }

} // namespace

BENCHMARK_TEMPLATE(signed_svd, 2);
BENCHMARK_TEMPLATE(signed_svd, 3);
BENCHMARK(energy_value)->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Slim, false)->Name("gradient")->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Slim, true)->Name("gradient_and_matrix/slim")->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Killing, true)->Name("gradient_and_matrix/killing")->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Composite_majorization<>, true)->Name("gradient_and_matrix/cm")->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Projected_newton, true)->Name("gradient_and_matrix/projected_newton")->Apply(sizes);
BENCHMARK_TEMPLATE(derivatives, FFM::Vertex_space_newton, true)->Name("gradient_and_matrix/vertex_space_newton")->Apply(sizes);
BENCHMARK(largest_step)->Apply(sizes);
BENCHMARK(exact_flips)->Apply(sizes);
BENCHMARK_TEMPLATE(analyze, FFM::Eigen_simplicial_solver)->Name("analyze/eigen")->Apply(sizes);
BENCHMARK_TEMPLATE(factorize, FFM::Eigen_simplicial_solver)->Name("factorize/eigen")->Apply(sizes);
BENCHMARK_TEMPLATE(solve, FFM::Eigen_simplicial_solver)->Name("solve/eigen")->Apply(sizes);
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
BENCHMARK_TEMPLATE(analyze, FFM::Cholmod_solver)->Name("analyze/cholmod")->Apply(sizes);
BENCHMARK_TEMPLATE(factorize, FFM::Cholmod_solver)->Name("factorize/cholmod")->Apply(sizes);
BENCHMARK_TEMPLATE(solve, FFM::Cholmod_solver)->Name("solve/cholmod")->Apply(sizes);
#endif

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::AddCustomContext("machine", machine());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
