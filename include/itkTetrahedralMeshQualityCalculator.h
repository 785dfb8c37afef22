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
#ifndef itkTetrahedralMeshQualityCalculator_h
#define itkTetrahedralMeshQualityCalculator_h

#include "itkMultiMaterialMeshCompatibility.h"
#include "itkTetrahedronStages.h"

#include "itkNumericTraits.h"
#include "itkObject.h"
#include "itkObjectFactory.h"

namespace itk
{
/** \class TetrahedralMeshQualityCalculator
 * \brief Measures the shapes, interfaces and topology of a labelled tetrahedral mesh.
 *
 * The mesh's cells are tetrahedra and their data is the label, a whole number. A mesh without cell data is one with
 * the label 0 everywhere. Set the mesh, call Compute() and get the report: radius ratios and dihedral angles of the
 * whole mesh and of each label, the triangles between labels, defects such as negative tetrahedra or open boundaries,
 * and a list of the worst tetrahedra. Lengths and volumes are in the mesh's unit, angles in degrees.
 *
 * The radius ratio of a tetrahedron is three times the radius of its inscribed sphere over that of its circumscribed
 * one, 1 for a regular tetrahedron and 0 for a flat one; for triangles it is twice the ratio of the circles' radii.
 *
 * Compute() throws an ExceptionObject that names the cell if a cell is not a tetrahedron, lacks a label or has a point
 * that the mesh lacks.
 *
 * \tparam TMesh an itk::Mesh of three-dimensional points and scalar cell data.
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TMesh>
class ITK_TEMPLATE_EXPORT TetrahedralMeshQualityCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TetrahedralMeshQualityCalculator);

  using Self = TetrahedralMeshQualityCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using MeshType = TMesh;
  using MeshConstPointer = typename MeshType::ConstPointer;
  using ReportType = mmm::MeshQualityReport;

  static_assert(MeshType::PointDimension == 3, "Tetrahedra need points of three dimensions.");

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(TetrahedralMeshQualityCalculator);

  /** The mesh to measure. */
  itkSetConstObjectMacro(Mesh, MeshType);
  itkGetConstObjectMacro(Mesh, MeshType);

  /** Tetrahedra with a dihedral angle below it are listed one by one. In degrees, within [0, 180]; default 10. */
  itkSetClampMacro(SmallestAngle, double, 0.0, 180.0);
  itkGetConstMacro(SmallestAngle, double);

  /** Tetrahedra with a dihedral angle above it are listed one by one. In degrees, within [0, 180]; default 165. */
  itkSetClampMacro(LargestAngle, double, 0.0, 180.0);
  itkGetConstMacro(LargestAngle, double);

  /** The number of tetrahedra to list at most, the worst ones. Default 1000. */
  itkSetMacro(MaximumListed, SizeValueType);
  itkGetConstMacro(MaximumListed, SizeValueType);

  /** Points are duplicates if their coordinates, rounded to multiples of it, are the same. In the mesh's unit, at least
   * 0, where they must be equal; default 1e-9. */
  itkSetClampMacro(DuplicateTolerance, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(DuplicateTolerance, double);

  /** Whether to compute each label's components, tunnels and cavities as Betti numbers. It adds about a third to the
   * time. Default off. */
  itkSetMacro(ComputeBettiNumbers, bool);
  itkGetConstMacro(ComputeBettiNumbers, bool);
  itkBooleanMacro(ComputeBettiNumbers);

  /** Measures the mesh as it is now. */
  void
  Compute();

  /** What the last Compute() found; throws an ExceptionObject before the first one. The tetrahedra listed have the cell
   * identifier as their index. */
  const ReportType &
  GetReport() const;

  /** The most telling numbers of the report. */
  SizeValueType
  GetNumberOfTetrahedra() const
  {
    return this->GetReport().tetrahedra.count;
  }
  double
  GetAverageRadiusRatio() const
  {
    return this->GetReport().tetrahedra.radiusRatio.average;
  }
  double
  GetMinimumRadiusRatio() const
  {
    return this->GetReport().tetrahedra.radiusRatio.minimum;
  }
  double
  GetMinimumDihedralAngle() const
  {
    return this->GetReport().tetrahedra.smallestAngle.minimum;
  }
  double
  GetMaximumDihedralAngle() const
  {
    return this->GetReport().tetrahedra.largestAngle;
  }

protected:
  TetrahedralMeshQualityCalculator() = default;
  ~TetrahedralMeshQualityCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  MeshConstPointer m_Mesh;
  double           m_SmallestAngle{ 10.0 };
  double           m_LargestAngle{ 165.0 };
  SizeValueType    m_MaximumListed{ 1000 };
  double           m_DuplicateTolerance{ 1e-9 };
  bool             m_ComputeBettiNumbers{ false };
  bool             m_Computed{ false };
  ReportType       m_Report;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkTetrahedralMeshQualityCalculator.hxx"
#endif

#endif
