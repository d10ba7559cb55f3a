// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_VERTEX_RELAXATION_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_VERTEX_RELAXATION_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/minimizer/line_search.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Newton steps of one vertex, for the class below.
template <int D, typename Relaxation, typename IsPositive>
void take_newton_steps(const Relaxation& relaxation, Vector<D>& u, int steps, IsPositive&& is_positive)
{
  const Map_options options;
  double energy = relaxation.energy_at(u);
  for(int step = 0; step < steps && std::isfinite(energy); ++step) {
    Vector<D> gradient, direction;
    if(!relaxation.newton_direction(u, gradient, direction))
      return;
    const double slope = gradient.dot(direction);
    if(!(slope < -1e-4 * energy))
      return;
    const Line_search_result found = line_search([&](double a) { return relaxation.energy_at(u + a * direction); }, energy, slope,
                                                 relaxation.largest_step(u, direction), false, options);
    const Vector<D> next = u + found.step * direction;
    if(!found.success || !is_positive(next))
      return;
    u = next;
    energy = found.energy;
  }
}

// Moves one vertex of a map to where the energy of the elements around it is least, by Newton steps that never flip one. When the
// vertex moves by u, the Jacobian of an element around it changes by u times the gradient of the vertex' hat function,
// transposed: it is affine in u, and its determinant too.
template <int D, typename Energy>
class Vertex_relaxation
{
public:
  explicit Vertex_relaxation(const Energy& energy) : m_energy(energy) {}

  // Begins with a new vertex.
  void clear() { m_elements.clear(); }

  // Enters an element around the vertex.
  void add(const Matrix<D>& jacobian, const Vector<D>& hat, double weight) { m_elements.push_back({jacobian, hat, weight}); }

  // The energy of the elements around the vertex, infinite where one is not positive.
  double energy_at(const Vector<D>& u) const
  {
    double sum = 0;
    for(const Element& element : m_elements) {
      const Vector<D> s = signed_singular_values(element.jacobian_at(u));
      if(!(s[D - 1] > 0))
        return std::numeric_limits<double>::infinity();
      sum += element.weight * m_energy.template value<D>(s);
    }
    return sum;
  }

  // Takes up to `steps` Newton steps from the displacement `u`, at which all elements are positive. `is_positive(u)` has the last
  // word on each.
  template <typename IsPositive>
  void relax(Vector<D>& u, int steps, IsPositive&& is_positive) const
  {
    take_newton_steps<D>(*this, u, steps, is_positive);
  }

  // The Newton direction, if there is one, and the gradient.
  bool newton_direction(const Vector<D>& u, Vector<D>& gradient, Vector<D>& direction) const
  {
    Matrix<D> hessian;
    derivatives_at(u, gradient, hessian);
    hessian.diagonal() *= 1 + 1e-9;
    direction = -hessian.inverse() * gradient;
    return true;
  }

  // The step at which the first element collapses: det(J + a d g^T) = det J (1 + a g^T J^-1 d).
  double largest_step(const Vector<D>& u, const Vector<D>& direction) const
  {
    double slope = 0;
    for(const Element& element : m_elements)
      slope = (std::min)(slope, element.hat.dot(element.jacobian_at(u).inverse() * direction));
    return slope < 0 ? -1 / slope : std::numeric_limits<double>::infinity();
  }

private:
  struct Element
  {
    Matrix<D> jacobian; // at displacement 0
    Vector<D> hat;
    double weight;

    Matrix<D> jacobian_at(const Vector<D>& u) const { return jacobian + u * hat.transpose(); }
  };

  void derivatives_at(const Vector<D>& u, Vector<D>& gradient, Matrix<D>& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
    for(const Element& element : m_elements) {
      Signed_svd<D> svd;
      signed_svd(element.jacobian_at(u), svd);
      Element_state<D> state;
      state.s = svd.s;
      m_energy.template derivatives<D>(state.s, state.gradient, state.hessian);
      Increment_form<D> form;
      Projected_newton().form(state, m_energy, form);
      const Vector<D> hat = svd.V.transpose() * element.hat;
      gradient += element.weight * (svd.U * state.gradient.cwiseProduct(hat));
      hessian += element.weight * (svd.U * form.block(hat, hat) * svd.U.transpose());
    }
  }

  const Energy& m_energy;
  std::vector<Element> m_elements;
};

