// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// What the fuzz targets share. Inputs go through files, since that is how they come to the readers, and since a reader chooses by name.

#ifndef FLIP_FREE_MAPS_FUZZ_SUPPORT_H
#define FLIP_FREE_MAPS_FUZZ_SUPPORT_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <stdlib.h>

// What libFuzzer calls with every input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size)
{
  return std::string_view(reinterpret_cast<const char*>(data), size);
}

// A file of this process, in a folder of its own.
inline std::string file(const std::string& name)
{
  static const std::filesystem::path directory = [] {
    std::string path = (std::filesystem::temp_directory_path() / "flip_free_maps_fuzz_XXXXXX").string();
    return std::filesystem::path(::mkdtemp(path.data()));
  }();
  return (directory / name).string();
}

inline std::string write(const std::string& name, std::string_view content)
{
  const std::string path = file(name);
  std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  return path;
}

// Ends the process, which is how libFuzzer learns of a fault that is no crash by itself.
inline void demand(bool condition, const std::string& what)
{
  if(condition)
    return;
  std::fprintf(stderr, "wrong: %s\n", what.c_str());
  std::abort();
}

} // namespace fuzz

#endif // FLIP_FREE_MAPS_FUZZ_SUPPORT_H
