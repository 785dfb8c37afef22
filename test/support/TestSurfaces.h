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
#ifndef mmmTestSurfaces_h
#define mmmTestSurfaces_h

#include "itkMultiMaterialMeshTypes.h"
#include "distance/TriangleSurface.h"

#include "itkTriangleCell.h"

#include <cmath>
#include <functional>

/** Surfaces of triangles that tests turn into distances. */
namespace mmmtest
{
using SurfaceFunction = std::function<mmm::Vector(double, double)>;

/** Two triangles for each square of steps in u and v, which go from 0 to 1 and come back. Orientation is that of u and
 * v. */
inline mmm::TriangleSurface
MakeClosedSurface(int steps, const SurfaceFunction & point)
{
  mmm::TriangleSurface surface;
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; j < steps; ++j)
    {
      surface.points.push_back(point(double(i) / steps, double(j) / steps));
      const auto corner = [=](int di, int dj) { return std::uint32_t((i + di) % steps * steps + (j + dj) % steps); };
      surface.triangles.push_back({ { corner(0, 0), corner(1, 0), corner(0, 1) } });
      surface.triangles.push_back({ { corner(1, 0), corner(1, 1), corner(0, 1) } });
    }
  }
  return surface;
}

/** Around the third axis. */
inline mmm::TriangleSurface
MakeTorus(const mmm::Vector & centre, double radius, double tube, int steps)
{
  return MakeClosedSurface(steps, [=](double u, double v) {
    const double a = 2.0 * EIGEN_PI * u;
    const double b = 2.0 * EIGEN_PI * v;
    const double fromAxis = radius + tube * std::cos(b);
    return mmm::Vector(centre + mmm::Vector(fromAxis * std::cos(a), fromAxis * std::sin(a), tube * std::sin(b)));
  });
}

/** The faces of a cube, each divided and blown up to the sphere; without those squares for whose middle, on the unit
 * sphere, isThere is false. Normals point outward. */
inline mmm::TriangleSurface
MakeSphere(
  const mmm::Vector &                              centre,
  double                                           radius,
  int                                              steps,
  const std::function<bool(const mmm::Vector &)> & isThere = [](const mmm::Vector &) { return true; })
{
  mmm::TriangleSurface surface;
  const auto           at = [&](int face, double u, double v) {
    // the same on both sides of an edge of the cube, to the last digit
    const auto   spread = [](double k) { return std::abs(k) == 1.0 ? k : std::tan(0.25 * EIGEN_PI * k); };
    const int    axis = face / 2;
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    mmm::Vector  x;
    x[axis] = sign;
    x[(axis + 1) % 3] = sign * spread(u);
    x[(axis + 2) % 3] = spread(v);
    return mmm::Vector(x.normalized());
  };
  for (int face = 0; face < 6; ++face)
  {
    for (int i = 0; i < steps; ++i)
    {
      for (int j = 0; j < steps; ++j)
      {
        const auto coordinate = [=](double k) { return (2.0 * k - steps) / steps; };
        if (!isThere(at(face, coordinate(i + 0.5), coordinate(j + 0.5))))
        {
          continue;
        }
        const auto first = std::uint32_t(surface.points.size());
        for (const auto & [di, dj] : { std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1) })
        {
          surface.points.push_back(centre + radius * at(face, coordinate(i + di), coordinate(j + dj)));
        }
        surface.triangles.push_back({ { first, first + 1, first + 2 } });
        surface.triangles.push_back({ { first + 1, first + 3, first + 2 } });
      }
    }
  }
  return surface;
}

inline mmm::TriangleSurface
Join(const mmm::TriangleSurface & first, const mmm::TriangleSurface & second)
{
  auto       both = first;
  const auto offset = std::uint32_t(first.points.size());
  both.points.insert(both.points.end(), second.points.begin(), second.points.end());
  for (const auto & [a, b, c] : second.triangles)
  {
    both.triangles.push_back({ { a + offset, b + offset, c + offset } });
  }
  return both;
}

inline itk::LabelInterfaceMesh::Pointer
ToMesh(const mmm::TriangleSurface & surface)
{
  using MeshType = itk::LabelInterfaceMesh;
  const auto mesh = MeshType::New();
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    mesh->SetPoint(p, MeshType::PointType(surface.points[p].data()));
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    for (unsigned int k = 0; k < 3; ++k)
    {
      cell->SetPointId(k, surface.triangles[t][k]);
    }
    mesh->SetCell(t, cell);
  }
  return mesh;
}
} // namespace mmmtest

#endif