// The same for the symmetric Dirichlet energy in the plane, |J|^2 (1 + 1 / det(J)^2) / 4: |J|^2 is a quadratic function of u, and
// no singular values are needed.
template <>
class Vertex_relaxation<2, Symmetric_dirichlet>
{
public:
  explicit Vertex_relaxation(const Symmetric_dirichlet&) {}

  void clear() { m_elements.clear(); }

  void add(const Matrix<2>& J, const Vector<2>& hat, double weight)
  {
    const Vector<2> cofactors(J(1, 1) * hat[0] - J(1, 0) * hat[1], J(0, 0) * hat[1] - J(0, 1) * hat[0]);
    m_elements.push_back({0.25 * weight, J.squaredNorm(), hat.squaredNorm(), J.determinant(), J * hat, cofactors});
  }

  double energy_at(const Vector<2>& u) const
  {
    double sum = 0;
    for(const Element& element : m_elements) {
      const double determinant = element.determinant_at(u);
      if(!(determinant > 0))
        return std::numeric_limits<double>::infinity();
      sum += element.weight * element.square_at(u) * (1 + 1 / (determinant * determinant));
    }
    return sum;
  }

  template <typename IsPositive>
  void relax(Vector<2>& u, int steps, IsPositive&& is_positive) const
  {
    take_newton_steps<2>(*this, u, steps, is_positive);
  }

  bool newton_direction(const Vector<2>& u, Vector<2>& gradient, Vector<2>& direction) const
  {
    Matrix<2> hessian;
    derivatives_at(u, gradient, hessian);
    if(!make_positive(hessian))
      return false;
    direction << hessian(0, 1) * gradient[1] - hessian(1, 1) * gradient[0], hessian(0, 1) * gradient[0] - hessian(0, 0) * gradient[1];
    direction /= hessian.determinant();
    return true;
  }

  double largest_step(const Vector<2>& u, const Vector<2>& direction) const
  {
    double slope = 0;
    for(const Element& element : m_elements)
      slope = (std::min)(slope, element.determinant_slope.dot(direction) / element.determinant_at(u));
    return slope < 0 ? -1 / slope : std::numeric_limits<double>::infinity();
  }

private:
  struct Element
  {
    double weight;          // times 1/4
    double square;          // |J|^2 at displacement 0
    double hat;             // half the second derivative of |J|^2
    double determinant;     // at displacement 0
    Vector<2> square_slope; // half the gradient of |J|^2 at displacement 0
    Vector<2> determinant_slope;

    double square_at(const Vector<2>& u) const { return square + 2 * u.dot(square_slope) + hat * u.squaredNorm(); }
    double determinant_at(const Vector<2>& u) const { return determinant + u.dot(determinant_slope); }
  };

  void derivatives_at(const Vector<2>& u, Vector<2>& gradient, Matrix<2>& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
    for(const Element& element : m_elements) {
      const double inverse = 1 / element.determinant_at(u), factor = element.weight * (1 + inverse * inverse);
      const double cube = element.weight * inverse * inverse * inverse, square = element.square_at(u);
      const Vector<2> slope = 2 * (element.square_slope + element.hat * u), &normal = element.determinant_slope;
      gradient += factor * slope - 2 * cube * square * normal;
      const Vector<2> mixed = 3 * cube * square * inverse * normal - 2 * cube * slope;
      hessian(0, 0) += 2 * (factor * element.hat + mixed[0] * normal[0]);
      hessian(1, 1) += 2 * (factor * element.hat + mixed[1] * normal[1]);
      hessian(0, 1) += mixed[0] * normal[1] + mixed[1] * normal[0];
    }
  }

  // A negative eigenvalue changes its sign. Only the upper triangle is used.
  static bool make_positive(Matrix<2>& hessian)
  {
    const double mean = 0.5 * (hessian(0, 0) + hessian(1, 1)), half = 0.5 * (hessian(0, 0) - hessian(1, 1));
    const double radius = std::sqrt(half * half + hessian(0, 1) * hessian(0, 1));
    if(!(mean > 0))
      return false;
    if(mean < radius) {
      hessian *= mean / radius;
      hessian.diagonal().array() += (radius + mean) * (radius - mean) / radius;
    }
    hessian.diagonal() *= 1 + 1e-9;
    hessian(1, 0) = hessian(0, 1);
    return true;
  }

  std::vector<Element> m_elements;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_VERTEX_RELAXATION_H
