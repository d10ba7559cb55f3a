// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MAP_OBJECTIVE_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MAP_OBJECTIVE_H

#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Map_measure.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/Triangle_batch.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/elements/internal/project_to_psd.h>
#include <CGAL/Flip_free_maps/elements/largest_flip_free_step.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>
#include <CGAL/Flip_free_maps/linear_solvers/Block_sparse_matrix.h>
#include <CGAL/Flip_free_maps/minimizer/internal/Vertex_relaxation.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>
#include <CGAL/Flip_free_maps/worlds/internal/world_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The mean energy of a map and the terms beside it, with their gradient and the preconditioner's matrix: the one place where
// elements are visited. Vectors of unknowns hold the coordinates of the vertices that are not fixed, in their order; of those that
// several processes know they hold what this one owns.
template <int D, typename Traits>
class Map_objective
{
  using Energy = typename Traits::Energy;
  using Reference = typename Traits::Reference;
  using Preconditioner = typename Traits::Preconditioner;
  using Tag = typename Traits::Concurrency_tag;
  using Element = typename Simplicial_domain<D>::Element;
  using World = typename World_of<Traits>::type;

  static constexpr int PAIRS = D * (D + 1) / 2; // of distinct vertices of an element
  static constexpr bool USES_LANES = D == 2 && Has_lanes<Energy>::value;

public:
  // The blocks of a matrix for the pairs a <= b of an element's vertices.
  using Element_blocks = std::array<std::array<Matrix<D>, D + 1>, D + 1>;

  Map_objective(const Simplicial_domain<D>& domain, const Energy& energy, const Preconditioner& preconditioner,
                const World& world = World())
    : m_domain(domain), m_energy(energy), m_preconditioner(preconditioner), m_world(world)
  {
    m_schedule.build(domain.elements, domain.number_of_vertices, world.counted_elements(domain.number_of_elements()));
    fix({});
  }

  const World& world() const { return m_world; }

  const Element_coloring& schedule() const { return m_schedule; }

  // Those of all parts of the mesh, each counted once.
  double number_of_elements() const { return m_world.sum(static_cast<double>(m_world.counted_elements(m_domain.number_of_elements()))); }

  // Chooses the vertices that are no unknowns.
  void fix(const std::vector<std::int32_t>& vertices)
  {
    m_unknowns.assign(m_domain.number_of_vertices, vertices);
    m_world.number_unknowns(m_unknowns.numbers());
  }

  // Chooses the directions in which unknowns move: across them there are neither forces nor steps.
  void slide(const std::vector<Sliding_vertex<D>>& vertices)
  {
    m_projections.clear();
    m_projection_of.assign(vertices.empty() ? 0 : m_domain.number_of_vertices, -1);
    for(const Sliding_vertex<D>& sliding : vertices)
      if(!is_fixed(sliding.vertex)) {
        m_projection_of[sliding.vertex] = static_cast<std::int32_t>(m_projections.size());
        m_projections.push_back(sliding.projection);
      }
  }

  // Vertices that are not fixed.
  std::int32_t number_of_unknowns() const { return m_unknowns.size(); }

  // Whether there is a vertex that is not fixed.
  bool has_unknowns() const { return m_world.any(m_unknowns.size() > 0); }

  bool is_fixed(std::int32_t v) const { return m_unknowns.is_fixed(v); }

  bool slides(std::int32_t v) const { return !m_projection_of.empty() && m_projection_of[v] >= 0; }

  bool has_sliding_vertices() const { return !m_projections.empty(); }

  // What is minimised along with the energy of the elements. A null pointer is no term.
  void add_term(std::shared_ptr<const Objective_term<D>> term)
  {
    if(term != nullptr)
      m_terms.push_back(std::move(term));
  }

  bool has_terms() const { return !m_terms.empty(); }

  // Whether the whole map can move as a rigid body without any change of the objective.
  bool is_rigid_motion_invariant() const
  {
    bool is_invariant = m_unknowns.size() == m_domain.number_of_vertices && m_projections.empty();
    for(const auto& term : m_terms)
      is_invariant = is_invariant && term->is_rigid_motion_invariant();
    return is_invariant;
  }

