// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "support/all_energies.h"

#include <vector>

namespace test_support {

std::vector<FFM::Any_energy> energies_with_barrier()
{
  FFM::Exponential_symmetric_dirichlet steep;
  steep.factor = 3;
  FFM::Neo_hookean rubber;
  rubber.mu = 0.1;
  Conformal_with_size sum;
  sum.second_weight = 0.2;
  return {FFM::Any_energy(FFM::Symmetric_dirichlet()),
          FFM::Any_energy(FFM::Exponential_symmetric_dirichlet()),
          FFM::Any_energy(steep),
          FFM::Any_energy(FFM::Symmetric_gradient()),
          FFM::Any_energy(FFM::Symmetric_arap()),
          FFM::Any_energy(FFM::Hencky()),
          FFM::Any_energy(FFM::Conformal()),
          FFM::Any_energy(FFM::Amips()),
          FFM::Any_energy(FFM::Exponential_amips()),
          FFM::Any_energy(FFM::Neo_hookean()),
          FFM::Any_energy(rubber),
          FFM::Any_energy(FFM::Aigerman_isometric()),
          FFM::Any_energy(sum)};
}

} // namespace test_support
