// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "large_pages.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#if defined(__linux__) && defined(__GLIBC__)
#include <unistd.h>
#endif

namespace program {

#if defined(__linux__) && defined(__GLIBC__)
namespace {

// A program that takes less than a second would rather not start twice.
constexpr std::uintmax_t LEAST_SIZE = std::uintmax_t(1) << 20;

bool is_large_file(const char* path)
{
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) >= LEAST_SIZE && !error;
}

} // namespace
#endif

void want_large_pages(int argc, char** argv)
{
#if defined(__linux__) && defined(__GLIBC__)
  const char* const variable = "GLIBC_TUNABLES";
  if(std::getenv(variable) != nullptr || std::none_of(argv + 1, argv + argc, is_large_file))
    return;
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  const std::string modes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if(modes.find("[madvise]") == std::string::npos || setenv(variable, "glibc.malloc.hugetlb=1", 0) != 0)
    return;
  execv("/proc/self/exe", argv);
#else
  static_cast<void>(argc);
  static_cast<void>(argv);
#endif
}

} // namespace program
