set(
  DOCUMENTATION
  "Conforming surface and tetrahedral meshes of multi-material label images, such as segmented MRI heads, for
bioelectric field simulation. Labels become smooth indicator functions and a sizing field. Particles sample the
interfaces, a labelled Delaunay tetrahedralization of them is the surface, and TetGen and an optimizer fill it.
Method: \"Multimaterial Meshing of MRI Head Data for Bioelectric Field Simulations\"."
)

itk_module(
  MultiMaterialMeshing
  DEPENDS
    ITKCommon
    ITKMesh
    ITKImageFilterBase
    ITKConnectedComponents
    ITKIOMeshBase
    ITKIOImageBase
    ITKEigen3
    ITKZLIB
    ITKKWSys
    ITKExpat
  PRIVATE_DEPENDS
    ITKIOPNG
    ITKIONRRD
    ITKIONIFTI
    ITKIOMeta
    ITKImageGrid
  TEST_DEPENDS
    ITKGoogleTest
  FACTORY_NAMES
    MeshIO::Gmsh
    MeshIO::Medit
    MeshIO::VTU
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DESCRIPTION "${DOCUMENTATION}"
)
