// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/starts.h"

#include <cstdint>
#include <string>

namespace test_support {

FFM::Positions<2> tutte_start(const FFM::Simplicial_domain<2>& domain)
{
  FFM::Positions<2> x;
  std::string name, message;
  if(Tutte(FFM::Start_options())(domain, make_eigen_solver, x, name, message) != FFM::Status::success)
    x.resize(2, 0);
  return x;
}

std::int64_t number_of_flips(const FFM::Simplicial_domain<2>& domain, const FFM::Positions<2>& x)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  std::int64_t flips = 0;
  for(const auto& t : domain.elements) {
    const auto point = [&x](std::int32_t v) { return Kernel::Point_2(x(0, v), x(1, v)); };
    flips += CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::POSITIVE;
  }
  return flips;
}

} // namespace test_support
