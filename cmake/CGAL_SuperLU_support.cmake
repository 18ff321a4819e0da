# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

if(SuperLU_FOUND AND TARGET SuperLU::SuperLU AND NOT TARGET CGAL::SuperLU_support)
  add_library(CGAL::SuperLU_support INTERFACE IMPORTED)
  set_target_properties(CGAL::SuperLU_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS "CGAL_SUPERLU_ENABLED"
    INTERFACE_LINK_LIBRARIES SuperLU::SuperLU)
endif()
