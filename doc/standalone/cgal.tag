<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- What we refer to in CGAL's manual. Files are named as Doxygen names them. -->
<tagfile>
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html" title="Triangulated Surface Mesh Parameterization">PkgSurfaceMeshParameterization</docanchor>
    <docanchor file="Manual/packages.html" title="CGAL and Solvers">PkgSolverInterface</docanchor>
    <docanchor file="Manual/packages.html" title="Polygon Mesh Processing">PkgPolygonMeshProcessing</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license.html</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
    <docanchor file="Manual/license.html" title="LGPL">licensesLGPL</docanchor>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
  </compound>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="class">
    <name>Parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classParameterizer__3.html</filename>
  </compound>
  <compound kind="class">
    <name>SparseLinearAlgebraTraits_d</name>
    <filename>Solver_interface/classSparseLinearAlgebraTraits__d.html</filename>
  </compound>
  <compound kind="class">
    <name>SparseLinearAlgebraWithFactorTraits_d</name>
    <filename>Solver_interface/classSparseLinearAlgebraWithFactorTraits__d.html</filename>
  </compound>
  <compound kind="class">
    <name>NormalEquationSparseLinearAlgebraTraits_d</name>
    <filename>Solver_interface/classNormalEquationSparseLinearAlgebraTraits__d.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeListGraph</name>
    <filename>BGL/classHalfedgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
    <templarg>typename P</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Polyhedron_3</name>
    <filename>Polyhedron/classCGAL_1_1Polyhedron__3.html</filename>
    <templarg>typename Traits</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Seam_mesh</name>
    <filename>BGL/classCGAL_1_1Seam__mesh.html</filename>
    <templarg>class TM</templarg>
  </compound>
  <compound kind="struct">
    <name>CGAL::Face_filtered_graph</name>
    <filename>BGL/structCGAL_1_1Face__filtered__graph.html</filename>
    <templarg>typename Graph</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Eigen_solver_traits</name>
    <filename>Solver_interface/classCGAL_1_1Eigen__solver__traits.html</filename>
    <templarg>class T</templarg>
  </compound>
  <compound kind="struct">
    <name>CGAL::Eigen_sparse_matrix</name>
    <filename>Solver_interface/structCGAL_1_1Eigen__sparse__matrix.html</filename>
    <templarg>class T</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Eigen_vector</name>
    <filename>Solver_interface/classCGAL_1_1Eigen__vector.html</filename>
    <templarg>class T</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classCGAL_1_1Surface__mesh__parameterization_1_1LSCM__parameterizer__3.html</filename>
    <templarg>class TriangleMesh_</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_parameterization::ARAP_parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classCGAL_1_1Surface__mesh__parameterization_1_1ARAP__parameterizer__3.html</filename>
    <templarg>class TriangleMesh_</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3</name>
    <filename>Heat_method_3/classCGAL_1_1Heat__method__3_1_1Surface__mesh__geodesic__distances__3.html</filename>
    <templarg>typename TriangleMesh</templarg>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_deformation</name>
    <filename>Surface_mesh_deformation/classCGAL_1_1Surface__mesh__deformation.html</filename>
    <templarg>class TM</templarg>
  </compound>
</tagfile>
