// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_HELP_TEXT_H
#define FLATTEN_MESH_HELP_TEXT_H

#include "flatten_mesh/describe_options.h"

#include <sstream>
#include <string>

namespace flatten_mesh {

inline std::string help_text()
{
  Command_line defaults;
  std::ostringstream text;
  text
      << "flatten_mesh: makes a texture atlas of a surface. It cuts the surface open along short seams,\n"
         "flattens it without overlap by angle-based flattening (ABF++), and packs the charts into the unit\n"
         "square.\n\n"
         "usage: flatten_mesh FILE... [options]\n"
      << internal::all_options(defaults).description()
      << "\nExamples:\n"
         "  flatten_mesh cow.off --output cow.obj --report cow.html\n"
         "  flatten_mesh scan.ply --for few-charts --resolution 4096 --output scan.obj --svg scan.svg\n"
         "  flatten_mesh model.obj --seams-from uv --output model_atlas.obj --json model.json\n"
         "  flatten_mesh parts/*.stl --output 'atlas/%.obj' --json 'atlas/%.json' --quiet\n"
         "  flatten_mesh - --format ply --output - < scan.ply > scan.obj\n"
         "  flatten_mesh scan.ply --plain --output flat.obj --svg flat.svg\n"
         "  flatten_mesh garment.obj --plain --component 2 --output sleeve.obj --json sleeve.json\n"
         "  flatten_mesh mask.off --plain --barrier 0 --layout least-squares --step sqp --verbose\n"
         "\nMessages count vertices, faces and lines from 1, as OBJ files do.\n"
         "\nExit status: 0 if each face has a chart, no triangle is flipped, and all outputs are written.\n"
         "1 if the computation failed. 2 if the command line or the input is wrong, or an output cannot be\n"
         "written; with 1 and 2, no models, pictures or pages are written. Also 2 if parts of the surface\n"
         "cannot be flattened: all other parts are flattened, and the outputs are written. 3 if the time of\n"
         "--timeout is over, 4 if memory ran out, 5 if the process of an input crashed. With several "
         "inputs,\n"
         "all are tried; the exit status is the first one that is not 0.\n";
  return text.str();
}

inline std::string version_text()
{
  return "flatten_mesh " ABF_VERSION "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_HELP_TEXT_H
