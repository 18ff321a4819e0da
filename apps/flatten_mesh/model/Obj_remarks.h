// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OBJ_REMARKS_H
#define FLATTEN_MESH_OBJ_REMARKS_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <string>

namespace flatten_mesh {

// The parts of an OBJ file that are left out.
class Obj_remarks
{
public:
  void skip_line(const std::size_t line, const std::string& keyword)
  {
    if(m_skipped++ == 0) {
      m_first_skipped =
          "line " + std::to_string(line) + ", which begins with '" + keyword.substr(0, 20) + "'";
    }
  }

  // A colour, texture coordinate or normal that is not understood
  void ignore_attribute(const std::size_t line)
  {
    if(m_ignored++ == 0) {
      m_line_of_ignored = line;
    }
  }

  // A corner names texture coordinates or a normal that the file does not have.
  void miss_attribute() { ++m_missed; }

  // For a message about a file without faces
  std::string first_skipped() const
  {
    return m_skipped > 0 ? " (" + m_first_skipped + ", was not understood)" : "";
  }

  void tell_skipped(const std::string& file, Notes& notes) const
  {
    if(m_skipped > 0) {
      notes.add("'" + file + "': " + count_text(m_skipped, "line") +
                " not understood and skipped: " + (m_skipped > 1 ? "the first is " : "") + m_first_skipped);
    }
  }

  void tell_attributes(const std::string& file, Notes& notes) const
  {
    if(m_ignored > 0) {
      notes.add("'" + file + "': " +
                count_text(m_ignored, "colour, texture coordinate or normal",
                           "colours, texture coordinates or normals") +
                " not understood and left out: the first in line " + std::to_string(m_line_of_ignored));
    }
    if(m_missed > 0) {
      notes.add("'" + file + "': texture coordinates or normals that do not exist are named " +
                count_text(m_missed, "time") + ", and left out");
    }
  }

private:
  std::size_t m_skipped = 0;
  std::string m_first_skipped;
  std::size_t m_ignored = 0, m_line_of_ignored = 0;
  std::size_t m_missed = 0;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OBJ_REMARKS_H
