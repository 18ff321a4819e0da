// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_RUN_CHILD_H
#define BENCHMARKS_COMMON_RUN_CHILD_H

#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

struct Child_limits
{
  unsigned seconds;
  double gigabytes;
};

struct Child_result
{
  std::string output;
  int status; // as of waitpid()

  // Why there may be no result, or nothing if the child ended well
  std::string failure(const Child_limits& limits) const
  {
    if(WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
      return "took longer than " + std::to_string(limits.seconds) + " s";
    }
    if(WIFSIGNALED(status)) {
      return "killed by signal " + std::to_string(WTERMSIG(status));
    }
    return WEXITSTATUS(status) == 0 ? "" : "ended with status " + std::to_string(WEXITSTATUS(status));
  }
};

namespace internal {

// Runs this very program, in the present process. The limits outlive exec().
[[noreturn]] inline void become(std::vector<std::string> arguments, const Child_limits& limits,
                                const int output)
{
  const rlim_t bytes = static_cast<rlim_t>(limits.gigabytes * (1 << 30));
  const rlimit memory = {bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
  alarm(limits.seconds); // nobody handles the signal: it ends the process
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  dup2(output, STDOUT_FILENO);
  close(output);

  const char* program = "/proc/self/exe";
  arguments.insert(arguments.begin(), program);
  std::vector<char*> pointers;
  for(std::string& argument : arguments) {
    pointers.push_back(&argument[0]);
  }
  pointers.push_back(nullptr);
  execv(program, pointers.data());
  _exit(127);
}

inline std::string read_all(const int input)
{
  std::string text;
  char buffer[4096];
  while(true) {
    const ssize_t size = read(input, buffer, sizeof(buffer));
    if(size > 0) {
      text.append(buffer, static_cast<std::size_t>(size));
    } else if(size == 0 || errno != EINTR) {
      return text;
    }
  }
}

} // namespace internal

// Runs this program once more with other arguments, on one thread of the BLAS, until it ends or exceeds a limit.
inline Child_result run_child(const std::vector<std::string>& arguments, const Child_limits& limits)
{
  int ends[2];
  if(pipe(ends) != 0) {
    throw std::runtime_error("cannot make a pipe");
  }
  const pid_t child = fork();
  if(child < 0) {
    throw std::runtime_error("cannot start a process");
  }
  if(child == 0) {
    close(ends[0]);
    internal::become(arguments, limits, ends[1]);
  }
  close(ends[1]);
  Child_result result = {internal::read_all(ends[0]), 0};
  close(ends[0]);
  while(waitpid(child, &result.status, 0) < 0 && errno == EINTR) {
  }
  return result;
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_RUN_CHILD_H
