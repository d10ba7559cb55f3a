// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The concepts: archetypes that offer nothing but what the concept pages ask for are enough to run the algorithms and are given
// what the pages promise, and all models of the package pass the check classes.

#include "support/unit_test.h"

#include <CGAL/Flip_free_maps/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/accelerations/Inexact_newton.h>
#include <CGAL/Flip_free_maps/accelerations/Lbfgs.h>
#include <CGAL/Flip_free_maps/accelerations/Nesterov.h>
#include <CGAL/Flip_free_maps/distribution/Distributed_multigrid.h>
#include <CGAL/Flip_free_maps/distribution/Mpi_world.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/linear_solvers/Conjugate_gradient_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Incomplete_cholesky.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_direct_solver.h>
#include <CGAL/Flip_free_maps/linear_solvers/Petsc_multigrid.h>
#include <CGAL/Flip_free_maps/linear_solvers/Sparse_linear_algebra_solver.h>
#include <CGAL/Flip_free_maps/method/Any_map_traits.h>
#include <CGAL/Flip_free_maps/method/concepts.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/preconditioners/Composite_majorization.h>
#include <CGAL/Flip_free_maps/preconditioners/Hybrid.h>
#include <CGAL/Flip_free_maps/preconditioners/Killing.h>
#include <CGAL/Flip_free_maps/preconditioners/Laplacian.h>
#include <CGAL/Flip_free_maps/preconditioners/Newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim.h>
#include <CGAL/Flip_free_maps/preconditioners/Slim_newton.h>
#include <CGAL/Flip_free_maps/preconditioners/Vertex_space_newton.h>
#include <CGAL/Flip_free_maps/references/Progressive_reference.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_concepts)

namespace FFM = CGAL::Flip_free_maps;

namespace {

// What the archetypes saw.
struct Record
{
  bool energy_arguments_kept = true;
  bool form_arguments_kept = true;
  bool reference_arguments_kept = true;
  bool rule_arguments_kept = true;
  bool solver_order_kept = true;
  int values = 0;
  int forms = 0;
  int restarts = 0;
  int updates = 0;
  int decreases = 0;
  int rules = 0;
  int resets = 0;
  int directions = 0;
  int solvers = 0;
  int analyses = 0;
  int factorizations = 0;
};
Record record;

struct Only_from_int
{
  explicit Only_from_int(int) {}
  Only_from_int(const Only_from_int&) = default;
  Only_from_int& operator=(const Only_from_int&) = delete;
};

struct Archetype_kernel
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  struct Point_2
  {
    Point_2(double x, double y) : point(x, y) {}
    Exact::Point_2 point;
  };
  struct Orientation_2
  {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      return CGAL::orientation(p.point, q.point, r.point);
    }
  };
};

struct Archetype_energy : Only_from_int
{
  using Only_from_int::Only_from_int;
  static constexpr bool has_barrier = true;
  static const char* name() { return "archetype"; }

  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    ++record.values;
    record.energy_arguments_kept = record.energy_arguments_kept && s[0] >= s[D - 1] && s[D - 1] > 0;
    return (s.array() + s.array().inverse()).sum();
  }
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    record.energy_arguments_kept = record.energy_arguments_kept && s[0] >= s[D - 1] && s[D - 1] > 0;
    gradient = 1 - s.array().square().inverse();
    hessian.setZero();
    hessian.diagonal() = 2 * s.array().cube().inverse();
  }
};

struct Archetype_preconditioner : Only_from_int
{
  using Only_from_int::Only_from_int;
  using Category = FFM::Varying_matrix_tag;
  static constexpr bool is_second_order = true;
  static const char* name() { return "archetype"; }

  // The curvature at the identity in all directions: a Laplacian.
  template <int D, typename Energy>
  void form(const FFM::Element_state<D>& state, const Energy& energy, FFM::Increment_form<D>& form) const
  {
    ++record.forms;
    Eigen::Matrix<double, D, 1> gradient;
    Eigen::Matrix<double, D, D> hessian;
    energy.template derivatives<D>(state.s, gradient, hessian);
    record.form_arguments_kept = record.form_arguments_kept && gradient == state.gradient && hessian == state.hessian;
    form.stretch = 2 * Eigen::Matrix<double, D, D>::Identity();
    for(auto& pair : form.pairs)
      pair.set_modes(2, 2);
  }
};

