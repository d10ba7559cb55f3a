// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "progress.h"

#include <CGAL/Flip_free_maps/report/Status.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace program {

namespace {

void write_line(const nlohmann::ordered_json& json)
{
  const std::string line = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  std::fputs(line.c_str(), stderr);
}

// In a run on charts: what seams and packing take is guessed.
double share_of(const FFM::Unwrap_progress& report)
{
  const double seams = 0.1, charts = 0.8;
  if(report.phase == FFM::Unwrap_phase::cut)
    return 0;
  return seams + (report.phase == FFM::Unwrap_phase::pack ? charts : charts * report.faces_done / report.faces);
}

bool is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr));
#else
  return isatty(STDERR_FILENO);
#endif
}

} // namespace

Progress::Progress(const Method_arguments& arguments) : m_method(arguments)
{
  if(!arguments.progress.empty())
    m_form = Form::json;
  else if(!arguments.quiet && is_terminal())
    m_form = Form::text;
}

double Progress::share(const FFM::Iteration_report& report)
{
  if(m_method.max_iterations > 0)
    m_share = (std::max)(m_share, static_cast<double>(report.iteration) / m_method.max_iterations);
  if(m_method.time_limit > 0)
    m_share = (std::max)(m_share, report.seconds / m_method.time_limit);
  // Norms decrease about geometrically, to and fro.
  const double tolerance = m_method.tolerance > 0 ? m_method.tolerance : FFM::Map_options().characteristic_gradient_tolerance;
  const double norm = report.characteristic_gradient_norm;
  m_first_norm = (std::max)(m_first_norm, norm);
  const bool is_for_norm = m_method.criterion == "auto" || m_method.criterion == "characteristic";
  if(is_for_norm && report.flips == 0 && norm > 0 && m_first_norm > tolerance)
    m_share = (std::max)(m_share, std::log(m_first_norm / norm) / std::log(m_first_norm / tolerance));
  m_share = (std::min)(m_share, 1.);
  return m_share;
}

bool Progress::is_due(const std::string& phase, double seconds)
{
  if(phase == m_phase && seconds >= m_seconds && seconds < m_seconds + 0.05)
    return false;
  m_phase = phase;
  m_seconds = seconds;
  return true;
}

void Progress::operator()(const FFM::Iteration_report& report)
{
  if(m_form == Form::text)
    std::fprintf(stderr, "\riteration %d  energy %.8f  gradient %.2e  %.1f s   ", report.iteration, report.energy,
                 report.characteristic_gradient_norm, report.seconds);
  if(m_form != Form::json)
    return;
  const std::string phase = report.flips > 0 ? "remove_flips" : "minimize";
  const double part = share(report);
  if(is_due(phase, report.seconds))
    write_line({{"phase", phase},
                {"share", part},
                {"iteration", report.iteration},
                {"energy", report.energy},
                {"flips", report.flips},
                {"seconds", report.seconds}});
}

void Progress::operator()(const FFM::Unwrap_progress& report)
{
  if(m_form == Form::text)
    std::fprintf(stderr, "\rchart %d of %d  %.0f %% of the faces  %.1f s   ", report.charts_done + 1, report.charts,
                 100. * report.faces_done / report.faces, report.seconds);
  if(m_form != Form::json)
    return;
  m_share = (std::max)(m_share, share_of(report));
  if(is_due(FFM::phase_name(report.phase), report.seconds))
    write_line({{"phase", m_phase},
                {"share", m_share},
                {"charts_done", report.charts_done},
                {"charts", report.charts},
                {"faces_done", report.faces_done},
                {"faces", report.faces},
                {"seconds", report.seconds}});
}

void Progress::finish()
{
  if(m_form == Form::text)
    std::fputc('\n', stderr);
}

void end_progress(const Method_arguments& arguments, Status status, const std::string& message)
{
  if(!arguments.progress.empty())
    write_line({{"phase", "end"}, {"share", 1}, {"status", FFM::status_name(status)}, {"message", message}});
}

} // namespace program