  // Builds the pattern of the matrix and every element's places in it.
  void build_pattern()
  {
    std::vector<std::vector<std::int32_t>> term_stencils;
    for(const auto& term : m_terms)
      for(std::vector<std::int32_t>& stencil : term->stencils()) {
        for(std::int32_t& v : stencil)
          v = m_unknowns[v];
        term_stencils.push_back(std::move(stencil));
      }
    if(m_unknowns.size() == m_domain.number_of_vertices)
      m_matrix.build_pattern(m_unknowns.size(), D, m_domain.elements, term_stencils);
    else
      m_matrix.build_pattern(m_unknowns.size(), D, m_unknowns.of(m_domain.elements), term_stencils);
    m_slots.resize(m_domain.elements.size());
    m_schedule.template scatter<Tag>([this](std::int64_t e) {
      const Element& v = m_domain.elements[e];
      int p = 0;
      for(int a = 0; a <= D; ++a)
        for(int b = a + 1; b <= D; ++b, ++p)
          m_slots[e][p] = is_fixed(v[a]) || is_fixed(v[b]) ? 0 : m_matrix.slot(m_unknowns[v[a]], m_unknowns[v[b]]);
    });
  }

  Block_sparse_matrix& matrix() { return m_matrix; }
  const Block_sparse_matrix& matrix() const { return m_matrix; }

  // Numbers of an element's vertices among the unknowns, -1 for fixed ones.
  Element unknowns_of_element(std::int64_t e) const { return m_unknowns.of(m_domain.elements[e]); }

