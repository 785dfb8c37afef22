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
#include "run/Surfaces.h"

#include "console/Errors.h"
#include "console/StreamCapture.h"
#include "console/Warnings.h"
#include "itkSurfaceFileReader.h"
#include "itkTriangleSurfaceToDistanceImageFilter.h"

// registers the formats of meshes that ITK was built with
#include "itkMeshFileReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

namespace cli
{
namespace
{
using Mesh = itk::LabelInterfaceMesh;
using DistanceFilter = itk::TriangleSurfaceToDistanceImageFilter<Mesh, ScalarImage>;

/** In mm, LPS. */
struct Box
{
  std::array<double, 3> lower;
  std::array<double, 3> upper;

  double
  Length(int axis) const
  {
    return upper[axis] - lower[axis];
  }
};

Mesh::Pointer
ReadSurface(const std::string & fileName, bool isInRAS)
{
  const auto reader = itk::SurfaceFileReader::New();
  reader->SetFileName(fileName);
  reader->SetFilesAreInRAS(isInRAS);
  StreamCapture     capture;
  const auto        mesh = reader->Read();
  const std::string complaint = capture.Finish();
  if (!complaint.empty())
  {
    Warn(fileName + ": " + ToOneLine(complaint));
  }
  return mesh;
}

/** Around the points of triangles. */
Box
BoxOf(const Mesh & mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box              box{ { { infinity, infinity, infinity } }, { { -infinity, -infinity, -infinity } } };
  for (auto cell = mesh.GetCells()->Begin(); cell != mesh.GetCells()->End(); ++cell)
  {
    for (auto id = cell.Value()->PointIdsBegin(); id != cell.Value()->PointIdsEnd(); ++id)
    {
      const auto point = mesh.GetPoint(*id);
      for (int axis = 0; axis < 3; ++axis)
      {
        box.lower[axis] = std::min(box.lower[axis], point[axis]);
        box.upper[axis] = std::max(box.upper[axis], point[axis]);
      }
    }
  }
  return box;
}

/** Two digits are enough to tell the user. */
double
RoundedDown(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  return std::floor(length / unit + 1e-9) * unit;
}

/** Voxels that resolve the smallest surface and the whole, but are not many more than memory holds. */
double
SpacingFor(const std::vector<Box> & boxes, const Box & whole)
{
  constexpr double voxelsOfWhole = 100.0;
  constexpr double voxelsOfSmallest = 20.0;
  constexpr double most = 400.0;

  double longest = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, whole.Length(axis));
    for (const Box & box : boxes)
    {
      shortest = std::min(shortest, box.Length(axis));
    }
  }
  return RoundedDown(std::max(std::min(longest / voxelsOfWhole, shortest / voxelsOfSmallest), longest / most));
}

/** A grid around the surfaces in which all is exterior, with a margin for the band of the distances. */
LabelImage::Pointer
MakeGrid(const Settings & settings, const std::vector<Mesh::Pointer> & meshes)
{
  constexpr double margin = 5.0; // voxels
  constexpr double mostVoxels = 2e9;

  std::vector<Box> boxes;
  for (const auto & mesh : meshes)
  {
    boxes.push_back(BoxOf(*mesh));
  }
  Box whole = boxes.front();
  for (const Box & box : boxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      whole.lower[axis] = std::min(whole.lower[axis], box.lower[axis]);
      whole.upper[axis] = std::max(whole.upper[axis], box.upper[axis]);
    }
  }
  const double spacing = settings.surfaceSpacing.value_or(SpacingFor(boxes, whole));
  if (!(spacing > 0.0) || !std::isfinite(spacing))
  {
    throw Error(settings.surfaceLabels.front().file +
                ": the surfaces have no extent; --surface-spacing sets the voxels");
  }

  const auto             image = LabelImage::New();
  LabelImage::RegionType region;
  LabelImage::PointType  origin;
  double                 voxels = 1.0;
  std::ostringstream     text;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = std::ceil(whole.Length(axis) / spacing + 2.0 * margin);
    voxels *= length;
    text << (axis == 0 ? "" : "x") << length;
    // the voxels' centres lie evenly around the middle of the surfaces
    origin[axis] = 0.5 * (whole.lower[axis] + whole.upper[axis] - (length - 1.0) * spacing);
    region.SetSize(axis, static_cast<itk::SizeValueType>(std::min(length, mostVoxels)));
  }
  if (voxels > mostVoxels)
  {
    throw Error("with --surface-spacing " + std::to_string(spacing) + ", the grid would have " + text.str() +
                " voxels; choose larger ones");
  }
  const int label = settings.exterior.empty() ? 0 : settings.exterior.front();
  image->SetRegions(region);
  image->SetOrigin(origin);
  image->SetSpacing(itk::Vector<double, 3>(spacing).GetDataPointer());
  image->Allocate();
  image->FillBuffer(label);
  if (!settings.surfaceSpacing)
  {
    std::cerr << "multimaterial-mesh: the surfaces are meshed on a grid of " << text.str() << " voxels of " << spacing
              << " mm; --surface-spacing chooses another" << std::endl;
  }
  return image;
}

