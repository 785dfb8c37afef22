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
#ifndef mmmTenNodeTetrahedronCell_h
#define mmmTenNodeTetrahedronCell_h

#include "itkTetrahedronCell.h"

#include <algorithm>

namespace mmm
{
/** \brief A tetrahedron of ten nodes, which ITK does not have: for itk::MeshFileWriter to hand over to a mesh IO.
 *
 * To ITK it is a tetrahedron, by its first four nodes, but for the number of its points. */
template <typename TCellInterface>
class TenNodeTetrahedronCell : public itk::TetrahedronCell<TCellInterface>
{
public:
  using Self = TenNodeTetrahedronCell;
  using Superclass = itk::TetrahedronCell<TCellInterface>;
  using typename Superclass::CellAutoPointer;
  using typename Superclass::PointIdConstIterator;
  using typename Superclass::PointIdentifier;
  using typename Superclass::PointIdIterator;

  static constexpr unsigned int NumberOfNodes = 10;

  void
  MakeCopy(CellAutoPointer & cell) const override
  {
    cell.TakeOwnership(new Self);
    cell->SetPointIds(this->PointIdsBegin());
  }
  unsigned int
  GetNumberOfPoints() const override
  {
    return NumberOfNodes;
  }
  void
  SetPointIds(PointIdConstIterator first) override
  {
    std::copy_n(first, NumberOfNodes, m_Nodes);
  }
  void
  SetPointIds(PointIdConstIterator first, PointIdConstIterator last) override
  {
    std::copy(first, last, m_Nodes);
  }
  void
  SetPointId(int localId, PointIdentifier node) override
  {
    m_Nodes[localId] = node;
  }
  PointIdIterator
  PointIdsBegin() override
  {
    return m_Nodes;
  }
  PointIdConstIterator
  PointIdsBegin() const override
  {
    return m_Nodes;
  }
  PointIdIterator
  PointIdsEnd() override
  {
    return m_Nodes + NumberOfNodes;
  }
  PointIdConstIterator
  PointIdsEnd() const override
  {
    return m_Nodes + NumberOfNodes;
  }

private:
  PointIdentifier m_Nodes[NumberOfNodes]{};
};
} // namespace mmm

#endif
