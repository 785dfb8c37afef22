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
#include "distance/SurfaceDistance.h"
#include "itk/FilterMonitor.h"
#include "itk/GridGeometry.h"
#include "itkSurfaceStages.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
/** How far winding numbers may be from whole ones, on average. Those of a hemisphere are further. */
constexpr double MostDoubt = 0.1;

struct Bounds
{
  Vector lower{ Vector::Constant(std::numeric_limits<double>::infinity()) };
  Vector upper{ Vector::Constant(-std::numeric_limits<double>::infinity()) };
};

/** Throws if it has no triangles, or corners that are nowhere. */
TriangleSurface
InGrid(const SurfaceTriangles & surface, const GridGeometry & geometry)
{
  if (surface.triangles.empty())
  {
    itkGenericExceptionMacro("The surface has no triangles.");
  }
  if (surface.points.size() >= TriangleTree::None || surface.triangles.size() >= TriangleTree::None)
  {
    itkGenericExceptionMacro("The surface has " << surface.triangles.size() << " triangles, which is too many.");
  }
  TriangleSurface result;
  for (const auto & triangle : surface.triangles)
  {
    for (const auto corner : triangle)
    {
      if (corner >= surface.points.size())
      {
        itkGenericExceptionMacro("A triangle has the point " << corner << ", but the surface has "
                                                             << surface.points.size() << " points only.");
      }
      const auto & point = surface.points[corner];
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
      {
        itkGenericExceptionMacro("Point " << corner << " of the surface is at " << point
                                          << ". Coordinates must be finite numbers.");
      }
    }
    result.triangles.push_back(
      { { std::uint32_t(triangle[0]), std::uint32_t(triangle[1]), std::uint32_t(triangle[2]) } });
  }
  for (const auto & point : surface.points)
  {
    result.points.push_back(geometry.ToGridPoint(point));
  }
  return result;
}

Bounds
BoundsOf(const TriangleSurface & surface)
{
  Bounds bounds;
  for (const auto & triangle : surface.triangles)
  {
    for (const auto corner : triangle)
    {
      bounds.lower = bounds.lower.cwiseMin(surface.points[corner]);
      bounds.upper = bounds.upper.cwiseMax(surface.points[corner]);
    }
  }
  return bounds;
}

/** How far the bounds go beyond the grid's box. Throws if they are beyond it altogether. */
double
OvershootOf(const Bounds & bounds, const GridGeometry & geometry)
{
  const Grid & grid = geometry.GetGrid();
  double       overshoot = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    if (bounds.upper[a] < grid.LowerFace(a) || bounds.lower[a] > grid.UpperFace(a))
    {
      itkGenericExceptionMacro("The surface, with its middle at "
                               << geometry.ToPhysicalPoint(0.5 * (bounds.lower + bounds.upper))
                               << " mm, lies outside the image. Points are taken as they are, in LPS; are those of the "
                                  "surface in RAS, or in another space?");
    }
    overshoot = std::max({ overshoot, grid.LowerFace(a) - bounds.lower[a], bounds.upper[a] - grid.UpperFace(a) });
  }
  return overshoot * geometry.GetUnit();
}

void
VerifyEnclosure(double doubt, const SurfaceDefects & defects, const GridGeometry & geometry)
{
  if (doubt <= MostDoubt)
  {
    return;
  }
  if (defects.boundaryEdges == 0)
  {
    itkGenericExceptionMacro("The surface has no inside: winding numbers near it are off whole numbers by "
                             << doubt << " on average. Its triangles contradict each other in where outside is.");
  }
  itkGenericExceptionMacro("The surface is open and encloses nothing for sure: "
                           << defects.boundaryEdges << " edges have one triangle only, for instance at "
                           << geometry.ToPhysicalPoint(defects.boundaryPlace)
                           << " mm, and winding numbers near it are off whole numbers by " << doubt
                           << " on average, where 0.1 is the limit. Close it first.");
}
} // namespace

FloatImage::Pointer
ComputeSurfaceDistance(itk::ProcessObject *      filter,
                       const SurfaceTriangles &  triangles,
                       const itk::ImageBase<3> * reference,
                       double                    bandWidth,
                       SurfaceFacts &            facts)
{
  const GridGeometry geometry(reference, reference->GetLargestPossibleRegion());
  const double       band = (std::isnan(bandWidth) ? IndicatorBandWidthOf(reference) : bandWidth) / geometry.GetUnit();

  facts = SurfaceFacts();
  auto surface = InGrid(triangles, geometry);
  facts.overshoot = OvershootOf(BoundsOf(surface), geometry);
  const auto defects = RepairSurface(surface);
  facts.boundaryEdges = defects.boundaryEdges;
  facts.turnedTriangles = defects.turnedTriangles;

  const auto image = FloatImage::New();
  image->CopyInformation(reference);
  image->SetRegions(reference->GetLargestPossibleRegion());
  image->Allocate();
  RunStage(filter, "surface distance", [&](FilterMonitor & monitor) {
    SurfaceDistance distance(surface, defects);
    const auto      values = distance.Compute(geometry.GetGrid(), band, monitor);
    VerifyEnclosure(distance.GetDoubt(), defects, geometry);
    facts.hasOverlaps = distance.HasOverlaps();
    facts.voxelsInside = std::count_if(values.begin(), values.end(), [](float value) { return value > 0.0f; });
    std::transform(values.begin(), values.end(), image->GetBufferPointer(), [&](float value) {
      return static_cast<float>(value * geometry.GetUnit());
    });
  });
  return image;
}
} // namespace mmm
