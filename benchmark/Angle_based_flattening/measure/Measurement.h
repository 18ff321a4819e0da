// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_MEASUREMENT_H
#define ABF_BENCHMARK_MEASUREMENT_H

#include <CGAL/Real_timer.h>

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>

namespace ABF_benchmark {

// The results of a run: names and values, printed as a JSON object in one line, with NaN and Infinity as Python reads
// them. After a failure the object contains its reason, and other values may be missing.
class Measurement
{
public:
  template <class Number>
  std::enable_if_t<std::is_arithmetic_v<Number>> add(const std::string& name, const Number number)
  {
    const double value = static_cast<double>(number);
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
    put(name, value != value       ? "NaN"
              : value - value == 0 ? text.str()
              : value > 0          ? "Infinity"
                                   : "-Infinity");
  }

  void add(const std::string& name, std::string text)
  {
    std::replace_if(
        text.begin(), text.end(), [](const unsigned char c) { return c < ' '; }, ' ');
    std::ostringstream quoted;
    quoted << std::quoted(text); // the same escapes as in JSON, except for control characters
    put(name, quoted.str());
  }

  void fail(const std::string& reason)
  {
    m_failed = true;
    add("failure", reason);
  }

  bool failed() const { return m_failed; }

  // Libraries may print to the same stream, perhaps without an end of line.
  friend std::ostream& operator<<(std::ostream& out, const Measurement& m)
  {
    return out << "\n{" << m.m_members << "}" << std::endl;
  }

private:
  void put(const std::string& name, const std::string& value)
  {
    m_members += (m_members.empty() ? "\"" : ", \"") + name + "\": " + value;
  }

  std::string m_members;
  bool m_failed = false;
};

template <class Function>
double seconds_of(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

// The time since the object was constructed, also that of all threads, the largest increase of this process's memory
// since then, and the number of pages that the system handed out. Memory on Linux only.
class Gauge
{
public:
  Gauge()
  {
    malloc_trim(0);                                // otherwise reuse of freed memory would not be counted
    std::ofstream("/proc/self/clear_refs") << "5"; // resets the peak to the current use
    m_bytes_before = peak();
    m_usage_before = usage();
    m_timer.start();
  }

  double bytes() const { return (std::max)(0., peak() - m_bytes_before); }

  void add_to(Measurement& m) const
  {
    m.add("seconds", m_timer.time());
    const rusage after = usage();
    m.add("cpu", cpu_seconds(after) - cpu_seconds(m_usage_before));
    m.add("faults", after.ru_minflt - m_usage_before.ru_minflt);
    m.add("bytes", bytes());
  }

private:
  static double peak()
  {
    std::ifstream status("/proc/self/status");
    for(std::string word; status >> word;)
      if(double kilobytes; word == "VmHWM:" && status >> kilobytes)
        return 1024 * kilobytes;
    return 0;
  }

  static rusage usage()
  {
    rusage result;
    getrusage(RUSAGE_SELF, &result);
    return result;
  }

  static double cpu_seconds(const rusage& u)
  {
    return u.ru_utime.tv_sec + u.ru_stime.tv_sec + 1e-6 * (u.ru_utime.tv_usec + u.ru_stime.tv_usec);
  }

  rusage m_usage_before;
  CGAL::Real_timer m_timer;
  double m_bytes_before;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_MEASUREMENT_H
