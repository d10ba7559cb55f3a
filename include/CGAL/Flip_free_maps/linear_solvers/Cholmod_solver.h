// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
#define CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H

#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>

#include <cholmod.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#endif

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsLinearSolvers
/// CHOLMOD's Cholesky factorization (Chen, Davis, Hager and Rajamanickam 2008), with 64-bit indices. Orderings are computed on the graph
/// of the vertices and expanded to the blocks: approximate minimum degree, and on large meshes METIS nested dissection as well, of
/// which the one with fewer floating-point operations is kept. CHOLMOD chooses the supernodal or the simplicial kernel by the operations
/// per entry of the factor. The factor's storage is kept between factorizations.
///
/// The BLAS is held to one thread while factorizing, if it is OpenBLAS: its results, and so the map, would otherwise depend on the
/// number of threads.
///
/// Available when `CGAL_FLIP_FREE_MAPS_USE_CHOLMOD` is defined.
///
/// \cgalModels{SymmetricSparseSolver}
class Cholmod_solver
{
public:
  /// Vertices from which METIS is tried as well.
  static constexpr std::int64_t METIS_THRESHOLD = 20000;

  Cholmod_solver()
  {
    cholmod_l_start(&m_common);
    m_common.print = 0;
    m_common.quick_return_if_not_posdef = 1;
    // An LDL^T factorization, the other choice of the simplicial kernel, would accept indefinite matrices.
    m_common.final_ll = 1;
    m_common.error_handler = nullptr;
  }

  ~Cholmod_solver()
  {
    release();
    cholmod_l_finish(&m_common);
  }

  Cholmod_solver(const Cholmod_solver&) = delete;
  Cholmod_solver& operator=(const Cholmod_solver&) = delete;

  /// "cholmod_supernodal" or "cholmod_simplicial", known after the analysis.
  std::string name() const
  {
    return m_factor != nullptr && !m_factor->is_super ? "cholmod_simplicial" : "cholmod_supernodal";
  }
  /// "amd" or "metis"
  std::string ordering() const { return m_ordering; }

  /// Computes the ordering and the pattern of the factor.
  bool analyze_pattern(const Block_sparse_matrix& matrix)
  {
    release();
    std::vector<Block_sparse_matrix::Index> graph_rows(matrix.block_row_indices().begin(), matrix.block_row_indices().end());
    cholmod_sparse graph = view(matrix.number_of_vertices(), matrix.block_column_starts(), graph_rows, nullptr);

    m_ordering = "amd";
    cholmod_factor* best = analyze_graph(graph, CHOLMOD_AMD);
    if(matrix.number_of_vertices() >= METIS_THRESHOLD) {
      const double amd_flops = m_common.fl;
      cholmod_factor* metis = analyze_graph(graph, CHOLMOD_METIS);
      if(metis != nullptr && (best == nullptr || m_common.fl < amd_flops)) {
        std::swap(best, metis);
        m_ordering = "metis";
      }
      if(metis != nullptr)
        cholmod_l_free_factor(&metis, &m_common);
    }
    if(best == nullptr)
      return false;

    const std::int64_t b = matrix.block_size();
    const SuiteSparse_long* order = static_cast<const SuiteSparse_long*>(best->Perm);
    std::vector<SuiteSparse_long> expanded(matrix.rows());
    for(std::int64_t v = 0; v < matrix.number_of_vertices(); ++v)
      for(std::int64_t i = 0; i < b; ++i)
        expanded[v * b + i] = order[v] * b + i;
    cholmod_l_free_factor(&best, &m_common);

    cholmod_sparse full = view(matrix.rows(), matrix.column_starts(), matrix.row_indices(), matrix.values().data());
    use_method(CHOLMOD_GIVEN);
    m_factor = cholmod_l_analyze_p(&full, expanded.data(), nullptr, 0, &m_common);
    m_factor_entries = m_factor != nullptr ? static_cast<std::int64_t>(m_common.lnz) : -1;
    m_factor_operations = m_common.fl;
    return m_factor != nullptr;
  }

  /// Factorizes; the pattern must be the one analysed. `false` when the matrix is not positive definite or memory is exhausted.
  bool factorize(const Block_sparse_matrix& matrix)
  {
    m_factorized = false;
    if(m_factor == nullptr)
      return false;
    cholmod_sparse full = view(matrix.rows(), matrix.column_starts(), matrix.row_indices(), matrix.values().data());
    const Single_blas_thread guard;
    cholmod_l_factorize(&full, m_factor, &m_common);
    // A NaN in the matrix is no error to CHOLMOD, but leaves no condition number.
    m_factorized = m_common.status == CHOLMOD_OK && m_factor->minor == m_factor->n && cholmod_l_rcond(m_factor, &m_common) > 0;
    return m_factorized;
  }

