// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_RUN_H
#define SWEEP_RUN_H

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace sweep {

// One component of a mesh, flattened once.
struct Run
{
  int component = 0;
  long triangles = 0;
  int borders = 0;
  bool allow_holes = false;

  int code = 0;           // what the parameterizer returned
  bool injective = false; // as a whole
  double seconds = 0;
  std::string fault;   // what must never happen; empty otherwise
  std::string message; // of the parameterizer

  bool is_valid() const { return fault.empty() && code == 0; }
};

// What was done with a file.
struct File_results
{
  std::string file;
  std::string unreadable; // the reason; empty if the file could be read
  std::string fault;      // what must never happen, apart from a run
  long closed = 0;        // components that were skipped
  std::vector<Run> runs;
};

// A process tells of a run before and after it, line by line, so that what it was at is known if it crashes.
constexpr const char* begin_tag = "sweep-begin";
constexpr const char* end_tag = "sweep-end";
constexpr const char* closed_tag = "sweep-closed";
constexpr const char* unreadable_tag = "sweep-unreadable";

inline std::string in_one_line(std::string text)
{
  for(char& c : text) {
    if(c == '\n' || c == '\t') {
      c = ' ';
    }
  }
  return text;
}

inline void tell_begin(std::ostream& out, const Run& run)
{
  out << '\n'
      << begin_tag << ' ' << run.component << ' ' << run.triangles << ' ' << run.borders << ' '
      << run.allow_holes << std::endl;
}

inline void tell_end(std::ostream& out, const Run& run)
{
  out << '\n'
      << end_tag << ' ' << run.code << ' ' << run.injective << ' ' << run.seconds << '\t'
      << in_one_line(run.fault) << '\t' << in_one_line(run.message) << std::endl;
}

// Adds what a process told to the results of the file. Returns whether the last run that began has ended.
inline bool take_output(const std::string& output, File_results& results)
{
  bool ended = true;
  std::istringstream lines(output);
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string tag;
    words >> tag;
    if(tag == begin_tag) {
      ended = false;
      results.runs.emplace_back();
      Run& run = results.runs.back();
      words >> run.component >> run.triangles >> run.borders >> run.allow_holes;
    } else if(tag == end_tag && !ended) {
      ended = true;
      Run& run = results.runs.back();
      words >> run.code >> run.injective >> run.seconds;
      words.ignore();
      std::getline(words, run.fault, '\t');
      std::getline(words, run.message);
    } else if(tag == closed_tag) {
      words >> results.closed;
    } else if(tag == unreadable_tag) {
      std::getline(words >> std::ws, results.unreadable);
    }
  }
  return ended;
}

} // namespace sweep

#endif // SWEEP_RUN_H
