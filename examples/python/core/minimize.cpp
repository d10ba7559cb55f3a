// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors
// The minimizer on flat arrays, with an energy and a term that may be functions of Python. These see all elements at once.

#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/constraints/Objective_term.h>
#include <CGAL/Flip_free_maps/core/compiled_minimizers.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/minimizer/internal/characteristic_gradient.h>
#include <CGAL/Flip_free_maps/preconditioners/Projected_newton.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using FFM::internal::Matrix;
using FFM::internal::Vector;

// Numbers that a function of Python has returned, of the shape that is asked for.
class Returned
{
public:
  Returned(const py::handle& object, const std::vector<py::ssize_t>& shape, const char* what)
    : m_array(py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(object))
  {
    if(!m_array)
      throw py::error_already_set();
    bool fits = m_array.ndim() == static_cast<py::ssize_t>(shape.size());
    for(std::size_t k = 0; fits && k < shape.size(); ++k)
      fits = m_array.shape(k) == shape[k];
    if(!fits)
      throw py::value_error(std::string(what) + " has the wrong shape");
  }

  const double* data() const { return m_array.data(); }

private:
  py::array_t<double, py::array::c_style | py::array::forcecast> m_array;
};

// A function of Python as a part of what is minimised. What it raises ends the run.
class Function
{
public:
  Function(py::object function, Watch& watch) : m_function(std::move(function)), m_watch(watch) {}

  // Calls `function(argument, with_derivatives)` and hands what it returns to `use`; `false` if something was raised. The
  // argument is made with the interpreter's lock.
  template <typename Argument, typename Use>
  bool operator()(Argument&& argument, bool with_derivatives, Use&& use) const
  {
    if(m_watch.has_error())
      return false;
    const py::gil_scoped_acquire lock;
    try {
      use(m_function(argument(), with_derivatives));
      return true;
    } catch(py::error_already_set& error) {
      m_watch.keep(error);
    } catch(const py::cast_error&) {
      keep(PyExc_TypeError, "a function of Python has returned something of the wrong type");
    } catch(const py::builtin_exception& error) {
      error.set_error();
      m_watch.keep(py::error_already_set());
    } catch(const std::bad_alloc&) {
      keep(PyExc_MemoryError, "memory was exhausted");
    } catch(const std::exception& error) {
      keep(PyExc_RuntimeError, error.what());
    }
    return false;
  }

private:
  void keep(PyObject* type, const char* message) const
  {
    PyErr_SetString(type, message);
    m_watch.keep(py::error_already_set());
  }

  py::object m_function;
  Watch& m_watch;
};

// The mean of psi, a function of the signed singular values of all elements, as a term; the minimizer's own energy is 0 then. Its
// matrix is that of `Projected_newton`.
template <int D>
class Mean_energy : public FFM::Objective_term<D>
{
public:
  Mean_energy(const FFM::Simplicial_domain<D>& domain, const Function& function) : m_domain(domain), m_function(function) {}

  bool is_rigid_motion_invariant() const override { return true; }

  // Pairs of vertices of an element have their places in the matrix already.
  std::vector<std::vector<std::int32_t>> stencils() const override { return {}; }

