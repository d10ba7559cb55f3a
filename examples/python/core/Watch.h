// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Ctrl-C and the caller's function that is told of the progress, behind an observer.

#ifndef FLIP_FREE_MAPS_PYTHON_WATCH_H
#define FLIP_FREE_MAPS_PYTHON_WATCH_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>

namespace python {

namespace py = pybind11;
namespace FFM = CGAL::Flip_free_maps;

inline py::dict dictionary(const FFM::Iteration_report& report)
{
  py::dict result;
  result["iteration"] = report.iteration;
  result["seconds"] = report.seconds;
  result["energy"] = report.energy;
  result["gradient_norm"] = report.gradient_norm;
  result["characteristic_gradient_norm"] = report.characteristic_gradient_norm;
  result["step"] = report.step;
  result["factorizations"] = report.factorizations;
  result["flips"] = report.flips;
  return result;
}

inline py::dict dictionary(const FFM::Splitting_report& report)
{
  py::dict result = dictionary(static_cast<const FFM::Iteration_report&>(report));
  result["primal_error"] = report.primal_error;
  result["dual_error"] = report.dual_error;
  return result;
}

inline py::dict dictionary(const FFM::Unwrap_progress& report)
{
  py::dict result;
  result["phase"] = FFM::phase_name(report.phase);
  result["charts_done"] = report.charts_done;
  result["charts"] = report.charts;
  result["faces_done"] = report.faces_done;
  result["faces"] = report.faces;
  result["seconds"] = report.seconds;
  return result;
}

// Made and destroyed with the interpreter's lock; asked without.
class Watch
{
public:
  explicit Watch(const py::object& progress) : m_progress(progress), m_is_told(!progress.is_none()) {}

  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // An observer that refers to this object.
  template <typename Report>
  auto observer()
  {
    return [this](const Report& report) { return may_go_on(report); };
  }

  // Whether something was raised, which ends the run.
  bool has_error() const { return m_error.has_value(); }

  // Keeps what was raised elsewhere. Called with the lock.
  void keep(const py::error_already_set& error) { m_error.emplace(error); }

  // Raises what was raised during the run.
  void raise()
  {
    if(m_error)
      throw py::error_already_set(*m_error);
  }

private:
  using Clock = std::chrono::steady_clock;

  template <typename Report>
  bool may_go_on(const Report& report)
  {
    if(m_error)
      return false;
    // Whoever only waits for signals does not need the lock, for which other threads may keep it waiting, in each iteration.
    const Clock::time_point now = Clock::now();
    if(!m_is_told && now < m_next)
      return true;
    m_next = now + std::chrono::milliseconds(50);
    const py::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if(!m_is_told)
        return true;
      const py::object answer = m_progress(dictionary(report));
      return answer.is_none() || py::bool_(answer);
    } catch(py::error_already_set& error) {
      m_error.emplace(error);
      return false;
    }
  }

  py::object m_progress;
  bool m_is_told;
  Clock::time_point m_next = Clock::now();
  std::optional<py::error_already_set> m_error;
};

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_WATCH_H
