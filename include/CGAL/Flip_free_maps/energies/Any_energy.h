// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ENERGIES_ANY_ENERGY_H
#define CGAL_FLIP_FREE_MAPS_ENERGIES_ANY_ENERGY_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/internal/energy_traits.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsEnergies
/// An energy that is chosen at run time: it holds a model of `DistortionEnergy` whose type it forgets, so that one
/// instantiation of an algorithm serves all energies. Copies share the energy they hold, which does not change.
///
/// \cgalModels{DistortionEnergy}
class Any_energy
{
public:
  /// Not all energies that it may hold have one; see `holds_barrier()`.
  static constexpr bool has_barrier = false;

  /// "any", the same for all objects; see `energy_name()`.
  static const char* name() { return "any"; }

  /// Holds a `Symmetric_dirichlet`.
  Any_energy();

  /// Holds a copy of `energy`.
  /// \tparam Energy must be a model of `DistortionEnergy` for both dimensions
  template <typename Energy, typename = std::enable_if_t<!std::is_same<Energy, Any_energy>::value>>
  explicit Any_energy(const Energy& energy) : m_energy(std::make_shared<Model<Energy>>(energy))
  {}

  /// The name of the energy that is held.
  std::string energy_name() const { return m_energy->name(); }

  /// Whether what is held is an `Energy` itself. An object of a class derived from it is not: it may be another function.
  template <typename Energy>
  bool holds() const
  {
    return dynamic_cast<const Model<Energy>*>(m_energy.get()) != nullptr;
  }

  /// Whether the energy that is held has a barrier.
  bool holds_barrier() const { return m_energy->holds_barrier(); }

  /// Whether `Composite_majorization` can be used: whether the energy that is held has a convex part or a composition of its own.
  bool is_convex_concave() const { return m_energy->is_convex_concave(); }

  /// psi at the singular values `s`.
  template <int D>
  double value(const Eigen::Matrix<double, D, 1>& s) const
  {
    return m_energy->value(s);
  }

  /// First and second derivatives of psi in the singular values.
  template <int D>
  void derivatives(const Eigen::Matrix<double, D, 1>& s, Eigen::Matrix<double, D, 1>& gradient, Eigen::Matrix<double, D, D>& hessian) const
  {
    m_energy->derivatives(s, gradient, hessian);
  }

  /// The singular values that `Slim` leads to.
  template <int D>
  Eigen::Matrix<double, D, 1> slim_target(const Eigen::Matrix<double, D, 1>& s) const
  {
    return m_energy->slim_target(s);
  }

  /// The Hessian of the convex part. \pre `is_convex_concave()`
  template <int D>
  void convex_hessian(const Eigen::Matrix<double, D, 1>& s, const Eigen::Matrix<double, D, D>& hessian,
                      Eigen::Matrix<double, D, D>& convex) const
  {
    static_assert(D == 2, "convex parts are asked for in the plane");
    m_energy->convex_hessian(s, hessian, convex);
  }

  /// Compositions exist in the plane.
  template <int D>
  static constexpr bool has_composite_form = D == 2;

  /// Writes the majorizer of the composition of the energy that is held; `false` if it has none.
  template <int D>
  bool composite_form(const Element_state<D>& state, Increment_form<D>& form) const
  {
    return m_energy->composite_form(state, form);
  }

private:
  struct Base
  {
    virtual ~Base() = default;
    virtual const char* name() const = 0;
    virtual bool holds_barrier() const = 0;
    virtual bool is_convex_concave() const = 0;
    virtual void convex_hessian(const Eigen::Vector2d& s, const Eigen::Matrix2d& hessian, Eigen::Matrix2d& convex) const = 0;
    virtual bool composite_form(const Element_state<2>& state, Increment_form<2>& form) const = 0;
    virtual double value(const Eigen::Vector2d& s) const = 0;
    virtual double value(const Eigen::Vector3d& s) const = 0;
    virtual void derivatives(const Eigen::Vector2d& s, Eigen::Vector2d& gradient, Eigen::Matrix2d& hessian) const = 0;
    virtual void derivatives(const Eigen::Vector3d& s, Eigen::Vector3d& gradient, Eigen::Matrix3d& hessian) const = 0;
    virtual Eigen::Vector2d slim_target(const Eigen::Vector2d& s) const = 0;
    virtual Eigen::Vector3d slim_target(const Eigen::Vector3d& s) const = 0;
  };

  template <typename Energy>
  struct Model final : Base
  {
    explicit Model(const Energy& e) : energy(e) {}
    const char* name() const override { return Energy::name(); }
    bool holds_barrier() const override { return internal::has_barrier(energy); }
    bool is_convex_concave() const override
    {
      return internal::Has_convex_hessian<Energy, 2>::value || internal::Has_composite_form<Energy, 2>::value;
    }
    void convex_hessian(const Eigen::Vector2d& s, const Eigen::Matrix2d& hessian, Eigen::Matrix2d& convex) const override
    {
      if constexpr(internal::Has_convex_hessian<Energy, 2>::value)
        energy.template convex_hessian<2>(s, hessian, convex);
      else
        convex = hessian;
    }
    bool composite_form(const Element_state<2>& state, Increment_form<2>& form) const override
    {
      if constexpr(internal::Has_composite_form<Energy, 2>::value)
        return energy.template composite_form<2>(state, form);
      else
        return false;
    }
    double value(const Eigen::Vector2d& s) const override { return energy.template value<2>(s); }
    double value(const Eigen::Vector3d& s) const override { return energy.template value<3>(s); }
    void derivatives(const Eigen::Vector2d& s, Eigen::Vector2d& gradient, Eigen::Matrix2d& hessian) const override
    {
      energy.template derivatives<2>(s, gradient, hessian);
    }
    void derivatives(const Eigen::Vector3d& s, Eigen::Vector3d& gradient, Eigen::Matrix3d& hessian) const override
    {
      energy.template derivatives<3>(s, gradient, hessian);
    }
    Eigen::Vector2d slim_target(const Eigen::Vector2d& s) const override { return internal::slim_target<2>(energy, s); }
    Eigen::Vector3d slim_target(const Eigen::Vector3d& s) const override { return internal::slim_target<3>(energy, s); }

    Energy energy;
  };

  std::shared_ptr<const Base> m_energy;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/energies/Any_energy_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ENERGIES_ANY_ENERGY_H
