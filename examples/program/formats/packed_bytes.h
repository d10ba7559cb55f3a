// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Texts in base64, and blocks of bytes compressed by zlib, which is an optional component.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_PACKED_BYTES_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_PACKED_BYTES_H

#include <cstddef>
#include <string>
#include <string_view>

namespace program {

// So many bytes of a text in base64, or fewer if it ends before. Padding may stand in the middle, where several texts are one after
// the other.
std::string decode_base64(std::string_view text, std::size_t size);

std::string encode_base64(std::string_view bytes);

bool can_compress();

// Adds the bytes of a compressed block, which must be so many. Returns the empty string, or a reason.
std::string decompress(std::string_view block, std::size_t size, std::string& bytes);

// Empty without zlib.
std::string compress(std::string_view bytes);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_PACKED_BYTES_H