void
WarnOfDefects(const std::string & file, const DistanceFilter & filter)
{
  std::ostringstream text;
  if (filter.GetNumberOfBoundaryEdges() > 0)
  {
    text << "; it is open at " << filter.GetNumberOfBoundaryEdges() << " edges, and is closed between them";
  }
  if (filter.GetHasOverlaps())
  {
    text << "; it overlaps itself, and what its parts enclose is taken together";
  }
  if (filter.GetNumberOfTurnedTriangles() > 0)
  {
    text << "; " << filter.GetNumberOfTurnedTriangles() << " of its triangles were turned as their neighbours are";
  }
  if (filter.GetOvershoot() > 0.0)
  {
    text << "; it goes beyond the image by " << filter.GetOvershoot() << " mm, and is cut there";
  }
  if (!text.str().empty())
  {
    Warn(file + ": the surface is not as it should be" + text.str());
  }
}

ScalarImage::Pointer
ComputeDistance(const std::string & file, const Mesh * mesh, const LabelImage * grid)
{
  const auto filter = DistanceFilter::New();
  filter->SetInput(mesh);
  filter->SetReferenceImage(grid);
  try
  {
    filter->Update();
  }
  catch (const itk::MemoryAllocationError &)
  {
    throw;
  }
  catch (const itk::ExceptionObject &)
  {
    throw Error(file + ": " + DescribeCurrentException());
  }
  if (filter->GetNumberOfVoxelsInside() == 0)
  {
    throw Error(file + ": no voxel's centre is within the surface, which is thinner than the voxels; choose smaller "
                       "ones, by --surface-spacing or an image that is resampled");
  }
  WarnOfDefects(file, *filter);
  const ScalarImage::Pointer distance = filter->GetOutput();
  distance->DisconnectPipeline();
  return distance;
}
} // namespace

void
AddSurfaces(const Settings & settings, Input & input)
{
  std::vector<Mesh::Pointer> meshes;
  for (const SurfaceLabel & surface : settings.surfaceLabels)
  {
    meshes.push_back(ReadSurface(surface.file, settings.surfacesAreInRAS));
  }
  if (input.labels.IsNull())
  {
    input.labels = MakeGrid(settings, meshes);
  }
  for (std::size_t n = 0; n < meshes.size(); ++n)
  {
    const SurfaceLabel & surface = settings.surfaceLabels[n];
    input.surfaces.distances.emplace_back(ComputeDistance(surface.file, meshes[n], input.labels).GetPointer());
    input.surfaces.labels.push_back(surface.label);
  }
  input.voxels = mmm::CountLabels(mmm::ComposeLabels(input.labels, input.surfaces));
  for (const SurfaceLabel & surface : settings.surfaceLabels)
  {
    if (input.voxels.count(surface.label) == 0)
    {
      Warn(surface.file + ": later surfaces cover this one, so label " + std::to_string(surface.label) +
           " is not in the mesh");
    }
  }
  for (const auto & entry : mmm::CountLabels(input.labels))
  {
    if (input.voxels.count(entry.first) == 0 && !settings.IsExterior(entry.first))
    {
      Warn("surfaces cover all voxels of label " + std::to_string(entry.first) + ", which is not in the mesh");
    }
  }
}
} // namespace cli
