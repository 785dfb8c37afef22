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
#ifndef itkMeshingFilter_hxx
#define itkMeshingFilter_hxx

namespace itk
{
template <typename TSuperclass>
MeshingFilter<TSuperclass>::MeshingFilter()
{
  this->SetNumberOfRequiredOutputs(5);
  for (DataObjectPointerArraySizeType n = 0; n < 5; ++n)
  {
    this->SetNthOutput(n, Self::MakeOutput(n));
  }
}

template <typename TSuperclass>
DataObject::Pointer
MeshingFilter<TSuperclass>::MakeOutput(DataObjectPointerArraySizeType index)
{
  switch (index)
  {
    case 1:
      return SurfaceMeshType::New().GetPointer();
    case 2:
      return ParticleMeshType::New().GetPointer();
    case 3:
      return JunctionMeshType::New().GetPointer();
    case 4:
      return MidNodeMeshType::New().GetPointer();
    default:
      return Superclass::MakeOutput(index);
  }
}

template <typename TSuperclass>
auto
MeshingFilter<TSuperclass>::GetSurface() -> SurfaceMeshType *
{
  return dynamic_cast<SurfaceMeshType *>(this->ProcessObject::GetOutput(1));
}

template <typename TSuperclass>
auto
MeshingFilter<TSuperclass>::GetParticles() -> ParticleMeshType *
{
  return dynamic_cast<ParticleMeshType *>(this->ProcessObject::GetOutput(2));
}

template <typename TSuperclass>
auto
MeshingFilter<TSuperclass>::GetJunctions() -> JunctionMeshType *
{
  return dynamic_cast<JunctionMeshType *>(this->ProcessObject::GetOutput(3));
}

template <typename TSuperclass>
auto
MeshingFilter<TSuperclass>::GetMidNodes() -> MidNodeMeshType *
{
  return dynamic_cast<MidNodeMeshType *>(this->ProcessObject::GetOutput(4));
}

template <typename TSuperclass>
void
MeshingFilter<TSuperclass>::GenerateInputRequestedRegion()
{
  for (const auto & name : this->GetInputNames())
  {
    if (auto * input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TSuperclass>
void
MeshingFilter<TSuperclass>::GenerateOutputRequestedRegion(DataObject *)
{
  for (DataObjectPointerArraySizeType n = 0; n < this->GetNumberOfIndexedOutputs(); ++n)
  {
    this->ProcessObject::GetOutput(n)->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TSuperclass>
mmm::MeshingOptions
MeshingFilter<TSuperclass>::GetMeshingOptions() const
{
  mmm::MeshingOptions options;
  options.seed = m_Seed;
  options.surfaceOnly = m_SurfaceOnly;
  options.numberOfTetrahedra = m_NumberOfTetrahedra;
  options.elementOrder = m_ElementOrder;
  options.compareTopology = m_CompareTopology;
  options.maximumNumberOfTetrahedra = m_MaximumNumberOfTetrahedra;
  options.maximumMemory = m_MaximumMemory;
  return options;
}

template <typename TSuperclass>
mmm::MeshingOutputs
MeshingFilter<TSuperclass>::GetMeshingOutputs()
{
  auto * const tetrahedra = this->GetOutput();
  tetrahedra->SetBufferedRegion(tetrahedra->GetRequestedRegion());
  return { this->GetSurface(),
           this->GetParticles(),
           this->GetJunctions(),
           this->GetMidNodes(),
           [tetrahedra](const TetrahedronArrays & arrays) { FillMesh(arrays, tetrahedra); } };
}

template <typename TSuperclass>
void
MeshingFilter<TSuperclass>::Warn() const
{
  for (const auto & warning : m_State.report.warnings)
  {
    itkWarningMacro(<< warning);
  }
}

template <typename TSuperclass>
void
MeshingFilter<TSuperclass>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "SurfaceOnly: " << (m_SurfaceOnly ? "On" : "Off") << std::endl;
  os << indent << "NumberOfTetrahedra: " << m_NumberOfTetrahedra << std::endl;
  os << indent << "ElementOrder: " << m_ElementOrder << std::endl;
  os << indent << "CompareTopology: " << (m_CompareTopology ? "On" : "Off") << std::endl;
  os << indent << "MaximumNumberOfTetrahedra: " << m_MaximumNumberOfTetrahedra << std::endl;
  os << indent << "MaximumMemory: " << m_MaximumMemory << std::endl;
  os << indent << "Particles on cells of dimension 0 to 3:";
  for (const auto count : m_State.report.particles)
  {
    os << ' ' << count;
  }
  os << std::endl;
  os << indent << "CurrentStage: " << m_State.log.current << " (" << m_State.log.progress << ')' << std::endl;
}
} // namespace itk

#endif
