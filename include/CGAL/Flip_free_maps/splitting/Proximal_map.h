// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_PROXIMAL_MAP_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_PROXIMAL_MAP_H

#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/elements/internal/project_to_psd.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/method/concepts.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_errors.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <boost/concept_check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether an energy brings its own `proximal()`.
template <typename Energy, int D, typename = void>
struct Has_proximal : std::false_type
{};

template <typename Energy, int D>
struct Has_proximal<Energy, D,
                    std::void_t<decltype(std::declval<const Energy&>().template proximal<D>(std::declval<const Vector<D>&>(), 0.))>>
  : std::true_type
{};

// Whether an energy is chosen at run time.
template <typename Energy, typename = void>
struct Holds_energy : std::false_type
{};

template <typename Energy>
struct Holds_energy<Energy, std::void_t<decltype(std::declval<const Energy&>().energy_name())>> : std::true_type
{};

// The positive root of a p^4 - q p^3 - k = 0 for a, k > 0. Newton's method decreases monotonically from an upper bound, since the
// polynomial is increasing and convex above the root; it ends where rounding stops it.
inline double positive_root(double a, double q, double k)
{
  const double fourth_root = std::sqrt(std::sqrt(k / a));
  double p = q > 0 ? q / a + fourth_root : (std::min)(fourth_root, std::cbrt(k / -q));
  for(int i = 0; i < 100; ++i) {
    const double square = p * p;
    const double value = (a * p - q) * square * p - k, slope = (4 * a * p - 3 * q) * square;
    const double next = p - value / slope;
    if(!(next < p * (1 - 4e-16)))
      break;
    p = next;
  }
  return p;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Energy` is a model of `ProximalEnergy` for maps of dimension `D`.
template <typename Energy, int D>
struct ProximalEnergyConcept : DistortionEnergyConcept<Energy, D>
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(ProximalEnergyConcept)
  {
    using Vector = internal::Vector<D>;
    static_assert(internal::gives<Vector, const Energy&, const Vector&, double>(
                    [](auto& e, auto& q, double c) -> decltype(e.template proximal<D>(q, c)) {}),
                  "ProximalEnergy: proximal<D>(q, c) const must return singular values");
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsConcepts
/// Checks that `Step` is a model of `SplittingStep` for maps of dimension `D` and a given energy.
template <typename Step, typename Energy, int D>
struct SplittingStepConcept
{
  /// \cond SKIP_IN_MANUAL
  BOOST_CONCEPT_USAGE(SplittingStepConcept)
  {
    using internal::gives;
    using Matrix = internal::Matrix<D>;
    using Element = typename Step::Element;
    static_assert(gives<std::string, const Step&>([](auto& s) -> decltype(std::decay_t<decltype(s)>::name()) {}),
                  "SplittingStep: a static function name() must return the name of the step");
    static_assert(std::is_constructible<Step, const Energy&, const Splitting_options&>::value,
                  "SplittingStep: the constructor must take an energy and Splitting_options");
    static_assert(std::is_default_constructible<Element>::value && std::is_copy_constructible<Element>::value,
                  "SplittingStep: Element must be default and copy constructible");
    static_assert(gives<Matrix&, Element&>([](auto& element) -> decltype((element.jacobian)) {}),
                  "SplittingStep: Element::jacobian must be a matrix");
    static_assert(gives<double, const Element&>([](auto& element) -> decltype((element.penalty)) {}),
                  "SplittingStep: Element::penalty must be a number");
    static_assert(gives<void, const Step&, const Matrix&, Element&>(
                    [](auto& s, auto& j, auto& element) -> decltype(s.start(j, double(), bool(), element)) {}),
                  "SplittingStep: start(jacobian, measure, ..., element) const is missing");
    static_assert(
      gives<void, const Step&, const Matrix&, Element&, Splitting_errors&>(
        [](auto& s, auto& j, auto& element, auto& errors) -> decltype(s.update(j, double(), bool(), bool(), element, errors)) {}),
      "SplittingStep: update(jacobian, measure, ..., element, errors) const is missing");
    static_assert(
      gives<Matrix, const Step&, const Element&>([](auto& s, auto& element) -> decltype(std::decay_t<decltype(s)>::pull(element)) {}),
      "SplittingStep: a static function pull(element) must return a matrix");
  }
  /// \endcond
};

/// \ingroup PkgFlipFreeMapsSplitting
/// The energies whose proximal maps have closed forms.
enum class Closed_form
{
  none,               ///< another energy
  symmetric_gradient, ///< the root of a quadratic equation
  symmetric_dirichlet ///< the root of a quartic equation
};

/// \ingroup PkgFlipFreeMapsSplitting
/// What the splitting needs to know of an energy psi beyond `DistortionEnergy`. It is written for f = psi / `scale()`, whose
/// Hessian at the identity is about that of |J|^2, so that penalties mean the same for all energies.
///
/// This general class takes any energy that is convex in the singular values: its proximal map is the energy's own `proximal()`
/// if it is a model of `ProximalEnergy`, and found by a damped Newton's method otherwise; where psi is not convex, a stationary
/// point. An `Any_energy` that holds one of the energies with closed forms is treated as that energy.
template <typename Energy, int D>
class Proximal_map
{
  using Vector = internal::Vector<D>;
  using Matrix = internal::Matrix<D>;

public:
  /// Keeps a copy of the energy.
  explicit Proximal_map(const Energy& energy = Energy()) : m_energy(energy)
  {
    if constexpr(internal::Holds_energy<Energy>::value)
      m_closed_form = m_energy.template holds<Symmetric_gradient>()    ? Closed_form::symmetric_gradient
                      : m_energy.template holds<Symmetric_dirichlet>() ? Closed_form::symmetric_dirichlet
                                                                       : Closed_form::none;
    if(m_closed_form != Closed_form::none) {
      m_scale = m_closed_form == Closed_form::symmetric_gradient ? Gradient::scale() : Dirichlet::scale();
      return;
    }
    Vector gradient;
    Matrix hessian;
    m_energy.template derivatives<D>(Vector::Ones(), gradient, hessian);
    const double mean = hessian.trace() / (2 * D);
    m_scale = mean > 0 && std::isfinite(mean) ? mean : 1;
  }

  /// Which closed form is used.
  Closed_form closed_form() const { return m_closed_form; }

  /// psi / f.
  double scale() const { return m_scale; }

  /// The least eigenvalue of a stretch in the beginning.
  double floor() const { return m_closed_form == Closed_form::symmetric_dirichlet ? Dirichlet::floor() : Gradient::floor(); }

  /// The positive p with the least c f(p) + 1/2 |p - q|^2; q in descending order.
  Vector proximal(const Vector& q, double c) const
  {
    if(m_closed_form != Closed_form::none)
      return m_closed_form == Closed_form::symmetric_gradient ? Gradient::proximal(q, c) : Dirichlet::proximal(q, c);
    if constexpr(internal::Has_proximal<Energy, D>::value)
      return m_energy.template proximal<D>(q, c / m_scale);
    else
      return newton(q, c / m_scale);
  }

  /// |grad f(p)|^2
  double squared_gradient(const Vector& p) const
  {
    if(m_closed_form != Closed_form::none)
      return m_closed_form == Closed_form::symmetric_gradient ? Gradient::squared_gradient(p) : Dirichlet::squared_gradient(p);
    Vector gradient;
    Matrix hessian;
    m_energy.template derivatives<D>(p, gradient, hessian);
    return gradient.squaredNorm() / (m_scale * m_scale);
  }

  /// A Lipschitz constant of grad f around p, from the squared norm of grad f(p).
  double lipschitz(const Vector& p, double squared_gradient) const
  {
    if(m_closed_form != Closed_form::none)
      return m_closed_form == Closed_form::symmetric_gradient ? Gradient::lipschitz(p, squared_gradient)
                                                              : Dirichlet::lipschitz(p, squared_gradient);
    Vector gradient;
    Matrix hessian;
    m_energy.template derivatives<D>(p, gradient, hessian);
    return (std::max)(1., hessian.norm() / m_scale);
  }

private:
  using Gradient = Proximal_map<Symmetric_gradient, D>;
  using Dirichlet = Proximal_map<Symmetric_dirichlet, D>;

  Vector newton(const Vector& q, double c) const
  {
    const double smallest = std::numeric_limits<double>::epsilon();
    const auto objective = [&](const Vector& p) { return c * m_energy.template value<D>(p) + 0.5 * (p - q).squaredNorm(); };
    Vector p = q.cwiseMax(1e-3), gradient;
    double value = objective(p);
    if(!std::isfinite(value)) {
      p.setOnes();
      value = objective(p);
    }
    for(int i = 0; i < 100; ++i) {
      Matrix hessian;
      m_energy.template derivatives<D>(p, gradient, hessian);
      gradient = c * gradient + p - q;
      internal::project_to_psd(hessian);
      hessian *= c;
      hessian.diagonal().array() += 1;
      const Vector direction = -(hessian.inverse() * gradient);
      const double slope = gradient.dot(direction);
      if(!(slope < 0))
        break;
      // Positive values stay positive; those that end at the bound are clamped for energies that are finite there.
      bool is_better = false;
      Vector trial;
      for(double step = 1; step > 1e-10 && !is_better; step *= 0.5) {
        trial = (p + step * direction).cwiseMax((0.01 * p).cwiseMax(smallest));
        const double trial_value = objective(trial);
        is_better = trial_value < value;
        if(is_better)
          value = trial_value;
      }
      const double change = is_better ? (trial - p).cwiseAbs().maxCoeff() : 0;
      if(is_better)
        p = trial;
      if(change <= 1e-14 * p.maxCoeff())
        break;
    }
    return p;
  }

  Energy m_energy;
  double m_scale;
  Closed_form m_closed_form = Closed_form::none;
};

/// \ingroup PkgFlipFreeMapsSplitting
/// The symmetric gradient energy: f = psi, grad f(P) = P - P^-1, the proximal map is the root of a quadratic equation (Stein, Li
/// and Solomon 2022, eq. 28).
template <int D>
class Proximal_map<Symmetric_gradient, D>
{
  using Vector = internal::Vector<D>;

public:
  /// The energy has no settings to keep.
  explicit Proximal_map(const Symmetric_gradient& = Symmetric_gradient()) {}

  /// Which closed form is used.
  static constexpr Closed_form closed_form() { return Closed_form::symmetric_gradient; }

  /// psi / f.
  static double scale() { return 1; }
  /// The least eigenvalue of a stretch in the beginning.
  static double floor() { return std::sqrt(std::sqrt(std::numeric_limits<double>::epsilon())); }

  /// The positive p with the least c f(p) + 1/2 |p - q|^2; q in descending order.
  static Vector proximal(const Vector& q, double c)
  {
    Vector p;
    for(int i = 0; i < D; ++i) {
      // Either form of the root adds numbers of equal sign.
      const double root = std::sqrt(q[i] * q[i] + 4 * c * (c + 1));
      p[i] = q[i] > 0 ? (q[i] + root) / (2 * (c + 1)) : 2 * c / (root - q[i]);
    }
    return p;
  }

  /// |grad f(p)|^2
  static double squared_gradient(const Vector& p) { return (p - p.cwiseInverse()).squaredNorm(); }

  /// A Lipschitz constant of grad f around p, from |grad f(p)|^2:
  /// 1 + sqrt(D) / x^2 where x, which bounds the eigenvalues from below, is the positive root of x^2 + b x = 1.
  static double lipschitz(const Vector&, double squared_gradient)
  {
    const double b = std::sqrt(5 * (1 + squared_gradient));
    const double x = 2 / (b + std::sqrt(b * b + 4));
    return 1 + std::sqrt(static_cast<double>(D)) / (x * x);
  }
};

/// \ingroup PkgFlipFreeMapsSplitting
/// The symmetric Dirichlet energy: f = D psi = 1/2 |P|^2 + 1/2 |P^-1|^2, grad f(P) = P - P^-3, the proximal map is the root of a
/// quartic equation (Stein, Li and Solomon 2022, eq. 29).
template <int D>
class Proximal_map<Symmetric_dirichlet, D>
{
  using Vector = internal::Vector<D>;

public:
  /// The energy has no settings to keep.
  explicit Proximal_map(const Symmetric_dirichlet& = Symmetric_dirichlet()) {}

  /// Which closed form is used.
  static constexpr Closed_form closed_form() { return Closed_form::symmetric_dirichlet; }

  /// psi / f.
  static double scale() { return 1. / D; }
  /// The least eigenvalue of a stretch in the beginning.
  static double floor() { return std::sqrt(Proximal_map<Symmetric_gradient, D>::floor()); }

  /// The positive p with the least c f(p) + 1/2 |p - q|^2; q in descending order.
  static Vector proximal(const Vector& q, double c)
  {
    Vector p;
    for(int i = 0; i < D; ++i)
      p[i] = internal::positive_root(c + 1, q[i], c);
    return p;
  }

  /// |grad f(p)|^2
  static double squared_gradient(const Vector& p) { return (p.array() - p.array().cube().inverse()).matrix().squaredNorm(); }

  /// A Lipschitz constant of grad f around p, from |grad f(p)|^2:
  /// 1 + 3 sqrt(D) / x^4 where x, which bounds the eigenvalues from below, is the positive root of x^4 + b x^3 = 1.
  static double lipschitz(const Vector&, double squared_gradient)
  {
    const double x = internal::positive_root(1, -std::sqrt(5 * (1 + squared_gradient)), 1);
    return 1 + 3 * std::sqrt(static_cast<double>(D)) / (x * x * x * x);
  }
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_PROXIMAL_MAP_H
