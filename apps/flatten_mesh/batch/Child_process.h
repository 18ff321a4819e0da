// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHILD_PROCESS_H
#define FLATTEN_MESH_CHILD_PROCESS_H

#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Unfinished_files.h"
#include "flatten_mesh/batch/Child_processes.h"
#include "flatten_mesh/process_memory.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include <poll.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace flatten_mesh {

// A process that runs a function, whose exit status comes through a pipe: so a regular end differs from all others, as
// those by a signal or by a library that exits. Where several run, their output also comes through pipes.
class Child_process
{
public:
  using Clock = std::chrono::steady_clock;

  enum Stream
  {
    EXIT_STATUS,
    OUTPUT,
    ERRORS
  };

  enum Bound
  {
    NONE,
    TIME,
    MEMORY
  };

  // `run` is called in the new process.
  template <class Run>
  Child_process(const bool takes_output, const Clock::time_point deadline, const Run& run)
      : m_deadline(deadline)
  {
    Pipes pipes = {};
    const int number = takes_output ? 3 : 1;
    for(int i = 0; i < number; ++i) {
      if(::pipe(pipes[i].data()) != 0) {
        throw std::system_error(errno, std::generic_category(), "pipe()");
      }
    }
    std::cout.flush();
    std::cerr.flush();
    sigset_t signals, before; // none may come before the process is known
    ::sigfillset(&signals);
    ::sigprocmask(SIG_BLOCK, &signals, &before);
    m_id = ::fork();
    if(m_id == 0) {
      be_child(pipes, number, before);
      const char status = static_cast<char>(run());
      std::cout.flush();
      std::cerr.flush();
      while(::write(pipes[EXIT_STATUS][1], &status, 1) < 0 && errno == EINTR) {
      }
      std::_Exit(status); // threads of OpenBLAS may wait for memory, and a regular exit for them
    }
    const int error = errno;
    if(m_id > 0) {
      Child_processes::add(m_id);
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    for(int i = 0; i < number; ++i) {
      ::close(pipes[i][1]);
      m_files.push_back(pipes[i][0]);
    }
    if(m_id < 0) {
      close_files();
      throw std::system_error(error, std::generic_category(), "fork()");
    }
  }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  ~Child_process() { close_files(); }

  // What to wait for
  void append_to(std::vector<pollfd>& files) const
  {
    for(const int file : m_files) {
      if(file >= 0) {
        files.push_back({file, POLLIN, 0});
      }
    }
  }

  // Reads from a file that has something or has come to its end.
  void read(const int file)
  {
    for(std::size_t i = 0; i < m_files.size(); ++i) {
      if(m_files[i] == file) {
        char buffer[1 << 16];
        const ssize_t number = ::read(file, buffer, sizeof(buffer));
        if(number > 0) {
          m_texts[i].append(buffer, static_cast<std::size_t>(number));
        } else if(number == 0 || errno != EINTR) {
          ::close(file);
          m_files[i] = -1;
        }
      }
    }
  }

  // Ends the process if its time is over, or it holds more memory: first by a signal that lets it remove its files.
  void keep_bounds(const double megabytes)
  {
    if(has_ended()) {
      return;
    }
    const bool is_late = Clock::now() >= m_deadline;
    if(is_late || (m_exceeded == NONE && resident_memory_mb("VmRSS", std::to_string(m_id)) > megabytes)) {
      ::kill(m_id, m_exceeded == NONE ? SIGTERM : SIGKILL);
      m_exceeded = m_exceeded != NONE ? m_exceeded : is_late ? TIME : MEMORY;
      m_deadline = Clock::now() + std::chrono::milliseconds(100);
    }
  }

  Clock::time_point deadline() const { return m_deadline; }
  Bound exceeded() const { return m_exceeded; }
  const std::string& text(const Stream stream) const { return m_texts[stream]; }

  // Whether all its pipes are closed
  bool has_ended() const
  {
    for(const int file : m_files) {
      if(file >= 0) {
        return false;
      }
    }
    return true;
  }

  // How it ended, for `waitpid()`. Waits for it.
  int wait()
  {
    Child_processes::remove(m_id);
    int result = 0;
    while(::waitpid(m_id, &result, 0) < 0 && errno == EINTR) {
    }
    return result;
  }

private:
  using Pipes = std::array<std::array<int, 2>, 3>;

  static void be_child(const Pipes& pipes, const int number, const sigset_t& signals)
  {
    Child_processes::forget();
    Unfinished_files::remove_when_interrupted();
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGTERM); // nobody else keeps the deadline
#endif
    for(int i = 0; i < number; ++i) {
      ::close(pipes[i][0]);
    }
    if(number > 1) {
      ::dup2(pipes[OUTPUT][1], STDOUT_FILENO);
      ::dup2(pipes[ERRORS][1], STDERR_FILENO);
      ::close(pipes[OUTPUT][1]);
      ::close(pipes[ERRORS][1]);
    }
    ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  }

  void close_files()
  {
    for(int& file : m_files) {
      if(file >= 0) {
        ::close(file);
        file = -1;
      }
    }
  }

  pid_t m_id = 0;
  std::vector<int> m_files; // -1 where it is closed
  std::array<std::string, 3> m_texts;
  Clock::time_point m_deadline;
  Bound m_exceeded = NONE;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHILD_PROCESS_H
