// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Stands for the parts that the program is built without. `check_parts()` lets no command come this far.

#include <CGAL/assertions.h>

#ifdef FLATTEN_MESH_WITHOUT_PLAIN
#include "flatten_mesh/plain/run_plain.h"

namespace flatten_mesh {

Exit_status run_plain(const Command_line&)
{
  CGAL_error_msg("built without the part for --plain");
}

} // namespace flatten_mesh
#endif

#ifdef FLATTEN_MESH_WITHOUT_BAKING
#include "flatten_mesh/bake/bake_textures.h"
#include "flatten_mesh/bake/simplify_input.h"

namespace flatten_mesh {

Baked_surface bake_textures(const Command_line&, Atlas_input&, const Atlas&, Notes&)
{
  CGAL_error_msg("built without the part for --bake-from");
}

void simplify_input(std::size_t, Atlas_input&, Notes&)
{
  CGAL_error_msg("built without the part for --simplify");
}

} // namespace flatten_mesh
#endif

#ifdef FLATTEN_MESH_WITHOUT_PAGES
#include "flatten_mesh/report/report_page.h"

namespace flatten_mesh {

std::string report_page(const Report_contents&, int)
{
  CGAL_error_msg("built without the part for --report");
}

} // namespace flatten_mesh
#endif

#ifdef FLATTEN_MESH_WITHOUT_GLB
#include "flatten_mesh/model/glb_text.h"
#include "flatten_mesh/model/gltf_surface.h"

namespace flatten_mesh {

std::string glb_text(const std::vector<Glb_material>&, const std::vector<Glb_primitive>&, const Glb_pictures&,
                     const std::array<double, 3>&)
{
  CGAL_error_msg("built without the part for .glb files");
}

Gltf_surface gltf_surface(std::string_view, bool, const std::string&, const Gltf_options&)
{
  CGAL_error_msg("built without the part for .glb files");
}

std::string gltf_with_texture(const Gltf_file&, const std::vector<Gltf_triangles>&, const Gltf_texture&,
                              const std::string&)
{
  CGAL_error_msg("built without the part for .glb files");
}

} // namespace flatten_mesh
#endif
