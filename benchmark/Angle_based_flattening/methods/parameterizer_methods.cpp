// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Method.h"
#include "Parameterizer_method.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

namespace ABF_benchmark {

typedef CGAL::Surface_mesh<Chart::Point_3> Mesh;

template <typename Parameterizer>
Method parameterizer_method(const char* name, const char* title)
{
  return make_method<Parameterizer_method<Parameterizer>>(name, title);
}

std::vector<Method> parameterizer_methods()
{
  typedef SMP::LSCM_parameterizer_3<Mesh> LSCM;
  return {parameterizer_method<SMP::ABF_plus_plus_parameterizer_3<Mesh>>("abf++", "ABF++"),
          parameterizer_method<SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>>("habf++",
                                                                                      "hierarchical ABF++"),
          parameterizer_method<LSCM>("lscm", "LSCM (CGAL)"),
          parameterizer_method<SMP::Hierarchical_parameterizer_3<Mesh, LSCM>>("hlscm", "hierarchical LSCM"),
          parameterizer_method<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>(
              "conformal", "discrete conformal map, on a circle (CGAL)"),
          parameterizer_method<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(
              "mean-value", "mean value coordinates, on a circle (CGAL)"),
          parameterizer_method<SMP::ARAP_parameterizer_3<Mesh>>("arap", "ARAP (CGAL)"),
          parameterizer_method<SMP::Iterative_authalic_parameterizer_3<Mesh>>(
              "authalic", "iterative authalic, on a circle (CGAL)")};
}

} // namespace ABF_benchmark
