// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "report.h"

#include "html_report.h"
#include "interruption.h"
#include "outputs.h"

#include <CGAL/Flip_free_maps/report/Deadline.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <new>
#include <sstream>

namespace program {

int exit_code(Status status)
{
  if(status == Status::success || status == Status::iteration_limit)
    return 0;
  if(received_signal() != 0)
    return exit_code_of_signal(received_signal());
  return FFM::is_valid_map(status) ? 1 : static_cast<int>(status) - static_cast<int>(Status::empty_mesh) + 3;
}

std::string exit_codes_text()
{
  std::string text =
    "Exit codes: 0 a valid map was written (converged, or ended by a limit of iterations); 1 a valid map was written, which "
    "the limit of time ended; " +
    std::to_string(exit_code_of_signal(SIGINT)) + ", " + std::to_string(exit_code_of_signal(SIGTERM)) +
    " ended by Ctrl-C or SIGTERM, with the valid map written if there was one; 2 wrong command line";
  for(int s = static_cast<int>(Status::empty_mesh); s <= static_cast<int>(Status::interrupted); ++s)
    text += "; " + std::to_string(exit_code(static_cast<Status>(s))) + " " + FFM::status_name(static_cast<Status>(s));
  return text + ".";
}

void write_json(const std::string& path, const nlohmann::json& json)
{
  if(path.empty())
    return;
  // Messages quote names of files, which need not be UTF-8.
  write_text(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

Reporter::Reporter(const Method_arguments& arguments)
  : m_progress(arguments), m_trace_path(arguments.trace), m_trace("iteration,seconds,energy,gradient_norm,step,flips,factorizations\n")
{}

bool Reporter::operator()(const FFM::Iteration_report& report)
{
  if(!m_trace_path.empty()) {
    std::ostringstream row;
    row.precision(17);
    row << report.iteration << ',' << report.seconds << ',' << report.energy << ',' << report.gradient_norm << ',' << report.step << ','
        << report.flips << ',' << report.factorizations << '\n';
    m_trace += row.str();
  }
  m_progress(report);
  return true;
}

void Reporter::finish()
{
  m_progress.finish();
  if(!m_trace_path.empty())
    write_text(m_trace_path, m_trace);
}

void set_options(const Method_arguments& arguments, const std::shared_ptr<Reporter>& reporter, FFM::Map_options& options)
{
  set_limits(arguments, options);
  options.memory_budget = arguments.memory_budget * 1024 * 1024 * 1024;
  options.observer = [reporter](const FFM::Iteration_report& report) { return (*reporter)(report); };
}

void run_guarded(const Method_arguments& arguments, const std::function<void()>& body,
                 const std::function<void(Status, const std::string&)>& fail)
{
  try {
#ifdef CGAL_LINKED_WITH_TBB
    std::unique_ptr<tbb::global_control> control;
    if(arguments.threads > 0)
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
#endif
    const double seconds = arguments.time_limit > 0 ? arguments.time_limit : std::numeric_limits<double>::infinity();
    const FFM::Deadline deadline(seconds, [] { return received_signal() != 0; });
    body();
  } catch(const Failure& failure) {
    fail(failure.status, failure.message);
  } catch(const FFM::Interruption& interruption) {
    fail(Status::interrupted, interruption.what());
  } catch(const std::bad_alloc&) {
    fail(Status::out_of_memory, "memory was exhausted");
  } catch(const std::exception& exception) {
    fail(Status::file_error, exception.what());
  }
}

const Hints& patch_hints()
{
  static const std::string unwrap = "the sub-command unwrap ";
  static const Hints hints{{Status::not_triangular, unwrap + "takes polygons"},
                           {Status::no_border, unwrap + "cuts it open"},
                           {Status::several_components, unwrap + "takes any number of them"},
                           {Status::not_a_disk, unwrap + "cuts its handles open"},
                           {Status::non_manifold, unwrap + "takes such surfaces, and its option --repair mends them"},
                           {Status::degenerate_rest_element, unwrap + "takes such surfaces, and its option --repair mends them"}};
  return hints;
}

int report(const Method_arguments& arguments, Status status, const std::string& message, const nlohmann::json& json,
           const std::string& text, const std::vector<std::string>& pictures)
{
  try {
    write_json(arguments.json, json);
    if(!arguments.report.empty())
      write_text(arguments.report, html_report("flip_free_maps: " + std::string(FFM::status_name(status)), json,
                                               FFM::is_valid_map(status) ? pictures : std::vector<std::string>()));
  } catch(const Failure& failure) {
    std::cerr << "flip_free_maps: " << failure.message << '\n';
    end_progress(arguments, failure.status, failure.message);
    return exit_code(failure.status);
  }
  end_progress(arguments, status, message);
  if(!FFM::is_valid_map(status))
    std::cerr << "flip_free_maps: " << FFM::status_name(status) << ": " << message << '\n';
  else if(!arguments.quiet)
    std::cout << text;
  return exit_code(status);
}

int run_reported(const Method_arguments& arguments, const std::function<void(FFM::Summary&)>& body, const Hints& hints,
                 const std::vector<std::string>& pictures)
{
  FFM::Summary summary;
  run_guarded(arguments, summary, body);
  const auto hint = hints.find(summary.status);
  // What the library recommends is a function.
  if(hint != hints.end())
    summary.message = summary.message.substr(0, summary.message.find("; cut_to_disk()")) + "; " + hint->second;
  std::ostringstream text;
  text << summary;
  return report(arguments, summary.status, summary.message, summary, text.str(), pictures);
}

} // namespace program
