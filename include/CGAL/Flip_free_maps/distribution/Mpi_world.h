// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_H
#define CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_H

#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC

#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <Eigen/Core>

#include <mpi.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsWorlds
/// What all ranks throw when one of them has failed with an exception that says neither that memory is exhausted nor that time is
/// over.
class Common_failure : public std::exception
{
public:
  /// With what the exception said, or that another rank had it.
  explicit Common_failure(std::string what) : m_what(std::move(what)) {}

  /// A sentence.
  const char* what() const noexcept override { return m_what.c_str(); }

private:
  std::string m_what;
};

/// \ingroup PkgFlipFreeMapsWorlds
/// The ranks of a communicator of MPI, each with a part of the mesh: the vertices that it owns, the elements around them, and the
/// other vertices of these elements, its ghosts. Local numbers begin with the owned vertices; ghosts follow, those of one owner side
/// by side. Elements of several ranks are counted by one of them, and are first in its order.
///
/// Sums are formed in the order of the ranks, so that they do not depend on the order in which messages arrive, and all ranks have
/// the same bits.
///
/// A rank that fails tells the others in place of its part of the next result that all wait for, and all of them throw the same: see
/// `together()`.
///
/// Copies share their state. Complexity: a result that all wait for takes one message of each rank to each; ghosts are exchanged with
/// neighbours only.
///
/// Available when `CGAL_FLIP_FREE_MAPS_USE_PETSC` is defined, since MPI comes with PETSc.
///
/// \cgalModels{World}
class Mpi_world
{
public:
  static constexpr bool is_sequential = false; ///< there are other processes

  /// Vertices that this rank exchanges with another one, by their local numbers, in the order that both know.
  struct Neighbor
  {
    int rank = 0;                     ///< the other one
    std::vector<std::int32_t> owned;  ///< here, ghosts there
    std::vector<std::int32_t> ghosts; ///< here, owned there: consecutive numbers
  };

  /// What a rank has of the mesh.
  struct Part
  {
    std::int32_t owned_vertices = 0;          ///< the first of the local vertices
    std::int64_t counted_elements = 0;        ///< the first of the local elements
    std::vector<std::int64_t> global_numbers; ///< of all local vertices
    std::vector<Neighbor> neighbors;          ///< in the order of their ranks
  };

  /// The ranks of `comm`, which is duplicated; all of them call this. MPI must have been initialised. PETSc is initialised here by all
  /// processes of `MPI_COMM_WORLD`, unless the program has done so: it has to where not all of them come here.
  explicit Mpi_world(MPI_Comm comm);

  /// The duplicate.
  MPI_Comm communicator() const { return m_state->comm; }
  /// The number of this process.
  int rank() const { return m_state->rank; }
  /// The number of processes.
  int size() const { return m_state->size; }

  /// Tells which part of the mesh this rank has. All vertices are unknowns until `number_unknowns()` says otherwise.
  void set_part(Part part);

  /// Vertices with a global number, in the order of the local numbers.
  const std::vector<std::int64_t>& global_numbers() const { return m_state->part.global_numbers; }

  /// Those of this rank, which come first.
  std::int64_t counted_elements(std::int64_t /* elements */) const { return m_state->part.counted_elements; }
  /// Those of this rank, which come first.
  std::int32_t owned_vertices(std::int32_t /* vertices */) const { return m_state->part.owned_vertices; }

  /// \name What all ranks have together
  /// All ranks call these functions in the same order, and get the same result.
  /// @{

  /// The sum.
  double sum(double x) const;
  /// The least.
  double minimum(double x) const;
  /// The greatest.
  int maximum(int x) const;
  /// Whether one has `true`.
  bool any(bool x) const { return maximum(x ? 1 : 0) != 0; }
  /// The inner product of vectors of unknowns.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return sum(a.dot(b)); }
  /// The norm of a vector of unknowns.
  double norm(const Eigen::VectorXd& a) const;
  /// The numbers of all ranks, one after the other.
  template <typename T>
  std::vector<T> gather(const std::vector<T>& part) const;
  /// What each rank has for this one, by ranks: `parts[r]` goes to rank r.
  template <typename T>
  std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& parts) const;
  /// @}

  /// \name Vectors of unknowns
  /// They hold what a rank owns, coordinates of one vertex side by side.
  /// @{

  /// Tells the number of each local vertex among the local unknowns, -1 for those that are none.
  void number_unknowns(const std::vector<std::int32_t>& numbers);
  /// Unknowns of another rank, by their local numbers.
  struct Ghosts
  {
    int rank;            ///< the owner
    std::int32_t first;  ///< the first of them
    std::int32_t number; ///< that follow each other
  };

  /// Those among the local unknowns, by their owners.
  std::vector<Ghosts> ghosts_of_unknowns() const
  {
    std::vector<Ghosts> ghosts;
    for(const Link& link : m_state->unknown_links)
      ghosts.push_back({link.rank, link.first_ghost, link.ghosts});
    return ghosts;
  }

  /// Whether the first unknown of all ranks is here.
  bool owns_first_unknown() const { return m_state->owned_unknowns > 0 && m_state->global_unknowns.front() == 0; }
  /// Vertices that this rank owns and that are unknowns.
  std::int32_t owned_unknowns() const { return m_state->owned_unknowns; }
  /// The numbers of the local unknowns among those of all ranks: the ranks follow each other.
  const std::vector<std::int64_t>& global_unknowns() const { return m_state->global_unknowns; }
  /// The vector with the ghosts' entries behind. The result changes with the next call.
  const Eigen::VectorXd& with_ghosts(const Eigen::VectorXd& owned) const;
  /// Removes the ghosts' entries.
  void keep_owned(Eigen::VectorXd& vector) const;
  /// @}

  /// Sets the columns of ghosts to what their owners have there.
  template <int D>
  void update_ghosts(Eigen::Matrix<double, D, Eigen::Dynamic>& columns) const;

  /// Calls `f()` on all ranks. If it throws on one of them, all throw the same: `Interruption`, `std::bad_alloc`, or `Common_failure`.
  template <typename F>
  void together(F&& f) const;

