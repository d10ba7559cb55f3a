// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_IMPL_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_IMPL_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Petsc_scope.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Mpi_world::Mpi_world(MPI_Comm comm) : m_state(std::make_shared<State>())
{
  MPI_Comm_dup(comm, &m_state->comm);
  MPI_Comm_rank(m_state->comm, &m_state->rank);
  MPI_Comm_size(m_state->comm, &m_state->size);
  // All processes have to be there when PETSc is initialised, which it will be when one of them needs it.
  const internal::Petsc_scope scope;
}

CGAL_FLIP_FREE_MAPS_INLINE Mpi_world::State::~State()
{
  int is_over = 0;
  if(comm != MPI_COMM_NULL && MPI_Finalized(&is_over) == MPI_SUCCESS && is_over == 0)
    MPI_Comm_free(&comm);
}

CGAL_FLIP_FREE_MAPS_INLINE void Mpi_world::set_part(Part part)
{
  m_state->part = std::move(part);
  std::vector<std::int32_t> numbers(m_state->part.global_numbers.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  number_unknowns(numbers);
  m_state->vertex_links = m_state->unknown_links;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Mpi_world::Message> Mpi_world::all(double value, Status failure, const char* what) const
{
  std::vector<Message> messages(m_state->size);
  const Message own{value, static_cast<double>(failure)};
  MPI_Allgather(&own, 2, MPI_DOUBLE, messages.data(), 2, MPI_DOUBLE, m_state->comm);
  double worst = 0;
  for(const Message& message : messages)
    worst = (std::max)(worst, message.failure);
  const Status status = static_cast<Status>(static_cast<int>(worst));
  if(status == Status::success)
    return messages;
  if(status == Status::time_limit || status == Status::stopped_by_observer)
    throw Common_interruption(status);
  if(status == Status::out_of_memory)
    throw Common_bad_alloc();
  throw Common_exception(what != nullptr ? what : "another rank has failed");
}

CGAL_FLIP_FREE_MAPS_INLINE double Mpi_world::sum(double x) const
{
  double result = 0;
  for(const Message& message : all(x))
    result += message.value;
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE double Mpi_world::minimum(double x) const
{
  double result = std::numeric_limits<double>::infinity();
  for(const Message& message : all(x))
    result = message.value < result ? message.value : result;
  return result;
}

CGAL_FLIP_FREE_MAPS_INLINE int Mpi_world::maximum(int x) const { return -static_cast<int>(minimum(-x)); }

CGAL_FLIP_FREE_MAPS_INLINE double Mpi_world::norm(const Eigen::VectorXd& a) const { return std::sqrt(sum(a.squaredNorm())); }

CGAL_FLIP_FREE_MAPS_INLINE void Mpi_world::number_unknowns(const std::vector<std::int32_t>& numbers)
{
  State& state = *m_state;
  const auto is_unknown = [&](std::int32_t v) { return numbers[v] >= 0; };
  state.owned_unknowns = static_cast<std::int32_t>(
    std::count_if(numbers.begin(), numbers.begin() + state.part.owned_vertices, [](std::int32_t number) { return number >= 0; }));
  state.local_unknowns = state.owned_unknowns;
  state.unknown_links.clear();
  for(const Neighbor& neighbor : state.part.neighbors) {
    Link link{neighbor.rank, {}, state.local_unknowns, 0};
    for(std::int32_t v : neighbor.owned)
      if(is_unknown(v))
        link.owned.push_back(numbers[v]);
    link.ghosts = static_cast<std::int32_t>(std::count_if(neighbor.ghosts.begin(), neighbor.ghosts.end(), is_unknown));
    state.local_unknowns += link.ghosts;
    state.unknown_links.push_back(std::move(link));
  }
  const std::vector<Message> owned = all(state.owned_unknowns);
  double first = 0;
  for(int r = 0; r < state.rank; ++r)
    first += owned[r].value;
  Eigen::VectorXd own(state.owned_unknowns);
  for(std::int32_t i = 0; i < state.owned_unknowns; ++i)
    own[i] = first + i;
  const Eigen::VectorXd& extended = with_ghosts(own);
  state.global_unknowns.assign(extended.data(), extended.data() + extended.size());
}

CGAL_FLIP_FREE_MAPS_INLINE const Eigen::VectorXd& Mpi_world::with_ghosts(const Eigen::VectorXd& owned) const
{
  State& state = *m_state;
  // A rank without unknowns of its own has to learn from the others how many coordinates there are.
  const int block = maximum(state.owned_unknowns > 0 ? static_cast<int>(owned.size() / state.owned_unknowns) : 1);
  state.extended.resize(Eigen::Index(block) * state.local_unknowns);
  state.extended.head(owned.size()) = owned;
  refresh(state.unknown_links, block, state.extended.data());
  return state.extended;
}

CGAL_FLIP_FREE_MAPS_INLINE void Mpi_world::keep_owned(Eigen::VectorXd& vector) const
{
  const State& state = *m_state;
  if(state.local_unknowns > 0)
    vector.conservativeResize(vector.size() / state.local_unknowns * state.owned_unknowns);
}

CGAL_FLIP_FREE_MAPS_INLINE void Mpi_world::refresh(const std::vector<Link>& links, int block, double* entries) const
{
  State& state = *m_state;
  std::size_t sent = 0;
  for(const Link& link : links)
    sent += link.owned.size() * block;
  state.sent.resize(sent);
  std::vector<MPI_Request> requests;
  for(const Link& link : links) {
    requests.emplace_back();
    MPI_Irecv(entries + std::size_t(block) * link.first_ghost, block * link.ghosts, MPI_DOUBLE, link.rank, 0, state.comm, &requests.back());
  }
  double* next = state.sent.data();
  for(const Link& link : links) {
    double* const first = next;
    for(std::int32_t i : link.owned)
      for(int k = 0; k < block; ++k)
        *next++ = entries[std::size_t(block) * i + k];
    requests.emplace_back();
    MPI_Isend(first, static_cast<int>(next - first), MPI_DOUBLE, link.rank, 0, state.comm, &requests.back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_IMPL_H
