// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_UNFINISHED_FILE_H
#define FLATTEN_MESH_UNFINISHED_FILE_H

#include "flatten_mesh/Unfinished_files.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace flatten_mesh {

// A file under a temporary name, which is locked as long as the process lives: a file that is not locked will never be
// completed. It is removed if a signal that can be handled ends the process.
class Unfinished_file
{
public:
  Unfinished_file() = default;

  Unfinished_file(const Unfinished_file&) = delete;
  Unfinished_file& operator=(const Unfinished_file&) = delete;

  ~Unfinished_file() { remove(); }

  // Creates it next to its target. Returns whether that was possible.
  bool create(const std::filesystem::path& target)
  {
    for(int trial = 0; trial < 100; ++trial) {
      m_name = target.string() + "." + std::to_string(::getpid()) + "." +
               std::to_string(std::random_device()()) + suffix();
      Unfinished_files::add(m_name.c_str());
      m_lock = ::open(m_name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if(m_lock < 0) {
        break;
      }
      while(::flock(m_lock, LOCK_EX) != 0 && errno == EINTR) { // not every file system has locks
      }
      struct stat status = {};
      if(::fstat(m_lock, &status) == 0 && status.st_nlink > 0) {
        return true;
      }
      forget(); // another process removed it before it was locked
    }
    forget();
    return false;
  }

  bool exists() const { return !m_name.empty(); }
  const std::string& name() const { return m_name; }

  // Gives it the name of its target. Returns whether that was possible.
  bool rename(const std::filesystem::path& target)
  {
    std::error_code error;
    std::filesystem::rename(m_name, target, error);
    if(!error) {
      forget();
    }
    return !error;
  }

  void remove()
  {
    if(exists()) {
      std::error_code ignored;
      std::filesystem::remove(m_name, ignored);
      forget();
    }
  }

  // In this process, `remove_abandoned()` does nothing from now on: another one does it once for many.
  static void leave_abandoned() { are_abandoned_left() = true; }

  // Removes the files in a folder that processes left which were killed.
  static void remove_abandoned(const std::filesystem::path& folder)
  {
    if(are_abandoned_left()) {
      return;
    }
    std::error_code error;
    for(std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
      if(is_temporary_name(i->path().filename().string())) {
        const std::string name = i->path().string();
        const int file = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if(file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
          ::unlink(name.c_str());
        }
        if(file >= 0) {
          ::close(file);
        }
      }
    }
  }

private:
  static bool& are_abandoned_left()
  {
    static bool instance = false;
    return instance;
  }

  static const char* suffix() { return ".unfinished"; }

  // TARGET.NUMBER.NUMBER.unfinished
  static bool is_temporary_name(std::string name)
  {
    if(!boost::algorithm::ends_with(name, suffix())) {
      return false;
    }
    name.resize(name.size() - std::string(suffix()).size());
    for(int i = 0; i < 2; ++i) {
      const std::size_t dot = name.find_last_not_of("0123456789");
      if(dot == std::string::npos || name[dot] != '.' || dot + 1 == name.size()) {
        return false;
      }
      name.resize(dot);
    }
    return !name.empty();
  }

  void forget()
  {
    Unfinished_files::remove(m_name.c_str());
    m_name.clear();
    if(m_lock >= 0) {
      ::close(m_lock);
      m_lock = -1;
    }
  }

  std::string m_name; // empty if there is none
  int m_lock = -1;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_UNFINISHED_FILE_H