  /// Solves for one right-hand side with the last factorization.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    if(!m_factorized)
      return false;
    cholmod_dense right = {};
    right.nrow = right.nzmax = right.d = b.size();
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const Single_blas_thread guard;
    if(!cholmod_l_solve2(CHOLMOD_A, m_factor, &right, nullptr, &m_solution, nullptr, &m_work_y, &m_work_e, &m_common))
      return false;
    x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(m_solution->x), b.size());
    return x.allFinite();
  }

  /// Entries of the factor, known after the analysis.
  std::int64_t factor_entries() const { return m_factor_entries; }

  /// Floating-point operations of a factorization, known after the analysis.
  double factor_operations() const { return m_factor_operations; }

private:
  static_assert(sizeof(SuiteSparse_long) == sizeof(Block_sparse_matrix::Index), "CHOLMOD's long indices must have 64 bits");

  // OpenBLAS is looked up at run time, because which BLAS serves CHOLMOD is only known then.
  class Single_blas_thread
  {
  public:
    Single_blas_thread()
    {
      if(functions().set == nullptr || functions().get == nullptr)
        return;
      m_threads = functions().get();
      if(m_threads != 1)
        functions().set(1);
    }
    ~Single_blas_thread()
    {
      if(m_threads > 1)
        functions().set(m_threads);
    }
    Single_blas_thread(const Single_blas_thread&) = delete;
    Single_blas_thread& operator=(const Single_blas_thread&) = delete;

  private:
    struct Functions
    {
      void (*set)(int) = nullptr;
      int (*get)() = nullptr;
    };
    static const Functions& functions()
    {
      static const Functions found = [] {
        Functions f;
#if defined(__unix__) || defined(__APPLE__)
        f.set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
        f.get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
#endif
        return f;
      }();
      return found;
    }
    int m_threads = 1;
  };

  static cholmod_sparse view(std::int64_t n, const std::vector<Block_sparse_matrix::Index>& columns,
                             const std::vector<Block_sparse_matrix::Index>& rows, const double* values)
  {
    cholmod_sparse matrix = {};
    matrix.nrow = matrix.ncol = n;
    matrix.nzmax = rows.size();
    matrix.p = const_cast<Block_sparse_matrix::Index*>(columns.data());
    matrix.i = const_cast<Block_sparse_matrix::Index*>(rows.data());
    matrix.x = const_cast<double*>(values);
    matrix.stype = -1;
    matrix.itype = CHOLMOD_LONG;
    matrix.xtype = values != nullptr ? CHOLMOD_REAL : CHOLMOD_PATTERN;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

  void use_method(int ordering)
  {
    m_common.nmethods = 1;
    m_common.method[0].ordering = ordering;
    m_common.postorder = 1;
  }

  cholmod_factor* analyze_graph(cholmod_sparse& graph, int ordering)
  {
    use_method(ordering);
    // The scalar pattern of the graph is only a means to an ordering and its cost; building supernodes for it would be wasted.
    m_common.supernodal = CHOLMOD_SIMPLICIAL;
    cholmod_factor* factor = cholmod_l_analyze(&graph, &m_common);
    m_common.supernodal = CHOLMOD_AUTO;
    return factor;
  }

  void release()
  {
    if(m_factor != nullptr)
      cholmod_l_free_factor(&m_factor, &m_common);
    if(m_solution != nullptr)
      cholmod_l_free_dense(&m_solution, &m_common);
    if(m_work_y != nullptr)
      cholmod_l_free_dense(&m_work_y, &m_common);
    if(m_work_e != nullptr)
      cholmod_l_free_dense(&m_work_e, &m_common);
    m_factorized = false;
  }

  cholmod_common m_common;
  cholmod_factor* m_factor = nullptr;
  cholmod_dense* m_solution = nullptr;
  cholmod_dense* m_work_y = nullptr;
  cholmod_dense* m_work_e = nullptr;
  std::string m_ordering;
  std::int64_t m_factor_entries = -1;
  double m_factor_operations = 0;
  bool m_factorized = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_LINEAR_SOLVERS_CHOLMOD_SOLVER_H
