/*!
\ingroup PkgTextureAtlasConcepts
\cgalConcept

A visitor follows `make_atlas()`, and may cancel it. It is the named parameter `visitor`, or `Atlas_options::visitor`. A
model derives from `CGAL::Texture_atlas::Atlas_visitor`, whose functions do nothing, and overrides what it needs.

One thread at a time calls the functions, but not always the caller of `make_atlas()`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Texture_atlas::Atlas_visitor}
\cgalHasModelsEnd
*/
class AtlasVisitor
{
public:
  /// is called when a stage begins. Returns whether to continue.
  bool start(CGAL::Texture_atlas::Atlas_visitor::Stage stage);

  /// is called repeatedly while charts are made, with the estimated share of work done, from 0 to 1, which never
  /// decreases. Returns whether to continue.
  bool progress(double share);
};
