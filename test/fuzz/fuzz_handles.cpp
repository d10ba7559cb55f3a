// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of handles, in the plane and in space.

#include "fuzz_support.h"

#include "program/formats/Handles.h"

namespace {

template <int D>
void read(const std::string& path)
{
  namespace FFM = CGAL::Flip_free_maps;
  FFM::Positions<D> points(D, 5);
  for(int v = 0; v < 5; ++v)
    for(int c = 0; c < D; ++c)
      points(c, v) = (v >> c & 1) * (v == 4 ? 1e300 : 1.);
  FFM::Handles<D> handles;
  if(!FFM::read_handles<D>(path, points, handles, nullptr, {true, true, true, false, true}))
    return;
  fuzz::demand(handles.targets.cols() == static_cast<Eigen::Index>(handles.vertices.size()) && handles.targets.allFinite(),
               "targets are missing, or not finite");
  for(const std::int32_t v : handles.vertices)
    fuzz::demand(v >= 0 && v < 5 && v != 3, "a vertex that may be no handle");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = fuzz::write("handles.txt", fuzz::text_of(data, size));
  read<2>(path);
  read<3>(path);
  return 0;
}
