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
#ifndef itkMeshingFilter_h
#define itkMeshingFilter_h

#include "itkIndicatorImageStages.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace itk
{
/** \class MeshingFilter
 * \brief What filters have in common that make conforming meshes of several materials: their settings and outputs.
 *
 * \tparam TSuperclass an ImageToMeshFilter
 *
 * \sa LabelImageToTetrahedralMeshFilter, IndicatorImagesToMeshFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TSuperclass>
class ITK_TEMPLATE_EXPORT MeshingFilter : public TSuperclass
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeshingFilter);

  using Self = MeshingFilter;
  using Superclass = TSuperclass;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using SurfaceMeshType = LabelInterfaceMesh;
  using ParticleMeshType = LabelParticleMesh;
  using JunctionMeshType = LabelJunctionMesh;
  using MidNodeMeshType = LabelMidNodeMesh;
  using LabelType = int;
  using LabelsType = std::vector<LabelType>;
  using StageRecordsType = std::vector<mmm::StageRecord>;

  itkOverrideGetNameOfClassMacro(MeshingFilter);

  /** The particles' order of insertion. Another seed gives another mesh of the same kind. Default: 1. */
  itkSetMacro(Seed, std::uint64_t);
  itkGetConstMacro(Seed, std::uint64_t);

  /** Leave out the interior: GetOutput() remains empty, and the surface, whose triangles are a little poorer, takes
   * about half the time. Default: false. */
  itkSetMacro(SurfaceOnly, bool);
  itkGetConstMacro(SurfaceOnly, bool);
  itkBooleanMacro(SurfaceOnly);

  /** How many tetrahedra the mesh is to have, within 5 %; 0, the default, leaves it to the sizes. Where more are
   * wanted, all edge lengths are shortened alike. Where fewer are wanted, the shortest edges, by what is asked for
   * there, are pulled together, as long as the labels' connections, their interfaces and the shape of tetrahedra allow
   * it; if they do not, there are more, which is a warning. Not with SurfaceOnly. */
  itkSetMacro(NumberOfTetrahedra, SizeValueType);
  itkGetConstMacro(NumberOfTetrahedra, SizeValueType);
  /** The order of the elements, 1 or 2. ITK has no cell of ten nodes, so that the meshes have the corners of
   * second-order elements only, which are on the interfaces; GetMidNodes() has the curved edges between them,
   * LabelMeshFileWriter makes second-order elements of both, and GetReport().curving tells volumes and what had to stay
   * straight. The flat triangles alone lie inside of convex labels, other than those of order 1. Default: 1. */
  itkSetMacro(ElementOrder, unsigned int);
  itkGetConstMacro(ElementOrder, unsigned int);

  /** Compare the components, tunnels and cavities of each label in the mesh with those of the largest indicator's
   * region, see MeshingReport::topology. Default: false. */
  itkSetMacro(CompareTopology, bool);
  itkGetConstMacro(CompareTopology, bool);
  itkBooleanMacro(CompareTopology);

  /** Refuse meshes that are expected to have more tetrahedra, or to need more memory, in GB (2^30 bytes), positive,
   * before the long stages begin: Update() throws an ExceptionObject that says which smallest size would do. See
   * MeshingReport::estimate. Defaults: no limit. */
  itkSetMacro(MaximumNumberOfTetrahedra, SizeValueType);
  itkGetConstMacro(MaximumNumberOfTetrahedra, SizeValueType);
  itkSetMacro(MaximumMemory, double);
  itkGetConstMacro(MaximumMemory, double);

  /** The triangles between the labels; the cell data is the two labels, the lower one first. */
  SurfaceMeshType *
  GetSurface();
  /** The points of the surface, with the labels that meet there. */
  ParticleMeshType *
  GetParticles();
  /** The curves and points of the surface where three and more labels meet. */
  JunctionMeshType *
  GetJunctions();
  /** The mid-nodes of curved edges; there are none if ElementOrder is 1. */
  MidNodeMeshType *
  GetMidNodes();

  /** What was expected, counts of the particles and how their relaxation went, known after Update(); after an
   * exception, as far as the work had come. The estimate is there for observers of ProgressEvent as soon as the stage
   * "preparation" has ended. */
  const mmm::MeshingReport &
  GetReport() const
  {
    return m_State.report;
  }

  /** The stages that ended, in their order. */
  const StageRecordsType &
  GetStageRecords() const
  {
    return m_State.log.records;
  }

  /** The stage that is running or ran last, for instance "surface", and how much of it is done, in [0, 1]; for
   * observers of ProgressEvent. */
  const std::string &
  GetCurrentStage() const
  {
    return m_State.log.current;
  }
  float
  GetStageProgress() const
  {
    return m_State.log.progress;
  }

  /** Output 0 is GetOutput(), 1 is GetSurface(), 2 is GetParticles(), 3 is GetJunctions(), 4 is GetMidNodes(). */
  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;
  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  MeshingFilter();
  ~MeshingFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  GenerateInputRequestedRegion() override;

  void
  GenerateOutputRequestedRegion(DataObject * output) override;

  mmm::MeshingOptions
  GetMeshingOptions() const;

  mmm::MeshingOutputs
  GetMeshingOutputs();

  /** Gives out the warnings of the report. */
  void
  Warn() const;

  mmm::MeshingState m_State;

private:
  std::uint64_t m_Seed{ 1 };
  bool          m_SurfaceOnly{ false };
  SizeValueType m_NumberOfTetrahedra{ 0 };
  unsigned int  m_ElementOrder{ 1 };
  bool          m_CompareTopology{ false };
  SizeValueType m_MaximumNumberOfTetrahedra{ NumericTraits<SizeValueType>::max() };
  double        m_MaximumMemory{ std::numeric_limits<double>::infinity() };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMeshingFilter.hxx"
#endif

#endif
