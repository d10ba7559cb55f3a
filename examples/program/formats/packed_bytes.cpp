// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "packed_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#ifdef CGAL_FLIP_FREE_MAPS_USE_ZLIB
#include <zlib.h>
#endif

namespace program {

namespace {

constexpr std::string_view DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The value of each character, or -1.
std::array<signed char, 256> digit_values()
{
  std::array<signed char, 256> values;
  values.fill(-1);
  for(std::size_t i = 0; i < DIGITS.size(); ++i)
    values[static_cast<unsigned char>(DIGITS[i])] = static_cast<signed char>(i);
  return values;
}

} // namespace

std::string decode_base64(std::string_view text, std::size_t size)
{
  static const std::array<signed char, 256> values = digit_values();
  std::string bytes;
  bytes.reserve((std::min)(size, text.size() / 4 * 3 + 3));
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(std::size_t i = 0; i < text.size() && bytes.size() < size; ++i) {
    const int digit = values[static_cast<unsigned char>(text[i])];
    if(digit >= 0) {
      bits = bits << 6 | static_cast<std::uint32_t>(digit);
      number_of_bits += 6;
      if(number_of_bits >= 8) {
        number_of_bits -= 8;
        bytes += static_cast<char>(bits >> number_of_bits & 255);
      }
    } else if(text[i] == '=')
      number_of_bits = 0;
    else if(text[i] != ' ' && text[i] != '\t' && text[i] != '\r' && text[i] != '\n')
      break;
  }
  return bytes;
}

std::string encode_base64(std::string_view bytes)
{
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : DIGITS[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_ZLIB

bool can_compress() { return true; }

std::string decompress(std::string_view block, std::size_t size, std::string& bytes)
{
  z_stream stream{};
  if(block.size() > (std::numeric_limits<uInt>::max)() || inflateInit(&stream) != Z_OK)
    return "a compressed block is too large";
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
  stream.avail_in = static_cast<uInt>(block.size());
  const std::size_t begin = bytes.size();
  std::array<char, 1 << 16> buffer;
  int status = Z_OK;
  while(status == Z_OK && bytes.size() - begin <= size) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    status = inflate(&stream, Z_NO_FLUSH);
    bytes.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END && bytes.size() - begin == size ? "" : "a compressed block is broken, or of another size than it says";
}

std::string compress(std::string_view bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string block(size, '\0');
  const int status =
    ::compress(reinterpret_cast<Bytef*>(&block[0]), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  block.resize(status == Z_OK ? size : 0);
  return block;
}

#else

bool can_compress() { return false; }

std::string decompress(std::string_view, std::size_t, std::string&)
{
  return "numbers are compressed, and this program was built without zlib (Debian: zlib1g-dev)";
}

std::string compress(std::string_view) { return ""; }

#endif

} // namespace program
