// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "mesh_slices.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <system_error>

namespace program {

namespace {

// The lines of a file that hold something, without their comments.
class Line_reader
{
public:
  explicit Line_reader(const std::string& path) : m_path(path), m_file(path)
  {
    if(!m_file)
      fail("cannot be opened");
  }

  // The next line, `false` at the end.
  bool next(std::string& line)
  {
    while(std::getline(m_file, line)) {
      ++m_number;
      line.erase((std::min)(line.find('#'), line.size()));
      if(line.find_first_not_of(" \t\r") != std::string::npos)
        return true;
    }
    return false;
  }

  std::string require()
  {
    std::string line;
    if(!next(line))
      fail("ends within a section");
    return line;
  }

  // The first N numbers of a line.
  template <typename T, std::size_t N>
  std::array<T, N> numbers(const std::string& line) const
  {
    std::array<T, N> result;
    const char* at = line.data();
    const char* const end = at + line.size();
    for(T& number : result) {
      while(at != end && (*at == ' ' || *at == '\t'))
        ++at;
      const auto [rest, error] = std::from_chars(at, end, number);
      if(error != std::errc())
        fail("line " + std::to_string(m_number) + " has no " + std::to_string(N) + " numbers where they should be");
      at = rest;
    }
    return result;
  }

  [[noreturn]] void fail(const std::string& what) const { throw File_failure(m_path + ": " + what); }

private:
  std::string m_path;
  std::ifstream m_file;
  long long m_number = 0;
};

// Reads those of `count` entities that belong to a slice, and passes over the others.
template <typename Read>
void read_entities(Line_reader& reader, long long count, int rank, int size, Read&& read)
{
  const long long first = count * rank / size, last = count * (rank + 1) / size;
  for(long long i = 0; i < count; ++i) {
    const std::string line = reader.require();
    if(i >= first && i < last)
      read(line);
  }
}

// The same, after a line with their number.
template <typename Read>
void read_section(Line_reader& reader, int rank, int size, Read&& read)
{
  read_entities(reader, reader.numbers<long long, 1>(reader.require())[0], rank, size, read);
}

void append(std::string& text, double number)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
}

// The lines of a slice: points with a reference, or tetrahedra, whose vertices are numbered from 1 in files.
std::string lines_of(const std::vector<Place>& points)
{
  std::string text;
  for(const Place& p : points) {
    for(const double x : p) {
      append(text, x);
      text += ' ';
    }
    text += "0\n";
  }
  return text;
}

std::string lines_of(const std::vector<std::array<std::int64_t, 4>>& tetrahedra)
{
  std::string text;
  for(const auto& tetrahedron : tetrahedra) {
    for(const std::int64_t v : tetrahedron)
      text += std::to_string(v + 1) + ' ';
    text += "1\n";
  }
  return text;
}

// The lines of an OBJ file.
template <std::size_t N>
std::string lines_of(const char* word, const std::vector<std::array<double, N>>& places)
{
  std::string text;
  for(const auto& place : places) {
    text += word;
    for(const double x : place) {
      text += ' ';
      append(text, x);
    }
    text += '\n';
  }
  return text;
}

std::string lines_of(const std::vector<std::array<std::int64_t, 3>>& triangles)
{
  std::string text;
  for(const auto& triangle : triangles) {
    text += 'f';
    for(const std::int64_t v : triangle) {
      const std::string number = std::to_string(v + 1);
      text += ' ' + number + '/' + number;
    }
    text += '\n';
  }
  return text;
}

// The texts of all ranks, in their order.
void write_texts(std::ofstream& file, std::string text, MPI_Comm comm)
{
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  if(rank != 0) {
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, 0, comm);
    return;
  }
  file << text;
  for(int r = 1; r < size; ++r) {
    MPI_Status status;
    int length = 0;
    MPI_Probe(r, 0, comm, &status);
    MPI_Get_count(&status, MPI_CHAR, &length);
    text.resize(length);
    MPI_Recv(text.data(), length, MPI_CHAR, r, 0, comm, MPI_STATUS_IGNORE);
    file << text;
  }
}