  // The unknowns among the positions.
  void gather(const Positions<D>& x, Eigen::VectorXd& unknowns) const
  {
    unknowns.resize(D * std::int64_t(m_unknowns.size()));
    for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v)
      if(!is_fixed(v))
        unknowns.template segment<D>(D * std::int64_t(m_unknowns[v])) = x.col(v);
    m_world.keep_owned(unknowns);
  }

  // A displacement of all vertices from one of the unknowns.
  void spread(const Eigen::VectorXd& owned, Positions<D>& displacement) const
  {
    const Eigen::VectorXd& unknowns = m_world.with_ghosts(owned);
    displacement.resize(D, m_domain.number_of_vertices);
    for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v) {
      if(is_fixed(v))
        displacement.col(v).setZero();
      else
        displacement.col(v) = unknowns.template segment<D>(D * std::int64_t(m_unknowns[v]));
      if(slides(v))
        displacement.col(v) = projection(v) * displacement.col(v);
    }
  }

  // Mean energy of the elements and the terms; +infinity when an element of a barrier energy is not positive.
  template <typename AnyReference>
  double energy(const AnyReference& reference, const Positions<D>& x) const
  {
    return mean_energy(reference, x) + energy_of_terms(x);
  }

  template <typename AnyReference>
  double mean_energy(const AnyReference& reference, const Positions<D>& x) const
  {
    return m_world.sum(m_schedule.template sum_of_chunks<Tag>([&](std::int64_t begin, std::int64_t end) {
      double sum = 0;
      if constexpr(USES_LANES)
        for(; begin + NUMBER_OF_LANES <= end; begin += NUMBER_OF_LANES)
          sum += Triangle_batch(m_domain, reference, begin, x).energy(m_energy);
      for(; begin < end; ++begin)
        sum += energy_of_element(reference, begin, x);
      return sum;
    }));
  }

  double energy_of_terms(const Positions<D>& x) const
  {
    double sum = 0;
    for(const auto& term : m_terms)
      sum += term->value(x);
    return sum;
  }

  // The fraction of elements whose symmetric Dirichlet energy exceeds a bound; an element that is not positive does.
  double distorted_fraction(const Positions<D>& x, double bound) const
  {
    const double number = m_world.sum(m_schedule.template sum<Tag>([&](std::int64_t e) {
      const Vector<D> s = signed_singular_values(m_domain.jacobian(e, x));
      return s[D - 1] > 0 && Symmetric_dirichlet().value<D>(s) <= bound ? 0. : 1.;
    }));
    return number / (std::max)(1., number_of_elements());
  }

  // Gradient in the unknowns and, when asked, the matrix.
  void derivatives(const Reference& reference, const Positions<D>& x, bool with_matrix, Eigen::VectorXd& gradient)
  {
    gradient.setZero(D * std::int64_t(m_unknowns.size()));
    if(with_matrix)
      m_matrix.set_zero();
    m_schedule.template scatter_chunks<Tag>([&](std::int64_t begin, std::int64_t end) {
      if constexpr(USES_LANES)
        for(; !with_matrix && begin + NUMBER_OF_LANES <= end; begin += NUMBER_OF_LANES)
          Triangle_batch(m_domain, reference, begin, x).for_each_gradient(m_energy, [&](int l, const Matrix<2>& forces) {
            add_forces(begin + l, forces, gradient);
          });
      for(; begin < end; ++begin)
        add_derivatives_of_element(reference, x, begin, with_matrix, gradient);
    });
    if(!m_terms.empty())
      add_derivatives_of_terms(x, with_matrix, gradient);
    project(gradient);
    m_world.keep_owned(gradient);
  }

  static constexpr const char* FOREIGN_BLOCK = "the matrix of a term has a block of two vertices that share none of its stencils";

  // Whether the last derivatives had no block of a term outside its stencils.
  bool terms_keep_to_stencils() const { return m_terms_keep_to_stencils; }

  // The product of the preconditioner's matrix on all vertices, fixed or not, with a displacement of all vertices: its rows of
  // unknowns. No matrix is formed. Terms do not enter.
  void multiply(const Reference& reference, const Positions<D>& x, const Positions<D>& displacement, Eigen::VectorXd& product) const
  {
    product.setZero(D * std::int64_t(m_unknowns.size()));
    m_schedule.template scatter<Tag>([&](std::int64_t e) {
      const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
      const Evaluation at_x = evaluate(rest_inverse, x, e);
      const Matrix<D>&U = at_x.svd.U, &V = at_x.svd.V;
      const Matrix<D> increment = U.transpose() * m_domain.image_edges(e, displacement) * rest_inverse * V;
      add_forces(e, U * (reference.weight(m_domain, e) * form(at_x.state).multiply(increment)) * V.transpose() * rest_inverse.transpose(),
                 product);
    });
    project(product);
    m_world.keep_owned(product);
  }

  // The elements that were deformed or turned most between two maps, by more than `bound`, at most `number` of them and in
  // ascending order: by the Frobenius norm of F - I, where F maps an element's image at `old` to that at x.
  std::vector<std::int64_t> most_deformed_elements(const Positions<D>& old, const Positions<D>& x, double bound, std::int64_t number) const
  {
    const auto squared_deformation = [&](std::int64_t e) {
      const Matrix<D> edges = m_domain.image_edges(e, old);
      return ((m_domain.image_edges(e, x) - edges) * edges.inverse()).squaredNorm();
    };
    std::vector<std::int64_t> elements =
      m_schedule.template collect<Tag>([&](std::int64_t e) { return squared_deformation(e) > bound * bound; });
    if(static_cast<std::int64_t>(elements.size()) <= number)
      return elements;
    std::vector<std::pair<double, std::int64_t>> by_deformation;
    for(std::int64_t e : elements)
      by_deformation.emplace_back(-squared_deformation(e), e);
    std::nth_element(by_deformation.begin(), by_deformation.begin() + number, by_deformation.end());
    elements.clear();
    for(std::int64_t i = 0; i < number; ++i)
      elements.push_back(by_deformation[i].second);
    std::sort(elements.begin(), elements.end());
    return elements;
  }

  // What an element contributes to the preconditioner's matrix at x less what it does at `old`.
  Element_blocks change_of_element(const Reference& reference, const Positions<D>& old, const Positions<D>& x, std::int64_t e) const
  {
    Element_blocks blocks = element_blocks(reference, x, e);
    const Element_blocks before = element_blocks(reference, old, e);
    for(int a = 0; a <= D; ++a)
      for(int b = a; b <= D; ++b)
        blocks[a][b] -= before[a][b];
    return blocks;
  }

  // The step at which the first element collapses.
  double largest_step(const Positions<D>& x, const Positions<D>& direction) const
  {
    return m_world.minimum(m_schedule.template minimum<Tag>(
      [&](std::int64_t e) { return largest_flip_free_step(m_domain.image_edges(e, x), m_domain.image_edges(e, direction)); }));
  }

  // Moves the vertices of the elements that would collapse within `bound` along the direction, each to the optimum of the
  // elements around it: such elements hold up the whole map, and need a place of their own first.
  // `is_positive(e, x)` has the last word on each move.
  template <typename IsPositive>
  void free_blocked_vertices(const Reference& reference, const Positions<D>& direction, double bound, IsPositive&& is_positive,
                             Positions<D>& x)
  {
    if(m_star_begin.empty())
      build_stars();
    std::vector<std::int32_t> blocked;
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      if(largest_flip_free_step(m_domain.image_edges(e, x), m_domain.image_edges(e, direction)) <= bound)
        blocked.insert(blocked.end(), m_domain.elements[e].begin(), m_domain.elements[e].end());
    std::sort(blocked.begin(), blocked.end());
    blocked.erase(std::unique(blocked.begin(), blocked.end()), blocked.end());

    Vertex_relaxation<D, Energy> relaxation(m_energy);
    for(std::int32_t v : blocked) {
      if(is_fixed(v) || slides(v))
        continue;
      relaxation.clear();
      for(std::int64_t i = m_star_begin[v]; i < m_star_begin[v + 1]; ++i) {
        const std::int64_t e = m_stars[i];
        const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
        int k = 0;
        while(m_domain.elements[e][k] != v)
          ++k;
        const Vector<D> hat =
          k == 0 ? Vector<D>(-rest_inverse.colwise().sum().transpose()) : Vector<D>(rest_inverse.row(k - 1).transpose());
        relaxation.add(m_domain.image_edges(e, x) * rest_inverse, hat, reference.weight(m_domain, e));
      }
      const Vector<D> origin = x.col(v);
      Vector<D> u = Vector<D>::Zero();
      relaxation.relax(u, 2, [&](const Vector<D>& displacement) {
        x.col(v) = origin + displacement;
        for(std::int64_t i = m_star_begin[v]; i < m_star_begin[v + 1]; ++i)
          if(!is_positive(m_stars[i], x))
            return false;
        return true;
      });
      x.col(v) = origin + u;
    }
  }

  // Smallest and largest signed singular value over all elements.
  std::pair<double, double> singular_value_range(const Positions<D>& x) const
  {
    const auto [low, high] = internal::singular_value_range<Tag>(m_domain, m_schedule, x);
    return {m_world.minimum(low), -m_world.minimum(-high)};
  }