private:
  // Entries that go to and come from a neighbour.
  struct Link
  {
    int rank;
    std::vector<std::int32_t> owned;
    std::int32_t first_ghost, ghosts;
  };

  struct State
  {
    MPI_Comm comm = MPI_COMM_NULL;
    int rank = 0, size = 1;
    Part part;
    std::vector<Link> vertex_links, unknown_links;
    std::int32_t owned_unknowns = 0, local_unknowns = 0;
    std::vector<std::int64_t> global_unknowns;
    Eigen::VectorXd extended, sent;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();
  };

  // What the ranks tell each other whenever all wait for all.
  struct Message
  {
    double value;
    double failure; // a status, 0 for none
  };

  // Exceptions that all ranks have.
  struct Common
  {};
  struct Common_interruption
    : Interruption
    , Common
  {
    using Interruption::Interruption;
  };
  struct Common_bad_alloc
    : std::bad_alloc
    , Common
  {};
  struct Common_exception
    : Common_failure
    , Common
  {
    using Common_failure::Common_failure;
  };

  std::vector<Message> all(double value, Status failure = Status::success, const char* what = nullptr) const;
  void refresh(const std::vector<Link>& links, int block, double* entries) const;

  std::shared_ptr<State> m_state;
};

template <typename T>
std::vector<T> Mpi_world::gather(const std::vector<T>& part) const
{
  std::vector<T> result;
  for(const std::vector<T>& numbers : exchange(std::vector<std::vector<T>>(size(), part)))
    result.insert(result.end(), numbers.begin(), numbers.end());
  return result;
}

template <typename T>
std::vector<std::vector<T>> Mpi_world::exchange(const std::vector<std::vector<T>>& parts) const
{
  const int n = size();
  std::vector<int> sent(n), received(n), from(n + 1, 0), to(n + 1, 0);
  std::vector<T> all_sent, all_received;
  for(int r = 0; r < n; ++r) {
    sent[r] = static_cast<int>(parts[r].size());
    from[r + 1] = from[r] + sent[r];
    all_sent.insert(all_sent.end(), parts[r].begin(), parts[r].end());
  }
  // Here those who fail are heard.
  all(0);
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, m_state->comm);
  for(int r = 0; r < n; ++r)
    to[r + 1] = to[r] + received[r];
  together([&] { all_received.resize(to[n]); });
  MPI_Datatype type;
  MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(all_sent.data(), sent.data(), from.data(), type, all_received.data(), received.data(), to.data(), type, m_state->comm);
  MPI_Type_free(&type);
  std::vector<std::vector<T>> result(n);
  for(int r = 0; r < n; ++r)
    result[r].assign(all_received.begin() + to[r], all_received.begin() + to[r + 1]);
  return result;
}

template <int D>
void Mpi_world::update_ghosts(Eigen::Matrix<double, D, Eigen::Dynamic>& columns) const
{
  all(0);
  refresh(m_state->vertex_links, D, columns.data());
}

template <typename F>
void Mpi_world::together(F&& f) const
{
  try {
    f();
    all(0);
  } catch(const Common&) {
    throw;
  } catch(const Interruption& interruption) {
    all(0, interruption.status());
  } catch(const std::bad_alloc&) {
    all(0, Status::out_of_memory);
  } catch(const std::exception& exception) {
    all(0, Status::interrupted, exception.what());
  } catch(...) {
    all(0, Status::interrupted, "an exception");
  }
}

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/distribution/Mpi_world_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_USE_PETSC

#endif // CGAL_FLIP_FREE_MAPS_DISTRIBUTION_MPI_WORLD_H
