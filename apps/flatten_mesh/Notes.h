// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NOTES_H
#define FLATTEN_MESH_NOTES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>

#include <functional>
#include <iostream>
#include <string>
#include <utility>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Notes that are printed on standard error at once, and kept for the report. `make_room` is called before one is
// printed.
inline Notes notes_of(
    const Command_line& command, std::function<void()> make_room = [] {})
{
  return Notes([&command, make_room = std::move(make_room)](std::string& text) {
    text = with_title(command, text);
    if(!command.quiet) {
      make_room();
      std::cerr << "flatten_mesh: note: " << in_one_line(text) << std::endl;
    }
  });
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NOTES_H
