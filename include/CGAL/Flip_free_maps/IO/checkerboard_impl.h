// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_IMPL_H
#define CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_IMPL_H

#include <CGAL/Flip_free_maps/IO/checkerboard.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE void append_big_endian(std::string& bytes, std::uint32_t value)
{
  for(int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> shift & 255);
}

CGAL_FLIP_FREE_MAPS_INLINE void append_PNG_chunk(std::string& bytes, const std::string& type, const std::string& data)
{
  append_big_endian(bytes, static_cast<std::uint32_t>(data.size()));
  boost::crc_32_type crc;
  crc.process_bytes(type.data(), type.size());
  crc.process_bytes(data.data(), data.size());
  bytes += type + data;
  append_big_endian(bytes, crc.checksum());
}

CGAL_FLIP_FREE_MAPS_INLINE std::string stored_zlib_stream(const std::string& data)
{
  std::string bytes("\x78\x01", 2);
  const std::size_t max_length = 65535;
  for(std::size_t begin = 0; begin < data.size(); begin += max_length) {
    const std::size_t length = (std::min)(max_length, data.size() - begin);
    bytes += static_cast<char>(begin + length == data.size());
    for(const std::size_t value : {length, length ^ 0xffff}) {
      bytes += static_cast<char>(value & 255);
      bytes += static_cast<char>(value >> 8);
    }
    bytes.append(data, begin, length);
  }
  std::uint32_t a = 1, b = 0; // Adler-32
  for(const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  append_big_endian(bytes, b << 16 | a);
  return bytes;
}

CGAL_FLIP_FREE_MAPS_INLINE std::string checkerboard_PNG(int size, int squares)
{
  // Square i begins at the pixel size * i / squares, rounded down.
  const auto square_of = [=](int pixel) { return static_cast<int>(((pixel + 1LL) * squares - 1) / size); };
  std::string pixels;
  for(int y = 0; y < size; ++y) {
    pixels += '\0'; // no filter
    for(int x = 0; x < size; x += 8) {
      int bits = 0;
      for(int k = 0; k < 8 && x + k < size; ++k)
        bits |= (square_of(x + k) + square_of(y)) % 2 == 0 ? 128 >> k : 0;
      pixels += static_cast<char>(bits);
    }
  }
  std::string header;
  append_big_endian(header, size);
  append_big_endian(header, size);
  header += std::string("\x01\x03\x00\x00\x00", 5); // a bit per pixel, colors from the palette: a light and a blue one
  std::string bytes("\x89PNG\r\n\x1a\n");
  append_PNG_chunk(bytes, "IHDR", header);
  append_PNG_chunk(bytes, "PLTE", "\xf2\xf2\xed\x38\x6b\x9e");
  append_PNG_chunk(bytes, "IDAT", stored_zlib_stream(pixels));
  append_PNG_chunk(bytes, "IEND", "");
  return bytes;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE bool write_checkerboard_PNG(const std::string& path, int size, int squares, std::string* message)
{
  if(size < 1 || size > 16000 || squares < 1 || squares > size)
    return internal::fail(message, "cannot draw " + path + ": the size must be from 1 to 16000, and squares from 1 to the size");
  return internal::write_whole_file(path, internal::checkerboard_PNG(size, squares), message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_IO_CHECKERBOARD_IMPL_H