struct Archetype_reference : Only_from_int
{
  using Only_from_int::Only_from_int;
  static const char* name() { return "archetype"; }

  // Claims to be another shape in the first two iterations.
  void restart()
  {
    ++record.restarts;
    m_updates = 0;
  }
  template <int D>
  bool update(const FFM::Simplicial_domain<D>& domain, const FFM::Positions<D>& x)
  {
    ++record.updates;
    record.reference_arguments_kept = record.reference_arguments_kept && x.cols() == domain.number_of_vertices && m_updates < 3;
    return ++m_updates == 3;
  }
  double relative_decrease() const
  {
    ++record.decreases;
    return 1;
  }
  template <int D>
  const Eigen::Matrix<double, D, D>& rest_inverse(const FFM::Simplicial_domain<D>& domain, std::int64_t e) const
  {
    return domain.rest_inverses[e];
  }
  template <int D>
  double weight(const FFM::Simplicial_domain<D>& domain, std::int64_t e) const
  {
    return domain.measures[e];
  }

private:
  int m_updates = 0;
};

struct Archetype_acceleration : Only_from_int
{
  using Only_from_int::Only_from_int;
  static const char* name() { return "archetype"; }

  void reset() { ++record.resets; }
  template <typename Solve>
  bool direction(const Eigen::VectorXd&, const Eigen::VectorXd& gradient, Solve&& solve, Eigen::VectorXd& direction)
  {
    ++record.directions;
    const Eigen::VectorXd right = -gradient;
    return solve(right, direction);
  }
};

struct Archetype_rule : Only_from_int
{
  using Only_from_int::Only_from_int;
  FFM::Refactorization operator()(int age, double last_step, double relative_decrease)
  {
    ++record.rules;
    record.rule_arguments_kept = record.rule_arguments_kept && age > 0 && last_step > 0 && relative_decrease >= 0;
    return age >= 2 ? FFM::Refactorization::refresh : FFM::Refactorization::none;
  }
};

class Archetype_linear_solver
{
public:
  explicit Archetype_linear_solver(int) { ++record.solvers; }
  Archetype_linear_solver(const Archetype_linear_solver&) = delete;
  Archetype_linear_solver& operator=(const Archetype_linear_solver&) = delete;

  std::string name() const { return "archetype"; }
  std::string ordering() const { return "archetype"; }
  bool analyze_pattern(const FFM::Block_sparse_matrix& matrix)
  {
    ++record.analyses;
    m_matrix = matrix.lower();
    m_solver.analyzePattern(m_matrix);
    m_analyzed = true;
    return true;
  }
  bool factorize(const FFM::Block_sparse_matrix& matrix)
  {
    ++record.factorizations;
    record.solver_order_kept = record.solver_order_kept && m_analyzed;
    m_matrix = matrix.lower();
    m_solver.factorize(m_matrix);
    m_factorized = m_solver.info() == Eigen::Success;
    return m_factorized;
  }
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x)
  {
    record.solver_order_kept = record.solver_order_kept && m_factorized;
    x = m_solver.solve(b);
    return x.allFinite();
  }
  std::int64_t factor_entries() const { return -1; }

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, FFM::Block_sparse_matrix::Index>;
  Matrix m_matrix;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<FFM::Block_sparse_matrix::Index>> m_solver;
  bool m_analyzed = false;
  bool m_factorized = false;
};

struct Archetype_traits : Only_from_int
{
  using Kernel = Archetype_kernel;
  using Energy = Archetype_energy;
  using Preconditioner = Archetype_preconditioner;
  using Reference = Archetype_reference;
  using Linear_solver = Archetype_linear_solver;
  using Acceleration = Archetype_acceleration;
  using Refactorization_rule = Archetype_rule;
  using Concurrency_tag = CGAL::Sequential_tag;
  template <int D, typename Traits>
  using Minimizer = FFM::Map_minimizer<D, Traits>;

