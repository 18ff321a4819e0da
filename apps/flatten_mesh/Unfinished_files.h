// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_UNFINISHED_FILES_H
#define FLATTEN_MESH_UNFINISHED_FILES_H

#include <array>
#include <atomic>
#include <csignal>

#include <unistd.h>

namespace flatten_mesh {

// The temporary files of this process. They are removed if a signal ends it.
class Unfinished_files
{
public:
  // Starts to handle signals.
  static void remove_when_interrupted()
  {
    for(const int signal : signals()) {
      if(std::signal(signal, remove_and_die) == SIG_IGN) { // ignored under `nohup` and in background scripts
        std::signal(signal, SIG_IGN);
      }
    }
  }

  // From now on signals have to wait, so that either all complete files get their names or none.
  static void defer_interruptions() { is_deferring() = 1; }

  // Ends that. A signal that has come meanwhile takes effect.
  static void heed_interruptions()
  {
    is_deferring() = 0;
    if(const int signal = deferred_signal()) {
      remove_and_die(signal);
    }
  }

  // The string must not move until it is removed.
  static void add(const char* name) { replace(nullptr, name); }

  static void remove(const char* name) { replace(name, nullptr); }

  static const std::array<int, 4>& signals()
  {
    static const std::array<int, 4> instance = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    return instance;
  }

  // Calls only async-signal-safe functions.
  static void remove_and_die(const int signal)
  {
    if(is_deferring() != 0) {
      deferred_signal() = signal;
      return;
    }
    for(const std::atomic<const char*>& name : names()) {
      if(const char* file = name.load()) {
        ::unlink(file);
      }
    }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }

private:
  using Names = std::array<std::atomic<const char*>, 16>; // more than the number of outputs

  static Names& names()
  {
    static Names instance{};
    return instance;
  }

  static volatile std::sig_atomic_t& is_deferring()
  {
    static volatile std::sig_atomic_t instance = 0;
    return instance;
  }

  static volatile std::sig_atomic_t& deferred_signal()
  {
    static volatile std::sig_atomic_t instance = 0;
    return instance;
  }

  static void replace(const char* before, const char* after)
  {
    for(std::atomic<const char*>& name : names()) {
      const char* expected = before;
      if(name.compare_exchange_strong(expected, after)) {
        return;
      }
    }
  }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_UNFINISHED_FILES_H
