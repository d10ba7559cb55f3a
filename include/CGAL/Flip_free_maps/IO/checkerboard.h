// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_H
#define CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_H

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <boost/crc.hpp>

#include <cstdint>
#include <string>

/// \file

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

void append_big_endian(std::string& bytes, std::uint32_t value);

void append_PNG_chunk(std::string& bytes, const std::string& type, const std::string& data);

// A zlib stream whose blocks are stored: a bit per pixel is small enough, and no library is needed.
std::string stored_zlib_stream(const std::string& data);

// The content of the image that `write_checkerboard_PNG()` writes.
std::string checkerboard_PNG(int size, int squares);

} // namespace internal

/// \ingroup PkgFlipFreeMapsIO
/// Writes a square PNG image with a checkerboard, to be used as a texture. It tiles seamlessly if `squares` is even.
///
/// \param path name of the file; an existing file is replaced
/// \param size side of the image in pixels, from 1 to 16000
/// \param squares number of squares along a side, from 1 to `size`
/// \param message if not null, receives the reason of a failure, and the empty string on success
///
/// \returns `false` if a number is out of range or if the file cannot be written
bool write_checkerboard_PNG(const std::string& path, int size, int squares, std::string* message = nullptr);

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/IO/checkerboard_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_H