  using Only_from_int::Only_from_int;
  Energy energy{0};
  Preconditioner preconditioner{0};
  Reference reference{0};
  Acceleration acceleration{0};
  Refactorization_rule refactorization_rule{0};
  FFM::Map_options options;
  FFM::Start_options start;
  Linear_solver make_linear_solver() const { return Linear_solver(0); }
};

// The unit square, cut along a diagonal.
FFM::Simplicial_domain<2> two_triangles()
{
  FFM::Simplicial_domain<2> domain;
  domain.number_of_vertices = 4;
  domain.elements = {{0, 1, 2}, {0, 2, 3}};
  domain.measures = {0.5, 0.5};
  Eigen::Matrix2d edges[2];
  edges[0] << 1, 1, 0, 1;
  edges[1] << 1, 0, 1, 1;
  domain.rest_inverses = {Eigen::Matrix2d(edges[0].inverse()), Eigen::Matrix2d(edges[1].inverse())};
  return domain;
}

} // namespace

BOOST_AUTO_TEST_CASE(archetypes_minimize)
{
  BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Archetype_traits, 2>));

  record = Record();
  const FFM::Simplicial_domain<2> domain = two_triangles();
  Archetype_traits traits(0);
  traits.options.characteristic_gradient_tolerance = 1e-10;
  FFM::Map_minimizer<2, Archetype_traits> minimizer(domain, traits);
  FFM::Positions<2> x(2, 4);
  x << 0, 3.0, 2.0, 0.4, 0, 0.2, 0.9, 2.5;
  const FFM::Summary summary = minimizer.minimize(x);

  // Two triangles can be laid out without distortion: both energies are 2 + 2, and all edges have their rest lengths.
  BOOST_TEST(summary.converged(), summary.message);
  BOOST_TEST(summary.energy == 4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((x.col(1) - x.col(0)).norm() == 1, boost::test_tools::tolerance(1e-6));
  BOOST_TEST((x.col(2) - x.col(1)).norm() == 1, boost::test_tools::tolerance(1e-6));
  BOOST_TEST((x.col(2) - x.col(0)).norm() == std::sqrt(2.), boost::test_tools::tolerance(1e-6));
  BOOST_TEST((x.col(3) - x.col(2)).norm() == 1, boost::test_tools::tolerance(1e-6));
  BOOST_TEST((x.col(0) - x.col(3)).norm() == 1, boost::test_tools::tolerance(1e-6));

  BOOST_TEST(record.energy_arguments_kept);
  BOOST_TEST(record.form_arguments_kept);
  BOOST_TEST(record.reference_arguments_kept);
  BOOST_TEST(record.rule_arguments_kept);
  BOOST_TEST(record.solver_order_kept);
  BOOST_TEST(record.values > 0);
  BOOST_TEST(record.forms > 0);
  BOOST_TEST(record.resets >= 1);
  // The reference is asked until it is the rest shape, and for its decrease while it is not.
  BOOST_TEST(record.restarts == 1);
  BOOST_TEST(record.updates == 3);
  BOOST_TEST(record.decreases == 2);
  BOOST_TEST(summary.iterations >= 2);
  BOOST_TEST(record.directions >= summary.iterations);
  BOOST_TEST(record.solvers == 1);
  BOOST_TEST(record.analyses == 1);
  BOOST_TEST(record.factorizations == summary.factorizations);
  // The rule keeps every factorization for two steps.
  BOOST_TEST(record.rules > 0);
  BOOST_TEST(summary.factorizations < summary.iterations);
  BOOST_TEST(summary.linear_solver == "archetype");
  BOOST_TEST(summary.preconditioner == "archetype");
  BOOST_TEST(summary.energy_name == "archetype");
}

