// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_H

#include <CGAL/Flip_free_maps/elements/Increment_form.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/preconditioners/Adaptive_preconditioner.h>
#include <CGAL/Flip_free_maps/preconditioners/Iteration_state.h>

#include <memory>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsPreconditioners
/// A preconditioner that is chosen at run time, for energies of type `Any_energy`:
/// one instantiation of the minimizer serves all methods.
///
/// \cgalModels{Preconditioner}
class Any_preconditioner
{
public:
  using Category = Varying_matrix_tag;        ///< see `is_constant()`
  static const char* name() { return "any"; } ///< "any"; see `preconditioner_name()`

  bool is_second_order;         ///< whether full steps of the preconditioner that is held are natural
  bool clamps_element_matrices; ///< whether each element's matrix is to be projected to the positive semidefinite ones

  /// Holds an `Adaptive_preconditioner`.
  Any_preconditioner();

  /// Holds a copy of `preconditioner`.
  /// \tparam Preconditioner must be a model of `Preconditioner`; with those of the plane only, runs in space end with
  ///   `Status::invalid_option`
  template <typename Preconditioner, typename = std::enable_if_t<!std::is_same<Preconditioner, Any_preconditioner>::value>>
  explicit Any_preconditioner(const Preconditioner& preconditioner)
    : is_second_order(preconditioner.is_second_order),
      clamps_element_matrices(internal::clamps_element_matrices(preconditioner)),
      m_preconditioner(std::make_unique<Model<Preconditioner>>(preconditioner))
  {}

  /// Copies what is held.
  Any_preconditioner(const Any_preconditioner& other)
    : is_second_order(other.is_second_order),
      clamps_element_matrices(other.clamps_element_matrices),
      m_preconditioner(other.m_preconditioner->clone())
  {}

  /// Copies what is held.
  Any_preconditioner& operator=(const Any_preconditioner& other)
  {
    is_second_order = other.is_second_order;
    clamps_element_matrices = other.clamps_element_matrices;
    m_preconditioner = other.m_preconditioner->clone();
    return *this;
  }

  /// The name of the preconditioner that is held.
  std::string preconditioner_name() const { return m_preconditioner->name(); }

  /// Whether its matrix is the same in every iteration.
  bool is_constant() const { return m_preconditioner->is_constant(); }

  /// Whether it works in the plane only.
  bool is_planar() const { return m_preconditioner->is_planar(); }

  /// Passed on.
  void begin_iteration(const Iteration_state& state) { m_preconditioner->begin_iteration(state); }

  /// Passed on.
  bool can_retreat() const { return m_preconditioner->can_retreat(); }

  /// Passed on.
  void retreat() { m_preconditioner->retreat(); }

  /// Writes the form for one element.
  template <int D>
  void form(const Element_state<D>& state, const Any_energy& energy, Increment_form<D>& form) const
  {
    m_preconditioner->form(state, energy, form);
  }

private:
  struct Base
  {
    virtual ~Base() = default;
    virtual std::unique_ptr<Base> clone() const = 0;
    virtual const char* name() const = 0;
    virtual bool is_constant() const = 0;
    virtual bool is_planar() const = 0;
    virtual void begin_iteration(const Iteration_state& state) = 0;
    virtual bool can_retreat() const = 0;
    virtual void retreat() = 0;
    virtual void form(const Element_state<2>& state, const Any_energy& energy, Increment_form<2>& form) const = 0;
    virtual void form(const Element_state<3>& state, const Any_energy& energy, Increment_form<3>& form) const = 0;
  };

  template <typename Preconditioner>
  struct Model final : Base
  {
    explicit Model(const Preconditioner& p) : preconditioner(p) {}
    std::unique_ptr<Base> clone() const override { return std::make_unique<Model>(*this); }
    const char* name() const override { return Preconditioner::name(); }
    bool is_constant() const override { return internal::is_constant(preconditioner); }
    bool is_planar() const override { return internal::Is_planar<Preconditioner>::value; }
    void begin_iteration(const Iteration_state& state) override { internal::begin_iteration(preconditioner, state); }
    bool can_retreat() const override { return internal::can_retreat(preconditioner); }
    void retreat() override { internal::retreat(preconditioner); }
    void form(const Element_state<2>& state, const Any_energy& energy, Increment_form<2>& form) const override
    {
      preconditioner.form(state, energy, form);
    }
    void form(const Element_state<3>& state, const Any_energy& energy, Increment_form<3>& form) const override
    {
      // A planar one in space is refused before.
      if constexpr(!internal::Is_planar<Preconditioner>::value)
        preconditioner.form(state, energy, form);
    }

    Preconditioner preconditioner;
  };

  std::unique_ptr<Base> m_preconditioner;
};

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/preconditioners/Any_preconditioner_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_H
