// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "refine_solid.h"

#include "../outputs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace program {

namespace {

// Of some cells, their entries anew.
void append_rows(Data_array& array, const std::vector<std::size_t>& rows)
{
  const std::size_t n = array.number_of_components;
  for(const std::size_t row : rows)
    for(std::size_t c = 0; c < n; ++c)
      if(is_real(array.type))
        array.reals.push_back(array.reals[row * n + c]);
      else
        array.integers.push_back(array.integers[row * n + c]);
}

void append_middles(Volume_file& file, const std::vector<FFM::Edge_split>& splits)
{
  for(const FFM::Edge_split& split : splits) {
    const std::array<double, 3> p = file.points[split.ends[0]], q = file.points[split.ends[1]];
    file.points.push_back({{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])}});
    for(Data_array& array : file.point_data) {
      append_rows(array, {static_cast<std::size_t>(split.ends[0])});
      if(is_real(array.type))
        for(std::size_t c = 0, n = array.number_of_components; c < n; ++c) {
          double& value = array.reals[array.reals.size() - n + c];
          value = 0.5 * (value + array.reals[split.ends[1] * n + c]);
        }
    }
  }
}

template <std::size_t N>
void split_cells(int type, Volume_file& file, const std::vector<FFM::Edge_split>& splits)
{
  std::vector<std::size_t> numbers;
  std::vector<std::array<int, N>> simplices;
  for(std::size_t i = 0; i < file.cells.size(); ++i)
    if(file.cells.types[i] == type) {
      numbers.push_back(i);
      simplices.emplace_back();
      std::copy_n(file.cells.nodes.begin() + file.cells.begin(i), N, simplices.back().begin());
    }
  std::vector<std::size_t> parents = FFM::split_simplices(simplices, splits);
  for(std::size_t i = 0; i < numbers.size(); ++i)
    std::copy(simplices[i].begin(), simplices[i].end(), file.cells.nodes.begin() + file.cells.begin(numbers[i]));
  for(std::size_t i = numbers.size(); i < simplices.size(); ++i)
    file.cells.add(type, simplices[i]);
  for(std::size_t& parent : parents)
    parent = numbers[parent];
  for(Data_array& array : file.cell_data)
    append_rows(array, parents);
}

// Cells of several edges that are no simplices cannot be split alone.
void check_other_cells(const Volume_file& file, const std::vector<FFM::Edge_split>& splits)
{
  for(std::size_t i = 0; i < file.cells.size(); ++i) {
    const int type = file.cells.types[i];
    if(type == cell_type::VERTEX || type == cell_type::POLY_VERTEX || type == cell_type::LINE || type == cell_type::TRIANGLE ||
       type == cell_type::TETRAHEDRON)
      continue;
    const auto begin = file.cells.nodes.begin() + file.cells.begin(i), end = file.cells.nodes.begin() + file.cells.ends[i];
    for(const FFM::Edge_split& split : splits)
      check(std::find(begin, end, split.ends[0]) == end || std::find(begin, end, split.ends[1]) == end,
            "cell number " + std::to_string(i) +
              " has an edge that is to be split, and is neither line, triangle nor tetrahedron of corners");
  }
}

std::vector<FFM::Edge_split> obstructions(const Solid_input& input, const FFM::Tetrahedral_domain& volume, const FFM::Summary& summary)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(const auto& edge : summary.impossible_edges)
    edges.push_back({{volume.vertices()[edge[0]], volume.vertices()[edge[1]]}});
  return FFM::splits_of_obstructions(input.solid.mesh, summary, edges);
}

void split_solid(Solid_input& input, const std::vector<FFM::Edge_split>& splits)
{
  Volume_file& file = input.file;
  check_other_cells(file, splits);
  append_middles(file, splits);
  split_cells<2>(cell_type::LINE, file, splits);
  split_cells<3>(cell_type::TRIANGLE, file, splits);
  split_cells<4>(cell_type::TETRAHEDRON, file, splits);
  // It is not the file any more that was read.
  file.text.clear();
  file.element_text.clear();
  file.coordinate_places.clear();
  input.solid = Solid();
  const std::string error = take_solid(file, false, input.solid);
  check(error.empty(), error);
}

} // namespace

void add_refine(CLI::App& command, bool& refines)
{
  command.add_flag("--refine", refines,
                   "where held vertices leave no map without flips, split edges inside at their middles: new vertices and tetrahedra come "
                   "last, all others keep their numbers");
}

void map_and_refine(bool refines, Solid_input& input, FFM::Tetrahedral_domain& volume, FFM::Summary& summary,
                    const std::function<void()>& map, const std::function<void(const std::vector<FFM::Edge_split>&)>& split)
{
  const int most_rounds = 5;
  const std::size_t number = input.solid.mesh.points.size();
  map();
  const auto is_blocked = [&summary] {
    return summary.status == Status::unreachable_constraints || summary.status == Status::flips_remain;
  };
  for(int round = 0; refines && round < most_rounds && is_blocked(); ++round) {
    const std::vector<FFM::Edge_split> splits = obstructions(input, volume, summary);
    if(splits.empty())
      break;
    split_solid(input, splits);
    std::string message;
    const Status status = volume.load(input.solid.mesh.points, input.solid.mesh.tetrahedra, message);
    if(status != Status::success && status != Status::several_components)
      throw Failure{status, message};
    split(splits);
    map();
  }
  const std::size_t added = input.solid.mesh.points.size() - number;
  if(added == 1)
    add_note(summary.message, "an edge was split at its middle; the new vertex has the number " + std::to_string(number));
  else if(added > 1)
    add_note(summary.message, std::to_string(added) + " edges were split at their middles; the new vertices have the numbers from " +
                                std::to_string(number) + " to " + std::to_string(number + added - 1));
}

} // namespace program
