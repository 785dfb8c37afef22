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
#ifndef itkSurfaceStages_h
#define itkSurfaceStages_h

#include "MultiMaterialMeshingExport.h"
#include "itkLabelImageStages.h"

#include "itkPoint.h"

#include <array>
#include <vector>

/** The compiled part of what takes surfaces. */
namespace mmm
{
/** A surface in physical space: triangles of numbers of points. */
struct SurfaceTriangles
{
  std::vector<itk::Point<double, 3>>              points;
  std::vector<std::array<itk::IdentifierType, 3>> triangles;
};

/** What TriangleSurfaceToDistanceImageFilter tells of a surface. */
struct SurfaceFacts
{
  itk::SizeValueType boundaryEdges{ 0 };
  itk::SizeValueType turnedTriangles{ 0 };
  bool               hasOverlaps{ false };
  /** How far it goes beyond the image's box, in mm. */
  double overshoot{ 0.0 };
  /** Voxels whose centres are inside. */
  itk::SizeValueType voxelsInside{ 0 };
};

/** What TriangleSurfaceToDistanceImageFilter makes, on the grid of `reference`. `bandWidth` is in mm, or not a number
 * where the smallest voxel spacing decides. */
MultiMaterialMeshing_EXPORT FloatImage::Pointer
                            ComputeSurfaceDistance(itk::ProcessObject *      filter,
                                                   const SurfaceTriangles &  surface,
                                                   const itk::ImageBase<3> * reference,
                                                   double                    bandWidth,
                                                   SurfaceFacts &            facts);

/** Surfaces on top of a label image, each over those before it: signed distances in mm, positive inside, on the image's
 * grid or a part of it beyond which they are far, and the label that each encloses. */
struct SurfaceInputs
{
  std::vector<FloatImage::ConstPointer> distances;
  std::vector<int>                      labels;
  /** The labels below that each may replace; those without an entry, or with an empty one, replace all. */
  std::vector<std::vector<int>> replaced;

  std::vector<int>
  GetReplaced(std::size_t k) const
  {
    return k < replaced.size() ? replaced[k] : std::vector<int>();
  }
};

/** The label image in which a voxel whose centre is within surfaces has the label of the last of them. Throws
 * itk::ExceptionObject if a surface has no voxel. */
MultiMaterialMeshing_EXPORT LabelImage::Pointer
                            ComposeLabels(const LabelImage * labels, const SurfaceInputs & surfaces);

/** What is wrong with surfaces for an image, in a sentence; empty if nothing is. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const SurfaceInputs & surfaces);
MultiMaterialMeshing_EXPORT std::string
                            DescribeGeometryError(const itk::ImageBase<3> * labels, const SurfaceInputs & surfaces);
} // namespace mmm

#endif
