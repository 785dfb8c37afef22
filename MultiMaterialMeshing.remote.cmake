#-- # Grading Level Criteria Report
#-- EVALUATION DATE: 2026-11-22
#-- EVALUATORS: [the module's developers]
#--
#-- ## Compliance level 2, on the way to 3
#-- - [x] Clear documentation of the API and of the method, with the source that it implements
#-- - [x] Builds and passes its tests on Linux, against ITK 5.2.1 (installed) and 5.4.7 (build tree, source tree)
#-- - [x] Tests run without data from elsewhere
#-- - [ ] Windows and macOS: not tried
#-- - [ ] Test coverage: not measured
#-- - [ ] API: not declared stable yet
#--
#-- TetGen, which the module needs, is not part of ITK and under the GNU AGPL 3.
itk_fetch_module(
  MultiMaterialMeshing
  "Conforming surface and tetrahedral meshes of multi-material label images, for bioelectric field simulation."
  MODULE_COMPLIANCE_LEVEL 2
  GIT_REPOSITORY ${git_protocol}://github.com/InsightSoftwareConsortium/ITKMultiMaterialMeshing.git
  GIT_TAG main
)
