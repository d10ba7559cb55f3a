// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_RUN_IN_SUBPROCESS_H
#define CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_RUN_IN_SUBPROCESS_H

#include <CGAL/Flip_free_maps/internal/ask_deadline.h>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// How a function run by run_in_subprocess() ended.
enum class Apart_end
{
  returned, // with the code that is told
  crashed,  // by a signal
  interrupted,
  not_started
};

#if defined(__unix__) || defined(__APPLE__)
// The other process: calls `f(bytes)` and writes the bytes.
template <typename F>
[[noreturn]] void run_apart(F&& f, std::string& bytes, int output)
{
  const struct rlimit no_core_file
  {
    0, 0
  };
  ::setrlimit(RLIMIT_CORE, &no_core_file);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  if(nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  // The handlers of this program would carry on with it.
  for(const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGSEGV, SIGTERM})
    std::signal(signal, SIG_DFL);
  int result = 255;
  try {
    result = f(bytes);
  } catch(...) {
    ::_exit(255);
  }
  for(std::size_t done = 0; done < bytes.size();) {
    const ssize_t length = ::write(output, bytes.data() + done, bytes.size() - done);
    if(length < 0 && errno != EINTR)
      ::_exit(255);
    done += length > 0 ? static_cast<std::size_t>(length) : 0;
  }
  ::_exit(result);
}

// Reads all that the other process writes; `false` if there is no time left.
inline bool read_to_end(int input, std::string& bytes)
{
  constexpr int MILLISECONDS = 50;
  std::string chunk(std::size_t(1) << 16, '\0');
  while(deadline_status() == Status::success) {
    struct pollfd awaited = {input, POLLIN, 0};
    if(::poll(&awaited, 1, MILLISECONDS) <= 0)
      continue;
    const ssize_t length = ::read(input, &chunk[0], chunk.size());
    if(length > 0)
      bytes.append(chunk, 0, static_cast<std::size_t>(length));
    else if(length == 0 || errno != EINTR)
      return true;
  }
  return false;
}
#endif

// Calls `f(bytes)`, which fills a string and returns a code from 0 to 254, in a process of its own, so that nothing it does can
// harm this one: it may crash, throw (code 255) or print. It is ended by a `Deadline`. Where there is no fork() it is called
// directly.
template <typename F>
Apart_end run_in_subprocess(F&& f, std::string& bytes, int& code)
{
  bytes.clear();
#if defined(__unix__) || defined(__APPLE__)
  int ends[2];
  if(::pipe(ends) != 0)
    return Apart_end::not_started;
  const pid_t child = ::fork();
  if(child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    return Apart_end::not_started;
  }
  if(child == 0) {
    ::close(ends[0]);
    run_apart(f, bytes, ends[1]);
  }

  ::close(ends[1]);
  const bool is_read = read_to_end(ends[0], bytes);
  ::close(ends[0]);
  if(!is_read)
    ::kill(child, SIGKILL);
  int state = 0;
  pid_t ended = -1;
  do
    ended = ::waitpid(child, &state, 0);
  while(ended < 0 && errno == EINTR);
  // A signal to both processes may have ended the other one before it was seen here.
  if(deadline_status() != Status::success)
    return Apart_end::interrupted;
  if(ended != child || !WIFEXITED(state))
    return Apart_end::crashed;
  code = WEXITSTATUS(state);
#else
  code = f(bytes);
#endif
  return Apart_end::returned;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_TETRAHEDRALIZATION_INTERNAL_RUN_IN_SUBPROCESS_H
