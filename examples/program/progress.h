// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// How far a run is: a line for people on a terminal, or lines of JSON for programs that call this one.

#ifndef FLIP_FREE_MAPS_PROGRAM_PROGRESS_H
#define FLIP_FREE_MAPS_PROGRAM_PROGRESS_H

#include "method_arguments.h"

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>

#include <string>

namespace program {

// Writes to the standard error stream.
class Progress
{
public:
  explicit Progress(const Method_arguments& arguments);

  // Whether anything is written; who asks for nothing need not be told.
  bool is_shown() const { return m_form != Form::none; }

  void operator()(const FFM::Iteration_report& report);
  void operator()(const FFM::Unwrap_progress& report);

  // After the last report.
  void finish();

private:
  enum class Form
  {
    none,
    text,
    json
  };

  // The part of the run that is done, as far as its limits and the decrease of the gradient tell.
  double share(const FFM::Iteration_report& report);

  // Whether a line of JSON is due: there are some in a second, and one at the beginning of each phase.
  bool is_due(const std::string& phase, double seconds);

  Form m_form = Form::none;
  Method_choice m_method;
  std::string m_phase;
  double m_seconds = 0, m_share = 0, m_first_norm = 0;
};

// The last line of JSON, if such lines were asked for.
void end_progress(const Method_arguments& arguments, Status status, const std::string& message);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_PROGRESS_H
