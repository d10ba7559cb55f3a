// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_ALL_ENERGIES_H
#define CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_ALL_ENERGIES_H

// All energies of the package, and their names to print.

#include <CGAL/Flip_free_maps/energies/Aigerman_isometric.h>
#include <CGAL/Flip_free_maps/energies/Amips.h>
#include <CGAL/Flip_free_maps/energies/Any_energy.h>
#include <CGAL/Flip_free_maps/energies/Arap.h>
#include <CGAL/Flip_free_maps/energies/Conformal.h>
#include <CGAL/Flip_free_maps/energies/Exponential_amips.h>
#include <CGAL/Flip_free_maps/energies/Exponential_symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Hencky.h>
#include <CGAL/Flip_free_maps/energies/Neo_hookean.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_arap.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_dirichlet.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/energies/Weighted_sum.h>

#include <vector>

namespace test_support {

namespace FFM = CGAL::Flip_free_maps;

typedef FFM::Weighted_sum<FFM::Conformal, FFM::Symmetric_gradient> Conformal_with_size;

// Those with a barrier, for tests that need one instantiation for all of them.
std::vector<FFM::Any_energy> energies_with_barrier();

} // namespace test_support

#endif // CGAL_FLIP_FREE_MAPS_TEST_SUPPORT_ALL_ENERGIES_H
