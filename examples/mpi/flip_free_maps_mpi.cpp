// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The program over the ranks of MPI, for meshes that one process is too slow or too small for:
//
//   mpirun -n N flip_free_maps_mpi deform IN.mesh --handles FILE -o OUT.mesh [--start MESH] [--tolerance T] [--max-seconds S]
//   mpirun -n N flip_free_maps_mpi parameterize IN.off -o OUT.obj [--tolerance T] [--max-seconds S]
//
// Each rank reads a slice of the file, and one writes the result. The exit code is 0 only for a valid map, on all ranks.

#include "mesh_slices.h"

#include <CGAL/Flip_free_maps/deform_volume_over_mpi.h>
#include <CGAL/Flip_free_maps/parameterize_over_mpi.h>

#include <mpi.h>
#include <petscsys.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace FFM = CGAL::Flip_free_maps;

const char* const USAGE = "usage: flip_free_maps_mpi deform IN.mesh --handles FILE -o OUT.mesh [--start MESH] [--tolerance T] "
                          "[--max-seconds S], or flip_free_maps_mpi parameterize IN.off -o OUT.obj [--tolerance T] [--max-seconds S]";

struct Arguments
{
  std::string command, input, handles, output, start;
  FFM::Map_traits_over_mpi traits;

  Arguments(int argc, char* argv[])
  {
    if(argc < 3)
      throw program::File_failure(USAGE);
    command = argv[1];
    input = argv[2];
    for(int i = 3; i < argc; i += 2) {
      const std::string name = argv[i];
      if(i + 1 == argc)
        throw program::File_failure(name + " has no value");
      set(name, argv[i + 1]);
    }
    const bool deforms = command == "deform", parameterizes = command == "parameterize" && handles.empty() && start.empty();
    if(output.empty() || (deforms ? handles.empty() : !parameterizes))
      throw program::File_failure(USAGE);
  }

private:
  void set(const std::string& name, const char* value)
  {
    if(name == "--handles")
      handles = value;
    else if(name == "-o")
      output = value;
    else if(name == "--start")
      start = value;
    else if(name == "--tolerance")
      traits.options.characteristic_gradient_tolerance = number(name, value);
    else if(name == "--max-seconds")
      traits.options.max_seconds = number(name, value);
    else
      throw program::File_failure(name + " is no option; " + USAGE);
  }

  static double number(const std::string& name, const char* value)
  {
    char* end = nullptr;
    const double result = std::strtod(value, &end);
    if(end == value || *end != '\0')
      throw program::File_failure(name + ": " + value + " is not a number");
    return result;
  }
};

// What all ranks do together, with their summary.
FFM::Summary deform(const Arguments& arguments, const FFM::Mpi_world& world)
{
  program::Solid_slice slice;
  std::vector<std::pair<std::int64_t, program::Place>> handles;
  FFM::Deform_volume_options options;
  world.together([&] {
    slice = program::read_solid_slice(arguments.input, world.rank(), world.size());
    if(world.rank() == 0)
      handles = program::read_vertex_handles(arguments.handles);
    if(arguments.start.empty())
      return;
    const program::Solid_slice start = program::read_solid_slice(arguments.start, world.rank(), world.size());
    options.start.resize(3, start.points.size());
    for(std::size_t i = 0; i < start.points.size(); ++i)
      options.start.col(i) << start.points[i][0], start.points[i][1], start.points[i][2];
  });
  std::vector<program::Place> result;
  const FFM::Summary summary =
    FFM::deform_volume_over_mpi(world.communicator(), slice.points, slice.tetrahedra, handles, result,
                                FFM::parameters::volume_options(options, FFM::parameters::map_traits(arguments.traits)));
  if(summary.is_valid()) {
    slice.points.swap(result);
    program::write_solid_slices(arguments.output, slice, world.communicator());
  }
  return summary;
}

FFM::Summary parameterize(const Arguments& arguments, const FFM::Mpi_world& world)
{
  program::Surface_slice slice;
  world.together([&] { slice = program::read_surface_slice(arguments.input, world.rank(), world.size()); });
  std::vector<std::array<double, 2>> uv;
  const FFM::Summary summary =
    FFM::parameterize_over_mpi(world.communicator(), slice.points, slice.triangles, uv, FFM::parameters::map_traits(arguments.traits));
  if(summary.is_valid())
    program::write_surface_slices(arguments.output, slice, uv, world.communicator());
  return summary;
}

int run(int argc, char* argv[])
{
  const FFM::Mpi_world world(MPI_COMM_WORLD);
  try {
    const Arguments arguments(argc, argv);
    const FFM::Summary summary = arguments.command == "deform" ? deform(arguments, world) : parameterize(arguments, world);
    const double memory = -world.minimum(-summary.peak_memory_mb);
    if(world.rank() == 0)
      std::cout << summary << "  ranks " << world.size() << ", iterations of conjugate gradients " << summary.inner_iterations
                << ", peak memory of the largest " << memory << " MiB" << std::endl;
    return summary.is_valid() ? 0 : 1;
  } catch(const std::exception& failure) {
    // A file is missing for all ranks, or the others say that one has failed.
    if(world.rank() == 0)
      std::cerr << "flip_free_maps_mpi: " << failure.what() << std::endl;
    return 2;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  MPI_Init(&argc, &argv);
  const int code = run(argc, argv);
  PetscFinalize();
  MPI_Finalize();
  return code;
}
