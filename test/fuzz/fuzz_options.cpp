// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The command line of the program, a word per line. No mesh is there, so that whatever is asked for must fail, and nothing is written
// but reports.

#include "fuzz_support.h"

#include "program/commands.h"
#include "program/method_arguments.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> lines_of(std::string_view text)
{
  std::vector<std::string> lines;
  while(!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

} // namespace

// The compiled library is not instrumented.
extern "C" const char* __asan_default_options() { return "detect_container_overflow=0"; }

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // What the program has to say is not looked at.
  std::cout.rdbuf(nullptr);
  std::cerr.rdbuf(nullptr);
  const std::string_view text = fuzz::text_of(data, size);
  // Nothing outside the folder is read or written.
  if(text.find('/') != std::string_view::npos || text.find("..") != std::string_view::npos)
    return 0;
  const std::filesystem::path folder = std::filesystem::path(fuzz::file("")).parent_path();
  std::filesystem::current_path(folder);
  for(const auto& entry : std::filesystem::directory_iterator(folder))
    std::filesystem::remove_all(entry.path());

  CLI::App app;
  app.require_subcommand(1);
  const std::unique_ptr<program::Command> commands[] = {
    program::parameterize_command(app), program::unwrap_command(app), program::deform_command(app),  program::repair_command(app),
    program::map_volume_command(app),   program::morph_command(app),  program::measure_command(app), program::pack_command(app)};
  std::vector<std::string> words = lines_of(text);
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
  } catch(const CLI::ParseError&) {
    return 0;
  }
  for(const auto& command : commands)
    if(*command->app && program::option_without_number(*command->app).empty())
      fuzz::demand(command->run() != 0, "success without an input");
  return 0;
}
