# What CGAL's build does with the pages after Doxygen, and what they need to be read without a network.
# Usage: cmake -D HTML=DIR -D MATHJAX_DIR=DIR -P finish.cmake

# Figures are numbered in the order of their anchors in the manual; Doxygen shows a reference as the anchor's name.
file(READ ${HTML}/index.html page)
string(REGEX MATCHALL "id=\"fig__[A-Za-z0-9_]+\"" anchors "${page}")
set(number 0)
foreach(anchor IN LISTS anchors)
  math(EXPR number "${number} + 1")
  string(REGEX REPLACE "id=\"(.*)\"" "\\1" name "${anchor}")
  string(REPLACE ">${name}</a>" ">${number}</a>" page "${page}")
endforeach()
if(page MATCHES ">(fig__[A-Za-z0-9_]+)</a>")
  message(FATAL_ERROR "a reference to the figure ${CMAKE_MATCH_1}, which is nowhere")
endif()
file(WRITE ${HTML}/index.html "${page}")

# Names are shown without what all of them have in common, which is too long for the navigation.
foreach(tree group__PkgAngleBasedFlatteningRef.js examples.js)
  file(READ ${HTML}/${tree} text)
  string(REGEX REPLACE "\\[ \"(CGAL::Surface_mesh_parameterization::|Angle_based_flattening/)" "[ \"" text "${text}")
  file(WRITE ${HTML}/${tree} "${text}")
endforeach()

foreach(part MathJax.js extensions jax/element jax/input/TeX jax/output/SVG localization/en)
  get_filename_component(folder mathjax/${part} DIRECTORY)
  file(COPY ${MATHJAX_DIR}/${part} DESTINATION ${HTML}/${folder} FOLLOW_SYMLINK_CHAIN
    REGEX "/fonts/[^T/][^/]*$" EXCLUDE)
endforeach()
