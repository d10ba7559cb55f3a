// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_MEDIT_H
#define CGAL_FLIP_FREE_MAPS_IO_MEDIT_H

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// \file

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// The references of a file's entities, where there are any.
struct Medit_references
{
  std::vector<long long> points, triangles, tetrahedra;
};

class Medit_reader
{
public:
  // Returns the empty string, or what is wrong with the file.
  std::string read(std::string_view text);

  Tetrahedral_mesh& mesh() { return m_mesh; }

  // As many as there are entities; 0 where the file gives none.
  const Medit_references& references() const { return m_references; }

private:
  bool read_section(Word_reader& reader);

  bool read_points(Word_reader& reader);

  template <std::size_t N>
  bool read_elements(Word_reader& reader, std::vector<std::array<int, N>>& elements, std::vector<long long>& references)
  {
    std::size_t count = 0;
    if(!reader.read_count(count))
      return false;
    elements.reserve(elements.size() + (std::min)(count, reader.possible_items(N)));
    for(std::size_t i = 0; i < count; ++i) {
      std::array<int, N> element;
      for(int& index : element) {
        long long value = 0;
        const long long line = reader.line();
        if(!reader.read_integer(value))
          return false;
        const long long largest = m_has_points ? static_cast<long long>(m_mesh.points.size()) : (std::numeric_limits<int>::max)();
        if(value < 1 || value > largest)
          return reader.fail_at(line, "vertex index " + std::to_string(value) + " is not from 1 to " + std::to_string(largest));
        index = static_cast<int>(value - 1);
      }
      elements.push_back(element);
      if(!read_reference(reader, references))
        return false;
    }
    return true;
  }

  // Some programs leave the reference out; then the next word begins a new line.
  static bool read_reference(Word_reader& reader, std::vector<long long>& references);

  Tetrahedral_mesh m_mesh;
  Medit_references m_references;
  bool m_has_points = false;
  bool m_is_skipping = true; // the number of the version follows the first word
};

// The content of a file. Where there are no references, they are 0 for points and 1 for triangles and tetrahedra.
std::string Medit_text(const Tetrahedral_mesh& mesh, const Medit_references& references = Medit_references());

} // namespace internal

/*!
  \ingroup PkgFlipFreeMapsIO

  reads points, tetrahedra and triangles from a Medit file in ASCII (`.mesh`, dimension 3).

  References of entities may be missing. Comments, all other sections but those of other
  elements with a volume, and whatever follows `End` are ignored; the line
  ends of all systems are understood. The locale has no influence. The cost is linear in the size of the file.

  \param path name of the file
  \param mesh receives the mesh; it is not changed if the file cannot be read
  \param message if not null, receives the reason of a failure with the number of the line, and the empty string on success

  \returns `false` if the file cannot be opened, is not a Medit file in ASCII, ends within a section, or has a coordinate that is
           not a finite number or an index that is out of range, or if it has hexahedra, prisms, pyramids or tetrahedra of second order. A file without tetrahedra is read without complaint.
*/
inline bool read_Medit(const std::string& path, Tetrahedral_mesh& mesh, std::string* message = nullptr)
{
  return internal::read_mesh_with<internal::Medit_reader>(path, mesh, message);
}

/*!
  \ingroup PkgFlipFreeMapsIO

  writes a tetrahedral mesh as a Medit file in ASCII. References are 0 for points and 1 for triangles and tetrahedra.

  Numbers are written with as many digits (up to 17) as it takes to read back exactly the same doubles. The cost is linear.

  \param path name of the file; an existing file is replaced
  \param mesh the mesh; its coordinates must be finite and its indices valid
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `true` if the file was written. An invalid mesh is refused before the file is touched.
*/
bool write_Medit(const std::string& path, const Tetrahedral_mesh& mesh, std::string* message = nullptr);

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/IO/Medit_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IO_MEDIT_H
