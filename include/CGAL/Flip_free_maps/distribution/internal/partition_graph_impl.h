// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/internal/partition_graph.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#endif

#include <petscmat.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// An array that PETSc takes over.
template <typename T>
PetscInt* array_for_petsc(const std::vector<T>& numbers)
{
  PetscInt* array = nullptr;
  if(!succeeded(PetscMalloc1(numbers.size() + 1, &array)))
    throw std::bad_alloc();
  std::transform(numbers.begin(), numbers.end(), array, [](T number) { return static_cast<PetscInt>(number); });
  return array;
}

// As long as this lives, Scotch has one thread, since several find other parts each time, and draws the same random numbers as in
// other calls. The number of threads it takes from the environment alone.
class Single_thread_of_scotch
{
public:
  Single_thread_of_scotch()
  {
    const char* const value = std::getenv(NAME);
    m_had_value = value != nullptr;
    if(m_had_value)
      m_value = value;
    set("1");
    restart_random_numbers();
  }

  ~Single_thread_of_scotch() { set(m_had_value ? m_value.c_str() : nullptr); }

  Single_thread_of_scotch(const Single_thread_of_scotch&) = delete;
  Single_thread_of_scotch& operator=(const Single_thread_of_scotch&) = delete;

private:
  static constexpr const char* NAME = "SCOTCH_PTHREAD_NUMBER";

  static void set(const char* value)
  {
#if defined(__unix__) || defined(__APPLE__)
    static_cast<void>(value != nullptr ? setenv(NAME, value, 1) : unsetenv(NAME));
#else
    static_cast<void>(value);
#endif
  }

  static void restart_random_numbers()
  {
#if defined(__unix__) || defined(__APPLE__)
    // PETSc need not have been built with it.
    if(void* const reset = dlsym(RTLD_DEFAULT, "SCOTCH_randomReset"))
      reinterpret_cast<void (*)()>(reset)();
#endif
  }

  bool m_had_value = false;
  std::string m_value;
};

inline bool partition_with_petsc(const Graph_slice& graph, int number_of_parts, std::vector<std::int32_t>& parts)
{
  const PetscInt n = static_cast<PetscInt>(graph.weights.size());
  Petsc_handle<Mat, MatDestroy> adjacency;
  Petsc_handle<MatPartitioning, MatPartitioningDestroy> partitioning;
  Petsc_handle<IS, ISDestroy> result;
  if(!succeeded(MatCreateMPIAdj(PETSC_COMM_SELF, n, n, array_for_petsc(graph.begin), array_for_petsc(graph.neighbors), nullptr,
                                adjacency.receive())) ||
     !succeeded(MatPartitioningCreate(PETSC_COMM_SELF, partitioning.receive())) ||
     !succeeded(MatPartitioningSetAdjacency(partitioning, adjacency)) ||
     !succeeded(MatPartitioningSetNParts(partitioning, number_of_parts)) ||
     !succeeded(MatPartitioningSetVertexWeights(partitioning, array_for_petsc(graph.weights))))
    return false;
#ifdef PETSC_HAVE_PTSCOTCH
  if(!succeeded(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH)))
    return false;
#endif
  const Single_thread_of_scotch single_thread;
  const PetscInt* numbers = nullptr;
  if(!succeeded(MatPartitioningApply(partitioning, result.receive())) || !succeeded(ISGetIndices(result, &numbers)))
    return false;
  parts.assign(numbers, numbers + n);
  return succeeded(ISRestoreIndices(result, &numbers));
}

// What each rank has of an array, one after the other, on the first rank.
template <typename T>
std::vector<T> gather_at_first(const std::vector<T>& part, const Mpi_world& world)
{
  std::vector<std::vector<T>> parts(world.size());
  parts.front() = part;
  std::vector<T> result;
  for(const std::vector<T>& numbers : world.exchange(parts))
    result.insert(result.end(), numbers.begin(), numbers.end());
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE bool partition_graph(const Graph_slice& graph, const Mpi_world& world, std::vector<std::int32_t>& parts)
{
  parts.assign(graph.weights.size(), 0);
  if(world.size() == 1)
    return true;
  const std::vector<std::int64_t> sizes = world.gather(std::vector<std::int64_t>(1, static_cast<std::int64_t>(parts.size())));
  std::vector<std::int64_t> degrees;
  for(std::size_t v = 0; v < parts.size(); ++v)
    degrees.push_back(graph.begin[v + 1] - graph.begin[v]);
  Graph_slice whole;
  whole.weights = gather_at_first(graph.weights, world);
  whole.neighbors = gather_at_first(graph.neighbors, world);
  whole.begin.assign(1, 0);
  for(const std::int64_t degree : gather_at_first(degrees, world))
    whole.begin.push_back(whole.begin.back() + degree);
  bool succeeds = whole.neighbors.size() <= static_cast<std::size_t>(PETSC_MAX_INT);
  std::vector<std::int32_t> all_parts;
  if(succeeds && world.rank() == 0) {
    const Petsc_scope scope;
    succeeds = scope.is_ready() && partition_with_petsc(whole, world.size(), all_parts);
  }
  if(world.any(!succeeds))
    return false;
  std::vector<std::vector<std::int32_t>> answers(world.size());
  if(world.rank() == 0) {
    std::size_t begin = 0;
    for(int r = 0; r < world.size(); begin += sizes[r++])
      answers[r].assign(all_parts.begin() + begin, all_parts.begin() + begin + sizes[r]);
  }
  parts = world.exchange(answers).front();
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_INTERNAL_PARTITION_GRAPH_IMPL_H
