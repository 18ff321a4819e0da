// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHILD_PROCESSES_H
#define FLATTEN_MESH_CHILD_PROCESSES_H

#include "flatten_mesh/Unfinished_files.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

#include <sys/types.h>
#include <sys/wait.h>

namespace flatten_mesh {

// The processes that this one has started. If a signal ends it, they end before.
class Child_processes
{
public:
  static constexpr int largest_number = 256;

  // Starts to handle signals.
  static void end_when_interrupted()
  {
    for(const int signal : Unfinished_files::signals()) {
      if(std::signal(signal, end_all_and_die) == SIG_IGN) {
        std::signal(signal, SIG_IGN);
      }
    }
  }

  static void add(const pid_t process) { replace(0, process); }

  static void remove(const pid_t process) { replace(process, 0); }

  // In a new process, which has none
  static void forget()
  {
    for(std::atomic<pid_t>& process : processes()) {
      process = 0;
    }
  }

private:
  using Processes = std::array<std::atomic<pid_t>, largest_number>;

  static Processes& processes()
  {
    static Processes instance{};
    return instance;
  }

  static void replace(const pid_t before, const pid_t after)
  {
    for(std::atomic<pid_t>& process : processes()) {
      pid_t expected = before;
      if(process.compare_exchange_strong(expected, after)) {
        return;
      }
    }
  }

  // Calls only async-signal-safe functions.
  static void end_all_and_die(const int signal)
  {
    for(const std::atomic<pid_t>& process : processes()) {
      if(const pid_t id = process.load()) {
        ::kill(id, signal);
      }
    }
    for(const std::atomic<pid_t>& process : processes()) { // they remove their unfinished files
      if(const pid_t id = process.load()) {
        while(::waitpid(id, nullptr, 0) < 0 && errno == EINTR) {
        }
      }
    }
    Unfinished_files::remove_and_die(signal);
  }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHILD_PROCESSES_H
