/*=========================================================================
 *
 *  Copyright NumFOCUS
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkOptimizeTetrahedralMeshFilter_h
#define itkOptimizeTetrahedralMeshFilter_h

#include "itkMeshToMeshFilter.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkMultiMaterialMeshCompatibility.h"
#include "itkTetrahedronStages.h"

#include <limits>

namespace itk
{
/** \class OptimizeTetrahedralMeshFilter
 * \brief Improves the worst tetrahedra of a labelled mesh, whatever it comes from.
 *
 * The mesh's cells are tetrahedra and their data is the label, a whole number; a mesh without cell data is one with the
 * label 0 everywhere. Cells of lower dimension, such as the triangles of a Gmsh file, are left out. The output has
 * tetrahedra of positive orientation, their labels, and the points that they use; point data is not kept.
 *
 * Points are moved, edges and faces flipped, edges collapsed, and flat tetrahedra on an interface given to the other
 * side, so that the extreme dihedral angles get better, the worst first. The interfaces, the mesh's outside among them,
 * are taken as they are: their points slide on them, and they change their triangles, only as far as they stay within
 * Tolerance. Edges sharper than FeatureAngle and curves where several labels meet stay; points slide along them where
 * they are straight. Corners do not move. What lies on the outside knows nothing of what lies beyond: where parts of
 * the outside are closer to each other than twice the tolerance, they might touch.
 *
 * Meshes of image labels have better interfaces to slide on while the image is known: see
 * LabelImageToTetrahedralMeshFilter, whose output needs no further optimization.
 *
 * The result is the same for any number of threads.
 *
 * Update() throws an ExceptionObject that names the cell if a cell is of another kind, lacks a label or has a point
 * that the mesh lacks, and if there is no tetrahedron or a parameter is out of its range.
 *
 * \tparam TMesh an itk::Mesh of three-dimensional points and scalar cell data
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TMesh = LabelTetrahedralMesh>
class ITK_TEMPLATE_EXPORT OptimizeTetrahedralMeshFilter : public MeshToMeshFilter<TMesh, TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OptimizeTetrahedralMeshFilter);

  using Self = OptimizeTetrahedralMeshFilter;
  using Superclass = MeshToMeshFilter<TMesh, TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using MeshType = TMesh;

  /** The value of a tolerance that is to follow the mesh. It is not a number: test with std::isnan(). */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(OptimizeTetrahedralMeshFilter);

  itkConceptMacro(PointDimensionCheck, (Concept::SameDimension<TMesh::PointDimension, 3>));

  /** How far an interface may leave its place, in the mesh's unit, positive. Default: Automatic, 0.07 of
   * the length of the edges there. */
  itkSetMacro(Tolerance, double);
  itkGetConstMacro(Tolerance, double);

  /** Edges of interfaces at which the normals differ by more than this are kept. In degrees, within [0, 180]; default
   * 40. */
  itkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  itkGetConstMacro(FeatureAngle, double);

  /** The number of rounds at most; fewer if nothing is changed any more. Default: 10. */
  itkSetClampMacro(MaximumNumberOfRounds, int, 0, NumericTraits<int>::max());
  itkGetConstMacro(MaximumNumberOfRounds, int);

  /** What follows is known after Update(). */

  /** The largest tolerance that was used. */
  double
  GetLargestTolerance() const
  {
    return m_Results.largestTolerance;
  }
  /** What was done. */
  const mmm::OptimizationReport &
  GetReport() const
  {
    return m_Results.report;
  }
  /** Cells of lower dimension, which were left out. */
  itkGetConstMacro(NumberOfCellsLeftOut, SizeValueType);

protected:
  OptimizeTetrahedralMeshFilter() = default;
  ~OptimizeTetrahedralMeshFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  GenerateData() override;

private:
  double        m_Tolerance{ Automatic };
  double        m_FeatureAngle{ 40.0 };
  int           m_MaximumNumberOfRounds{ 10 };
  SizeValueType m_NumberOfCellsLeftOut{ 0 };

  mmm::ImprovementResults m_Results;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkOptimizeTetrahedralMeshFilter.hxx"
#endif

#endif