// A section of a Medit file with the lines of all ranks.
template <typename Entities>
void write_section(std::ofstream& file, const char* name, const Entities& entities, MPI_Comm comm)
{
  long long own = static_cast<long long>(entities.size()), all = 0;
  MPI_Allreduce(&own, &all, 1, MPI_LONG_LONG, MPI_SUM, comm);
  file << name << '\n' << all << '\n';
  write_texts(file, lines_of(entities), comm);
}

// Opens a file on the first rank, has all write to it, and tells all of a failure.
template <typename Write>
void write_together(const std::string& path, MPI_Comm comm, Write&& write)
{
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::ofstream file;
  if(rank == 0)
    file.open(path);
  write(file);
  int succeeds = 1;
  if(rank == 0) {
    file.close();
    succeeds = file.fail() ? 0 : 1;
  }
  MPI_Bcast(&succeeds, 1, MPI_INT, 0, comm);
  if(succeeds == 0)
    throw File_failure(path + ": cannot be written");
}

} // namespace

Solid_slice read_solid_slice(const std::string& path, int rank, int size)
{
  Line_reader reader(path);
  Solid_slice slice;
  bool has_points = false;
  for(std::string line; reader.next(line);) {
    std::string word;
    std::istringstream(line) >> word;
    if(word == "Vertices") {
      has_points = true;
      read_section(reader, rank, size, [&](const std::string& text) { slice.points.push_back(reader.numbers<double, 3>(text)); });
    } else if(word == "Tetrahedra") {
      read_section(reader, rank, size, [&](const std::string& text) {
        slice.tetrahedra.push_back(reader.numbers<std::int64_t, 4>(text));
        for(std::int64_t& v : slice.tetrahedra.back())
          --v;
      });
    } else if(word == "End") {
      break;
    }
  }
  if(!has_points)
    reader.fail("has no vertices: it is no Medit file in ASCII");
  return slice;
}

std::vector<std::pair<std::int64_t, Place>> read_vertex_handles(const std::string& path)
{
  Line_reader reader(path);
  std::vector<std::pair<std::int64_t, Place>> handles;
  for(std::string line; reader.next(line);) {
    if(line.find("->") != std::string::npos)
      reader.fail("handles are named by their vertices here, not by places");
    const std::array<double, 4> numbers = reader.numbers<double, 4>(line);
    if(numbers[0] != std::floor(numbers[0]) || !(std::abs(numbers[0]) < 1e15))
      reader.fail("a handle does not begin with the number of a vertex");
    handles.push_back({static_cast<std::int64_t>(numbers[0]), {numbers[1], numbers[2], numbers[3]}});
  }
  return handles;
}

Surface_slice read_surface_slice(const std::string& path, int rank, int size)
{
  Line_reader reader(path);
  std::string word;
  std::istringstream(reader.require()) >> word;
  if(word != "OFF")
    reader.fail("does not begin with OFF");
  const auto counts = reader.numbers<long long, 2>(reader.require());
  Surface_slice slice;
  read_entities(reader, counts[0], rank, size, [&](const std::string& line) { slice.points.push_back(reader.numbers<double, 3>(line)); });
  read_entities(reader, counts[1], rank, size, [&](const std::string& line) {
    const auto face = reader.numbers<std::int64_t, 4>(line);
    if(face[0] != 3)
      reader.fail("has a face that is no triangle");
    slice.triangles.push_back({face[1], face[2], face[3]});
  });
  return slice;
}

void write_solid_slices(const std::string& path, const Solid_slice& slice, MPI_Comm comm)
{
  write_together(path, comm, [&](std::ofstream& file) {
    file << "MeshVersionFormatted 2\nDimension 3\n";
    write_section(file, "Vertices", slice.points, comm);
    write_section(file, "Tetrahedra", slice.tetrahedra, comm);
    file << "End\n";
  });
}

void write_surface_slices(const std::string& path, const Surface_slice& slice, const std::vector<std::array<double, 2>>& uv, MPI_Comm comm)
{
  write_together(path, comm, [&](std::ofstream& file) {
    write_texts(file, lines_of("v", slice.points), comm);
    write_texts(file, lines_of("vt", uv), comm);
    write_texts(file, lines_of(slice.triangles), comm);
  });
}

} // namespace program