private:
  // An element's Jacobian and the derivatives of the energy there.
  struct Evaluation
  {
    Signed_svd<D> svd;
    Element_state<D> state;
  };

  Evaluation evaluate(const Matrix<D>& rest_inverse, const Positions<D>& x, std::int64_t e) const
  {
    Evaluation result;
    signed_svd(Matrix<D>(m_domain.image_edges(e, x) * rest_inverse), result.svd);
    result.state.s = result.svd.s;
    m_energy.template derivatives<D>(result.state.s, result.state.gradient, result.state.hessian);
    return result;
  }

  Increment_form<D> form(const Element_state<D>& state) const
  {
    Increment_form<D> result;
    m_preconditioner.form(state, m_energy, result);
    return result;
  }

  template <typename AnyReference>
  double energy_of_element(const AnyReference& reference, std::int64_t e, const Positions<D>& x) const
  {
    const Vector<D> s = signed_singular_values(Matrix<D>(m_domain.image_edges(e, x) * reference.rest_inverse(m_domain, e)));
    if(has_barrier(m_energy) && !(s[D - 1] > 0))
      return std::numeric_limits<double>::infinity();
    return reference.weight(m_domain, e) * m_energy.template value<D>(s);
  }

  void add_derivatives_of_element(const Reference& reference, const Positions<D>& x, std::int64_t e, bool with_matrix,
                                  Eigen::VectorXd& gradient)
  {
    const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
    const double weight = reference.weight(m_domain, e);
    const Evaluation at_x = evaluate(rest_inverse, x, e);
    // Column k: the gradient of vertex k+1's hat function, turned into the frame of V.
    const Matrix<D> hats = at_x.svd.V.transpose() * rest_inverse.transpose();
    add_forces(e, at_x.svd.U * (weight * (at_x.state.gradient.asDiagonal() * hats)), gradient);
    if(with_matrix)
      scatter_blocks(e, form_blocks(m_domain.elements[e], weight, at_x.svd.U, hats, form(at_x.state)));
  }

  void add_derivatives_of_terms(const Positions<D>& x, bool with_matrix, Eigen::VectorXd& gradient)
  {
    Positions<D> term_gradient = Positions<D>::Zero(D, m_domain.number_of_vertices);
    std::function<const Matrix<D>*(std::int32_t)> projection_of;
    if(has_sliding_vertices())
      projection_of = [this](std::int32_t v) { return slides(v) ? &projection(v) : nullptr; };
    Term_matrix<D> term_matrix(m_matrix, m_unknowns.numbers(), projection_of);
    for(const auto& term : m_terms)
      term->add_derivatives(x, term_gradient, with_matrix ? &term_matrix : nullptr);
    m_terms_keep_to_stencils = !term_matrix.has_refused();
    Eigen::VectorXd unknowns;
    gather(term_gradient, unknowns);
    gradient += unknowns;
  }

  // Column k of `forces` acts on vertex k+1 of the element, minus their sum on vertex 0.
  void add_forces(std::int64_t e, const Matrix<D>& forces, Eigen::VectorXd& gradient) const
  {
    const Element& v = m_domain.elements[e];
    for(int k = 0; k < D; ++k)
      if(!is_fixed(v[k + 1]))
        gradient.template segment<D>(D * std::int64_t(m_unknowns[v[k + 1]])) += forces.col(k);
    if(!is_fixed(v[0]))
      gradient.template segment<D>(D * std::int64_t(m_unknowns[v[0]])) -= forces.rowwise().sum();
  }

  // The elements around each vertex.
  void build_stars()
  {
    m_star_begin.assign(m_domain.number_of_vertices + 1, 0);
    for(const Element& element : m_domain.elements)
      for(std::int32_t v : element)
        ++m_star_begin[v + 1];
    for(std::int32_t v = 0; v < m_domain.number_of_vertices; ++v)
      m_star_begin[v + 1] += m_star_begin[v];
    m_stars.resize(m_star_begin.back());
    std::vector<std::int64_t> next(m_star_begin.begin(), m_star_begin.end() - 1);
    for(std::int64_t e = 0; e < m_domain.number_of_elements(); ++e)
      for(std::int32_t v : m_domain.elements[e])
        m_stars[next[v]++] = static_cast<std::int32_t>(e);
  }

  // weight * (B^T H B) of one element, with B the map from its vertices' displacements to dJ. Rows sum to zero, so the blocks of
  // vertex 0 follow from the others.
  Element_blocks form_blocks(const Element& element, double weight, const Matrix<D>& U, const Matrix<D>& hats,
                             const Increment_form<D>& form) const
  {
    Element_blocks blocks;
    blocks[0][0].setZero();
    for(int k = 1; k <= D; ++k)
      blocks[0][k].setZero();
    for(int k = 0; k < D; ++k)
      for(int l = k; l < D; ++l) {
        Matrix<D>& block = blocks[k + 1][l + 1];
        block = weight * (U * form.block(hats.col(k), hats.col(l)) * U.transpose());
        blocks[0][l + 1] -= block;
        if(l != k)
          blocks[0][k + 1] -= block.transpose();
      }
    for(int k = 1; k <= D; ++k)
      blocks[0][0] -= blocks[0][k];

    if constexpr(Clamps_element_matrices<Preconditioner>::value)
      if(m_preconditioner.clamps_element_matrices)
        clamp(blocks);
    project(element, blocks);
    return blocks;
  }

  Element_blocks element_blocks(const Reference& reference, const Positions<D>& x, std::int64_t e) const
  {
    const Matrix<D>& rest_inverse = reference.rest_inverse(m_domain, e);
    const Evaluation at_x = evaluate(rest_inverse, x, e);
    return form_blocks(m_domain.elements[e], reference.weight(m_domain, e), at_x.svd.U, at_x.svd.V.transpose() * rest_inverse.transpose(),
                       form(at_x.state));
  }

  const Matrix<D>& projection(std::int32_t v) const { return m_projections[m_projection_of[v]]; }

  // Of all unknowns.
  void project(Eigen::VectorXd& unknowns) const
  {
    if(m_projections.empty())
      return;
    m_unknowns.for_each([&](std::int32_t v, std::int32_t number) {
      if(slides(v))
        unknowns.template segment<D>(D * std::int64_t(number)) = projection(v) * unknowns.template segment<D>(D * std::int64_t(number));
    });
  }

  // Restricts an element's matrix to the directions in which its vertices move. Across them a part of its diagonal remains, so that
  // the matrix of all elements stays positive definite.
  void project(const Element& element, Element_blocks& blocks) const
  {
    if(m_projections.empty())
      return;
    for(int a = 0; a <= D; ++a)
      if(slides(element[a])) {
        const Matrix<D>& P = projection(element[a]);
        for(int b = 0; b < a; ++b)
          blocks[b][a] = (blocks[b][a] * P).eval();
        for(int b = a + 1; b <= D; ++b)
          blocks[a][b] = (P * blocks[a][b]).eval();
        blocks[a][a] = (P * blocks[a][a] * P + blocks[a][a].trace() / D * (Matrix<D>::Identity() - P)).eval();
      }
  }

  // Adds the blocks of one element to the matrix.
  void scatter_blocks(std::int64_t e, const Element_blocks& blocks)
  {
    const Element& v = m_domain.elements[e];
    int p = 0;
    for(int a = 0; a <= D; ++a) {
      const std::int32_t r = m_unknowns[v[a]];
      if(r >= 0)
        m_matrix.add_block(r, r, 0, blocks[a][a]);
      for(int b = a + 1; b <= D; ++b, ++p)
        if(r >= 0 && !is_fixed(v[b]))
          m_matrix.add_block(r, m_unknowns[v[b]], m_slots[e][p], blocks[a][b]);
    }
  }

  // Projects the matrix of one element on the displacements of its vertices to the positive semidefinite ones.
  static void clamp(Element_blocks& blocks)
  {
    constexpr int SIZE = D * (D + 1);
    Eigen::MatrixXd matrix(SIZE, SIZE);
    for(int a = 0; a <= D; ++a)
      for(int b = a; b <= D; ++b) {
        matrix.template block<D, D>(D * a, D * b) = blocks[a][b];
        matrix.template block<D, D>(D * b, D * a) = blocks[a][b].transpose();
      }
    project_to_psd(matrix);
    for(int a = 0; a <= D; ++a)
      for(int b = a; b <= D; ++b)
        blocks[a][b] = matrix.template block<D, D>(D * a, D * b);
  }

  const Simplicial_domain<D>& m_domain;
  const Energy& m_energy;
  const Preconditioner& m_preconditioner;
  World m_world;
  Element_coloring m_schedule;
  Unknowns m_unknowns;
  std::vector<std::int32_t> m_projection_of; // of each vertex, if it slides; empty if none does
  std::vector<Matrix<D>> m_projections;
  std::vector<std::shared_ptr<const Objective_term<D>>> m_terms;
  bool m_terms_keep_to_stencils = true;
  Block_sparse_matrix m_matrix;
  std::vector<std::array<std::int32_t, PAIRS>> m_slots;
  std::vector<std::int64_t> m_star_begin; // among m_stars, for each vertex
  std::vector<std::int32_t> m_stars;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_MAP_OBJECTIVE_H
