// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_VTK_NAMES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_VTK_NAMES_H

#include "Data_array.h"

#include <string>
#include <string_view>

namespace program {

// What VTK takes arrays for, in the attributes of its XML files.
constexpr const char* VTK_KINDS[] = {"Scalars", "Vectors", "Normals", "Tensors", "TCoords", "GlobalIds", "PedigreeIds"};

// The names of types in XML and in the old format.
struct VTK_type_name
{
  Number_type type;
  std::string_view xml, old;
};

constexpr VTK_type_name VTK_TYPE_NAMES[] = {{Number_type::int8, "Int8", "char"},
                                            {Number_type::uint8, "UInt8", "unsigned_char"},
                                            {Number_type::int16, "Int16", "short"},
                                            {Number_type::uint16, "UInt16", "unsigned_short"},
                                            {Number_type::int32, "Int32", "int"},
                                            {Number_type::uint32, "UInt32", "unsigned_int"},
                                            {Number_type::int64, "Int64", "vtktypeint64"},
                                            {Number_type::uint64, "UInt64", "vtktypeuint64"},
                                            {Number_type::float32, "Float32", "float"},
                                            {Number_type::float64, "Float64", "double"},
                                            // others that mean the same
                                            {Number_type::int8, "", "signed_char"},
                                            {Number_type::int32, "", "vtkidtype"},
                                            {Number_type::int32, "", "vtktypeint32"},
                                            {Number_type::int64, "", "long"},
                                            {Number_type::uint64, "", "unsigned_long"}};

inline std::string in_small_letters(std::string_view word)
{
  std::string result(word);
  for(char& c : result)
    if(c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return result;
}

// How the old format calls the section of a kind, in small letters.
inline std::string old_VTK_kind(std::string_view kind)
{
  return kind == "TCoords"       ? "texture_coordinates"
         : kind == "GlobalIds"   ? "global_ids"
         : kind == "PedigreeIds" ? "pedigree_ids"
                                 : in_small_letters(kind);
}

inline bool VTU_type(std::string_view name, Number_type& type)
{
  for(const VTK_type_name& entry : VTK_TYPE_NAMES)
    if(!entry.xml.empty() && entry.xml == name) {
      type = entry.type;
      return true;
    }
  return false;
}

// `name` in small letters.
inline bool old_VTK_type(std::string_view name, Number_type& type)
{
  for(const VTK_type_name& entry : VTK_TYPE_NAMES)
    if(entry.old == name) {
      type = entry.type;
      return true;
    }
  return false;
}

inline const VTK_type_name& VTK_type_of(Number_type type)
{
  for(const VTK_type_name& entry : VTK_TYPE_NAMES)
    if(entry.type == type)
      return entry;
  return VTK_TYPE_NAMES[0];
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_VTK_NAMES_H
