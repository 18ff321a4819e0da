/*!
\ingroup PkgAngleBasedFlatteningConcepts
\cgalConcept

A visitor follows a parameterizer, and may stop it. It is an argument of `flatten_surface()`, as the named parameter
`visitor`, or `Flattening_options::visitor`. A model derives from
`CGAL::Surface_mesh_parameterization::Flattening_visitor`, whose functions do nothing, and overrides what it needs.

One thread at a time calls the functions, but not always the caller of the parameterizer.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_parameterization::Flattening_visitor}
\cgalHasModelsEnd
*/
class FlatteningVisitor
{
public:
  /// is called when a stage begins. Returns whether to continue.
  bool start(CGAL::Surface_mesh_parameterization::Flattening_visitor::Stage stage);

  /// is called after each Newton step, with its entry in the report. Returns whether to continue.
  bool step(const CGAL::Surface_mesh_parameterization::ABF_plus_plus_step& step);

  /// is called when the hierarchical method has added or undone a level of collapses. Returns whether to continue.
  bool level(int vertices, int all_vertices);
};
