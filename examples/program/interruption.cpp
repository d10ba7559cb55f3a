// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "interruption.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#if defined(__unix__) || defined(__APPLE__)
#include <time.h>
#include <unistd.h>
#endif

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace program {

namespace {

volatile std::sig_atomic_t signal_number = 0;

// The file that is being written. A handler of signals may read nothing but such things.
constexpr std::size_t LONGEST_PATH = 4096;
char temporary_file[LONGEST_PATH];
volatile std::sig_atomic_t has_temporary_file = 0;

void note_temporary_file(const char* path)
{
  has_temporary_file = 0;
  if(path == nullptr || std::strlen(path) >= LONGEST_PATH)
    return;
  std::strcpy(temporary_file, path);
  has_temporary_file = 1;
}

#if defined(__unix__) || defined(__APPLE__)
// Milliseconds of a clock that handlers may read.
long long milliseconds()
{
  timespec now;
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000LL * now.tv_sec + now.tv_nsec / 1000000;
}

// Read and written by handlers only.
long long first_signal_at = 0;
#endif

// Whether the first signal came just now: timeout(1) sends it to the program and once more to its group, which is one wish.
bool is_echo()
{
#if defined(__unix__) || defined(__APPLE__)
  return milliseconds() - first_signal_at < 200;
#else
  return false;
#endif
}

extern "C" void handle_signal(int signal)
{
  std::signal(signal, handle_signal); // some systems have forgotten it
  if(signal_number == 0) {
#if defined(__unix__) || defined(__APPLE__)
    first_signal_at = milliseconds();
#endif
    signal_number = signal;
    return;
  }
  if(is_echo())
    return;
#if defined(__unix__) || defined(__APPLE__)
  if(has_temporary_file)
    ::unlink(temporary_file);
#endif
  std::_Exit(exit_code_of_signal(signal));
}

} // namespace

void catch_signals()
{
  CGAL::Flip_free_maps::internal::temporary_file_observer() = note_temporary_file;
  for(const int signal : {SIGINT, SIGTERM})
    if(std::signal(signal, handle_signal) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

int received_signal() { return signal_number; }

} // namespace program
