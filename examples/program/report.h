// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// How a sub-command runs and what it leaves behind besides the map.

#ifndef FLIP_FREE_MAPS_PROGRAM_REPORT_H
#define FLIP_FREE_MAPS_PROGRAM_REPORT_H

#include "method_arguments.h"
#include "progress.h"

#include <CGAL/Flip_free_maps/report/Summary.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace program {

// 0 for valid maps; 2 is the command line's; the other statuses follow in their order.
int exit_code(Status status);
std::string exit_codes_text();

void write_json(const std::string& path, const nlohmann::json& json);

// What a run leaves behind besides the map.
class Reporter
{
public:
  explicit Reporter(const Method_arguments& arguments);
  bool operator()(const FFM::Iteration_report& report);
  void finish();

private:
  Progress m_progress;
  std::string m_trace_path, m_trace;
};

// Sets limits, tolerances and an observer that calls `*reporter`.
void set_options(const Method_arguments& arguments, const std::shared_ptr<Reporter>& reporter, FFM::Map_options& options);

// Runs `body` on the asked number of threads and hands its failures to `fail`.
void run_guarded(const Method_arguments& arguments, const std::function<void()>& body,
                 const std::function<void(Status, const std::string&)>& fail);

// The same for an account, which receives failures, and which `body(account)` fills.
template <typename Account, typename Body>
void run_guarded(const Method_arguments& arguments, Account& account, Body&& body)
{
  run_guarded(
    arguments, [&] { body(account); },
    [&](Status status, const std::string& message) {
      account.status = status;
      account.message = message;
    });
}

// What helps against a status, in the program's words. It is added to messages.
using Hints = std::map<Status, std::string>;

// Those of sub-commands that take a connected patch of triangles only.
const Hints& patch_hints();

// Writes a report, prints it, and returns the exit code.
int report(const Method_arguments& arguments, Status status, const std::string& message, const nlohmann::json& json,
           const std::string& text, const std::vector<std::string>& pictures = {});

// Runs `body` on the asked number of threads, turns failures into a summary, writes it, prints it, and returns the exit code.
int run_reported(const Method_arguments& arguments, const std::function<void(FFM::Summary&)>& body, const Hints& hints = Hints(),
                 const std::vector<std::string>& pictures = {});

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_REPORT_H
