// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of numbers in lines: seams, and positions.

#include "fuzz_support.h"

#include "program/number_files.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::write("numbers.txt", fuzz::text_of(data, size));
  program::Surface surface;
  surface.points.resize(5);
  surface.polygons = {{0, 1, 2}, {0, 2, 3, 4}};
  const auto ignoring_failures = [](auto&& read) {
    try {
      read();
    } catch(const program::Failure& failure) {
      fuzz::demand(!failure.message.empty(), "a failure without a message");
    }
  };
  ignoring_failures([&] {
    for(const auto& [v, w] : program::read_seams(path, surface))
      fuzz::demand(v < w && w < 5, "a seam that is no edge");
  });
  ignoring_failures([&] {
    for(const program::Number_row& row : program::read_number_rows(path, 3)) {
      fuzz::demand(row.numbers.size() == 3, "another number of numbers");
      ignoring_failures([&] { fuzz::demand(program::vertex_of(row, 0, 5) < 5, "a vertex that does not exist"); });
    }
  });
  return 0;
}