  double value(const FFM::Positions<D>& x) const override
  {
    const std::int64_t n = m_domain.number_of_elements();
    std::vector<std::array<double, D>> s(n);
    for(std::int64_t e = 0; e < n; ++e) {
      const Vector<D> values = FFM::internal::signed_singular_values(m_domain.jacobian(e, x));
      if(!(values[D - 1] > 0))
        return std::numeric_limits<double>::infinity();
      Eigen::Map<Vector<D>>(s[e].data()) = values;
    }
    double sum = 0;
    const bool done = m_function([&] { return array_of(s); }, false,
                                 [&](const py::object& result) {
                                   const Returned psi(result, {n}, "the energy");
                                   for(std::int64_t e = 0; e < n; ++e)
                                     sum += m_domain.measures[e] * psi.data()[e];
                                 });
    return done && !std::isnan(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  void add_derivatives(const FFM::Positions<D>& x, FFM::Positions<D>& gradient, FFM::Term_matrix<D>* matrix) const override
  {
    const std::int64_t n = m_domain.number_of_elements();
    std::vector<FFM::internal::Signed_svd<D>> svd(n);
    std::vector<std::array<double, D>> s(n);
    for(std::int64_t e = 0; e < n; ++e) {
      FFM::internal::signed_svd(m_domain.jacobian(e, x), svd[e]);
      Eigen::Map<Vector<D>>(s[e].data()) = svd[e].s;
    }
    std::vector<FFM::Element_state<D>> states;
    if(derivatives(s, states))
      for(std::int64_t e = 0; e < n; ++e)
        add_element(e, svd[e], states[e], gradient, matrix);
  }

  // The energy's derivatives at the identity.
  bool at_identity(FFM::Element_state<D>& state) const
  {
    std::vector<std::array<double, D>> s(1);
    s[0].fill(1);
    std::vector<FFM::Element_state<D>> states;
    if(!derivatives(s, states))
      return false;
    state = states[0];
    return true;
  }

private:
  bool derivatives(const std::vector<std::array<double, D>>& s, std::vector<FFM::Element_state<D>>& states) const
  {
    const py::ssize_t n = static_cast<py::ssize_t>(s.size());
    return m_function([&] { return array_of(s); }, true,
                      [&](const py::object& result) {
                        const auto parts = result.cast<std::tuple<py::object, py::object, py::object>>();
                        const Returned gradients(std::get<1>(parts), {n, D}, "the gradient of the energy");
                        const Returned hessians(std::get<2>(parts), {n, D, D}, "the Hessian of the energy");
                        states.resize(s.size());
                        for(py::ssize_t e = 0; e < n; ++e) {
                          states[e].s = Eigen::Map<const Vector<D>>(s[e].data());
                          states[e].gradient = Eigen::Map<const Vector<D>>(gradients.data() + D * e);
                          states[e].hessian = Eigen::Map<const Matrix<D>>(hessians.data() + D * D * e);
                        }
                      });
  }

  void add_element(std::int64_t e, const FFM::internal::Signed_svd<D>& svd, const FFM::Element_state<D>& state, FFM::Positions<D>& gradient,
                   FFM::Term_matrix<D>* matrix) const
  {
    const auto& v = m_domain.elements[e];
    const double weight = m_domain.measures[e];
    // Column k: the gradient of the hat function of vertex k, turned into the frame of V.
    Eigen::Matrix<double, D, D + 1> hats;
    hats.template rightCols<D>() = svd.V.transpose() * m_domain.rest_inverses[e].transpose();
    hats.col(0) = -hats.template rightCols<D>().rowwise().sum();
    for(int k = 0; k <= D; ++k)
      gradient.col(v[k]) += svd.U * (weight * state.gradient.asDiagonal() * hats.col(k));
    if(matrix == nullptr)
      return;
    FFM::Increment_form<D> form;
    FFM::Projected_newton().form(state, FFM::Any_energy(), form);
    for(int k = 0; k <= D; ++k)
      for(int l = k; l <= D; ++l)
        matrix->add(v[k], v[l], weight * (svd.U * form.block(hats.col(k), hats.col(l)) * svd.U.transpose()));
  }

  const FFM::Simplicial_domain<D>& m_domain;
  const Function& m_function;
};

// A function of the positions of all vertices, in the user's units, with a matrix on pairs of vertices of stencils.
template <int D>
class Function_term : public FFM::Objective_term<D>
{
public:
  Function_term(double scale, const Function& function, std::vector<std::vector<std::int32_t>> stencils)
    : m_scale(scale), m_function(function), m_stencils(std::move(stencils))
  {}

  std::vector<std::vector<std::int32_t>> stencils() const override { return m_stencils; }

  double value(const FFM::Positions<D>& x) const override
  {
    double result = 0;
    const bool done = m_function([&] { return positions(x); }, false, [&](const py::object& value) { result = value.cast<double>(); });
    return done && !std::isnan(result) ? result : std::numeric_limits<double>::infinity();
  }

  void add_derivatives(const FFM::Positions<D>& x, FFM::Positions<D>& gradient, FFM::Term_matrix<D>* matrix) const override
  {
    m_function([&] { return positions(x); }, true,
               [&](const py::object& result) {
                 const auto parts = result.cast<std::tuple<py::object, py::object, py::object>>();
                 const Returned slope(std::get<1>(parts), {x.cols(), D}, "the gradient of the term");
                 gradient += m_scale * Eigen::Map<const FFM::Positions<D>>(slope.data(), D, x.cols());
                 const py::object& blocks = std::get<2>(parts);
                 if(matrix == nullptr || blocks.is_none())
                   return;
                 const auto entries = blocks.cast<std::tuple<py::array, py::array, py::object>>();
                 const Rows<std::int64_t, 2> pairs(py::module_::import("numpy").attr("stack")(
                                                     py::make_tuple(std::get<0>(entries), std::get<1>(entries)), py::arg("axis") = 1),
                                                   "the pairs of the term's Hessian");
                 const Returned numbers(std::get<2>(entries), {static_cast<py::ssize_t>(pairs.size()), D, D}, "the Hessian of the term");
                 using Block = Eigen::Matrix<double, D, D, Eigen::RowMajor>;
                 for(std::size_t i = 0; i < pairs.size(); ++i)
                   matrix->add(static_cast<std::int32_t>(pairs[i][0]), static_cast<std::int32_t>(pairs[i][1]),
                               m_scale * m_scale * Eigen::Map<const Block>(numbers.data() + D * D * i));
               });
  }

private:
  py::array positions(const FFM::Positions<D>& x) const
  {
    py::array_t<double> result({static_cast<py::ssize_t>(x.cols()), static_cast<py::ssize_t>(D)});
    Eigen::Map<FFM::Positions<D>>(result.mutable_data(), D, x.cols()) = m_scale * x;
    return result;
  }

  double m_scale;
  const Function& m_function;
  std::vector<std::vector<std::int32_t>> m_stencils;
};

// What the minimizer itself minimises when a function of Python takes its place.
struct No_energy
{
  static constexpr bool has_barrier = true;
  static const char* name() { return "function"; }

  template <int D>
  double value(const Vector<D>&) const
  {
    return 0;
  }

  template <int D>
  void derivatives(const Vector<D>&, Vector<D>& gradient, Matrix<D>& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
  }
};

// The derivatives of an energy at the identity, for those who ask an energy for no more.
template <int D>
struct Energy_at_identity
{
  FFM::Element_state<D> state;

  template <int>
  void derivatives(const Vector<D>&, Vector<D>& gradient, Matrix<D>& hessian) const
  {
    gradient = state.gradient;
    hessian = state.hessian;
  }
};

// The rest shape of an element, triangles in the plane or in space.
bool rest_shape(const Points& rest, const std::array<std::int64_t, 3>& v, Matrix<2>& inverse, double& measure)
{
  Vector<3> p[3];
  for(int k = 0; k < 3; ++k)
    p[k] = Eigen::Map<const Vector<3>>(rest[v[k]].data());
  return FFM::internal::planar_rest_shape(p[0], p[1], p[2], inverse, measure);
}

bool rest_shape(const Points& rest, const std::array<std::int64_t, 4>& v, Matrix<3>& inverse, double& measure)
{
  Matrix<3> edges;
  const Eigen::Map<const Vector<3>> origin(rest[v[0]].data());
  for(int k = 0; k < 3; ++k)
    edges.col(k) = Eigen::Map<const Vector<3>>(rest[v[k + 1]].data()) - origin;
  return FFM::internal::spatial_rest_shape(edges, inverse, measure);
}

// Fills the domain, scaled to measure 1, and finds the vertices that no element has.
template <int D>
FFM::Outcome load(const Points& rest, const Rows<std::int64_t, D + 1>& elements, FFM::Simplicial_domain<D>& domain,
                  std::vector<std::int32_t>& unused)
{
  if(elements.size() == 0)
    return {FFM::Status::empty_mesh, "there are no elements"};
  domain.number_of_vertices = static_cast<std::int32_t>(rest.size());
  std::vector<char> is_used(rest.size(), 0);
  double sum = 0;
  for(std::size_t e = 0; e < elements.size(); ++e) {
    typename FFM::Simplicial_domain<D>::Element element;
    for(int k = 0; k <= D; ++k) {
      const std::int64_t v = elements[e][k];
      if(v < 0 || v >= domain.number_of_vertices)
        return {FFM::Status::invalid_option, "element number " + std::to_string(e) + " has the vertex " + std::to_string(v) +
                                               ", but there are " + std::to_string(rest.size()) + " points"};
      element[k] = static_cast<std::int32_t>(v);
      is_used[v] = 1;
    }
    Matrix<D> inverse;
    double measure = 0;
    if(!rest_shape(rest, elements[e], inverse, measure))
      return {FFM::Status::degenerate_rest_element,
              "the rest shape of element number " + std::to_string(e) + " has no positive measure, or a coordinate that is not finite"};
    domain.elements.push_back(element);
    domain.rest_inverses.push_back(inverse);
    domain.measures.push_back(measure);
    sum += measure;
  }
  domain.scale = std::pow(sum, 1. / D);
  for(std::size_t e = 0; e < domain.elements.size(); ++e) {
    domain.rest_inverses[e] *= domain.scale;
    domain.measures[e] /= sum;
  }
  for(std::size_t v = 0; v < is_used.size(); ++v)
    if(!is_used[v])
      unused.push_back(static_cast<std::int32_t>(v));
  return {FFM::Status::success, ""};
}

// The method for an energy of Python: its Hessian, factorized in every iteration.
template <int D>
void use_function(const FFM::Simplicial_domain<D>& domain, const Mean_energy<D>& energy, FFM::Any_map_traits& traits)
{
  traits.energy = FFM::Any_energy(No_energy());
  // Elements alone know nothing of the energy.
  traits.options.free_blocked_vertices = false;
  Energy_at_identity<D> at_identity;
  if(traits.options.characteristic_gradient_tolerance > 0 && energy.at_identity(at_identity.state))
    traits.options.gradient_tolerance =
      traits.options.characteristic_gradient_tolerance * FFM::internal::characteristic_gradient(domain, at_identity);
  traits.options.characteristic_gradient_tolerance = 0;
}

template <int D>
py::tuple minimize_in(const Rows<double, D>& start, const Rows<std::int64_t, D + 1>& elements, const Points& rest, const py::object& energy,
                      const py::object& term, const py::dict& given, Watch& watch)
{
  const program::Method_choice choice = method_choice(given);
  FFM::Any_map_traits traits = make_traits(choice);
  if(!energy.is_none())
    traits.use_method("projected-newton+");
  const Function energy_function(energy, watch), term_function(term, watch);
  FFM::Position_constraints<D> constraints;
  if(given.contains("fixed"))
    for(const auto& v : Rows<std::int64_t, 1>(given["fixed"], "fixed"))
      constraints.fixed_vertices.push_back(static_cast<std::int32_t>(v[0]));
  std::vector<std::vector<std::int32_t>> stencils;
  read(given, "stencils", stencils);
  const bool has_function = !energy.is_none(), has_term = !term.is_none();

  std::vector<std::array<double, D>> result(start.begin(), start.end());
  FFM::Summary summary;
  const auto run = [&] {
    FFM::Simplicial_domain<D> domain;
    const FFM::Outcome loaded = load<D>(rest, elements, domain, constraints.fixed_vertices);
    summary.status = loaded.status;
    summary.message = loaded.message;
    if(!loaded.is_success())
      return;
    const auto mean_energy = std::make_shared<Mean_energy<D>>(domain, energy_function);
    set_limits(choice, traits.options);
    if(has_function)
      use_function(domain, *mean_energy, traits);
    traits.options.observer = watch.observer<FFM::Iteration_report>();
    FFM::Map_minimizer<D, FFM::Any_map_traits> minimizer(domain, traits, constraints);
    if(has_function)
      minimizer.add_term(mean_energy);
    if(has_term)
      minimizer.add_term(std::make_shared<Function_term<D>>(domain.scale, term_function, stencils));
    FFM::Positions<D> x(D, start.size());
    for(std::size_t v = 0; v < start.size(); ++v)
      x.col(v) = Eigen::Map<const Vector<D>>(start[v].data()) / domain.scale;
    minimizer.minimize(x, summary);
    traits.name_choices(summary);
    summary.start = "given";
    // What is infinite or no number may be a function; elements that are flipped are counted.
    if(summary.status == FFM::Status::start_not_flip_free && summary.flips == 0 && (has_function || has_term)) {
      summary.status = FFM::Status::non_finite_input;
      summary.message = std::string(has_term ? has_function ? "the energy or the term" : "the term" : "the energy") +
                        ", a function of Python, is not a finite number at the start";
    }
    if(!summary.is_valid())
      return;
    std::vector<char> is_fixed(start.size(), 0);
    for(const std::int32_t v : constraints.fixed_vertices)
      is_fixed[v] = 1;
    for(std::size_t v = 0; v < start.size(); ++v)
      if(!is_fixed[v])
        Eigen::Map<Vector<D>>(result[v].data()) = domain.scale * x.col(v);
    FFM::Positions<D> written(D, start.size());
    for(std::size_t v = 0; v < start.size(); ++v)
      written.col(v) = Eigen::Map<const Vector<D>>(result[v].data());
    for(const auto& element : domain.elements)
      if(!FFM::internal::is_positively_oriented<FFM::Any_map_traits::Kernel>(element, written)) {
        summary.status = FFM::Status::result_not_representable;
        summary.message = "elements flip when the map is scaled to the units of the points";
        return;
      }
  };
  {
    const py::gil_scoped_release unlocked;
    FFM::internal::account_run(summary, run);
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

} // namespace

py::tuple minimize(const py::array& start, const py::array& elements, const py::array& rest, const py::object& energy,
                   const py::object& term, const py::dict& given, const py::object& progress)
{
  const Points rest_points(rest, "rest");
  const int dimension = static_cast<int>(start.shape(1));
  const std::string reason = why_not_available(method_choice(given), dimension);
  if(!reason.empty())
    return refusal(reason);
  Watch watch(progress);
  if(dimension == 2)
    return minimize_in<2>(Planar_points(start, "points"), Triangles(elements, "elements"), rest_points, energy, term, given, watch);
  return minimize_in<3>(Points(start, "points"), Tetrahedra(elements, "elements"), rest_points, energy, term, given, watch);
}

} // namespace python