BOOST_AUTO_TEST_CASE(archetypes_parameterize)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  // A cylinder over an arc of 1 radian is developable: the minimum of the energy over smooth maps is that of an isometry, and the
  // triangles are small.
  const auto cylinder = [](double i, double j) { return Kernel::Point_3(5 * std::cos(i / 10), 5 * std::sin(i / 10), j / 2); };
  auto border = CGAL::make_grid(10, 10, mesh, cylinder, true);
  border = CGAL::is_border(border, mesh) ? border : opposite(border, mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  record = Record();
  const FFM::Summary summary = FFM::parameterize(mesh, border, uv, Archetype_traits(0));
  BOOST_TEST(summary.converged(), summary.message);
  BOOST_TEST(summary.flips == 0);
  BOOST_TEST(summary.energy == 4, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(record.energy_arguments_kept);
  BOOST_TEST(record.solvers == 2); // one for the start, one for the minimizer
}

BOOST_AUTO_TEST_CASE(models)
{
  using Energy = FFM::Symmetric_dirichlet;
  using Default_traits = FFM::Flip_free_map_traits<>;

  BOOST_CONCEPT_ASSERT((FFM::DistortionEnergyConcept<Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::DistortionEnergyConcept<Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::ConvexConcaveEnergyConcept<Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::ConvexConcaveEnergyConcept<Energy, 3>));

  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Laplacian, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Laplacian, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Killing, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Killing, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Slim, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Slim, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Slim_newton, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Slim_newton, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Projected_newton, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Projected_newton, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Newton, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Newton, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Vertex_space_newton, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Vertex_space_newton, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Hybrid<>, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Hybrid<>, Energy, 3>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Composite_majorization<true>, Energy, 2>));
  BOOST_CONCEPT_ASSERT((FFM::PreconditionerConcept<FFM::Composite_majorization<false>, Energy, 2>));

  BOOST_CONCEPT_ASSERT((FFM::ReferenceConcept<FFM::Fixed_reference, 2>));
  BOOST_CONCEPT_ASSERT((FFM::ReferenceConcept<FFM::Fixed_reference, 3>));
  BOOST_CONCEPT_ASSERT((FFM::ReferenceConcept<FFM::Progressive_reference, 2>));
  BOOST_CONCEPT_ASSERT((FFM::ReferenceConcept<FFM::Progressive_reference, 3>));
  BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<FFM::No_acceleration>));
  BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<FFM::Nesterov>));
  BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<FFM::Inexact_newton>));
  BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<FFM::Lbfgs>));
  BOOST_CONCEPT_ASSERT((FFM::AccelerationConcept<FFM::Any_acceleration>));
  BOOST_CONCEPT_ASSERT((FFM::RefactorizationRuleConcept<FFM::Every_iteration>));
  BOOST_CONCEPT_ASSERT((FFM::RefactorizationRuleConcept<FFM::On_demand>));

  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Block_jacobi<2>>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Conjugate_gradient_solver<>>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Eigen_simplicial_solver>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Incomplete_cholesky>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Sparse_linear_algebra_solver<CGAL::Eigen_solver_traits<>>>));
#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Cholmod_solver>));
#endif
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Any_linear_solver>));
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Petsc_direct_solver>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Petsc_multigrid>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Conjugate_gradient_solver<FFM::Petsc_multigrid>>));
#endif

  BOOST_CONCEPT_ASSERT((FFM::WorldConcept<FFM::Sequential_world>));
#ifdef CGAL_FLIP_FREE_MAPS_USE_PETSC
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Distributed_multigrid>));
  BOOST_CONCEPT_ASSERT((FFM::SymmetricSparseSolverConcept<FFM::Conjugate_gradient_solver<FFM::Distributed_multigrid, FFM::Mpi_world>>));
  BOOST_CONCEPT_ASSERT((FFM::WorldConcept<FFM::Mpi_world>));
#endif

  using Make_linear_solver = FFM::Eigen_simplicial_solver (*)();
  BOOST_CONCEPT_ASSERT(
    (FFM::InitializerConcept<FFM::Tutte_initializer<Default_traits::Kernel, FFM::Eigen_simplicial_solver, CGAL::Sequential_tag>,
                             Make_linear_solver>));

  BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Default_traits, 2>));
  BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<Default_traits, 3>));
  BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<FFM::Any_map_traits, 2>));
  BOOST_CONCEPT_ASSERT((FFM::MapTraitsConcept<FFM::Any_map_traits, 3>));

  // Names are what reports tell models apart by.
  BOOST_TEST(std::string(Energy::name()) == "symmetric_dirichlet");
  BOOST_TEST(std::string(FFM::Composite_majorization<true>::name()) != FFM::Composite_majorization<false>::name());
}

BOOST_AUTO_TEST_SUITE_END() // test_concepts
