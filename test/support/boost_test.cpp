// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The framework of Boost.Test, compiled once for all tests: in each of them it would take longer than most.

#include <boost/test/included/unit_test.hpp>
