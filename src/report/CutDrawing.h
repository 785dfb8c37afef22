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
#ifndef mmmCutDrawing_h
#define mmmCutDrawing_h

#include "itkMeshPage.h"
#include "report/CutFrame.h"

namespace mmm
{
/** A mesh that is cut: the tetrahedra, or where there are none the surface. */
struct CutSubject
{
  const itk::MeshFacts *       facts;
  const itk::MeshPageDetails * details;
  /** In continuous indices of the image. */
  std::vector<Vector> points;
  /** Those that are drawn. */
  std::set<int> labels;

  bool
  HasTetrahedra() const
  {
    return facts->quality != nullptr;
  }
};

/** A figure of a cut: the voxels, and over them what the plane cuts of the mesh, by label, and the edges.
 *
 * There are as many edges as keep a page of three cuts small enough to be sent by mail; of more, the shortest ones are
 * left out, which the figure says. */
std::string
DrawCut(const CutFrame & frame, const CutSubject & subject);
} // namespace mmm

#endif
