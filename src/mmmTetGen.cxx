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
#include "mmmTetGen.h"
#include "mmmTetGenTermination.h"

#include "itkMacro.h"

#include <tetgen.h>

#include <algorithm>
#include <new>
#include <string>

namespace mmm
{
namespace
{
/** What TetGen says at the exit codes that it throws. */
const char *
Words(int code)
{
  switch (code)
  {
    case 1:
      return "Out of memory.";
    case 2:
      return "Encountered an internal error.";
    case 3:
      return "A self-intersection was detected.";
    case 4:
      return "A very small input feature size was detected.";
    case 5:
      return "Two very close input facets were detected.";
    case 10:
      return "An input error was detected.";
    default:
      return "Unknown exit code.";
  }
}

void
Run(const std::string & switches, tetgenio & in, tetgenio & out)
{
  std::string arguments = switches;
  try
  {
    const TetGenGuard guard;
    tetrahedralize(&arguments[0], &in, &out);
  }
  catch (const TetGenAssertion & assertion)
  {
    itkGenericExceptionMacro("TetGen (" << switches << ") stopped, its assertion failed: " << assertion.words
                                        << " Input: " << in.numberofpoints << " points, " << in.numberoffacets
                                        << " facets.");
  }
  catch (int code)
  {
    itkGenericExceptionMacro("TetGen (" << switches << ") stopped with exit code " << code << ": " << Words(code)
                                        << " Input: " << in.numberofpoints << " points, " << in.numberoffacets
                                        << " facets.");
  }
  catch (const std::bad_alloc &)
  {
    itkGenericExceptionMacro("TetGen (" << switches << ") ran out of memory. Input: " << in.numberofpoints
                                        << " points. Ask for larger elements, or use a machine with more memory.");
  }
}

void
SetPoints(tetgenio & io, const std::vector<Vector> & points)
{
  io.firstnumber = 0;
  io.numberofpoints = int(points.size());
  io.pointlist = new REAL[3 * points.size()];
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    std::copy_n(points[p].data(), 3, io.pointlist + 3 * p);
  }
}

/** Whether points do not all lie in one plane: TetGen crashes where they do. */
bool
FillSpace(const std::vector<Vector> & points)
{
  if (points.size() < 4)
  {
    return false;
  }
  Vector mean = Vector::Zero();
  for (const Vector & x : points)
  {
    mean += x / double(points.size());
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vector & x : points)
  {
    scatter += (x - mean) * (x - mean).transpose();
  }
  const Vector eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
  return eigenvalues[0] > 1e-12 * eigenvalues[2];
}

/** TetGen's tetrahedra, each turned to positive orientation: its own varies. */
std::vector<Tetrahedron>
OrientedTetrahedra(const tetgenio & out)
{
  std::vector<Tetrahedron> tetrahedra(out.numberoftetrahedra);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    Vector x[4];
    for (int c = 0; c < 4; ++c)
    {
      const int corner = out.tetrahedronlist[4 * t + c];
      tetrahedra[t][c] = PointId(corner);
      std::copy_n(out.pointlist + std::size_t(3) * corner, 3, x[c].data());
    }
    if (TetrahedronVolume(x[0], x[1], x[2], x[3]) < 0.0)
    {
      std::swap(tetrahedra[t][2], tetrahedra[t][3]);
    }
  }
  return tetrahedra;
}
} // namespace

std::vector<Tetrahedron>
DelaunayTetrahedralization(const std::vector<Vector> & points)
{
  if (!FillSpace(points))
  {
    itkGenericExceptionMacro("No tetrahedra between " << points.size() << " points: they lie in one plane.");
  }
  tetgenio in;
  tetgenio out;
  SetPoints(in, points);
  Run("zJQ", in, out);
  return OrientedTetrahedra(out);
}

std::vector<Tetrahedron>
ConstrainedTetrahedralization(std::vector<Vector> & points, const std::vector<Triangle> & facets)
{
  tetgenio in;
  tetgenio out;
  SetPoints(in, points);

  std::vector<tetgenio::facet>   facetList(facets.size());
  std::vector<tetgenio::polygon> polygons(facets.size());
  std::vector<int>               corners(3 * facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    std::copy(facets[f].begin(), facets[f].end(), corners.begin() + 3 * f);
    polygons[f].vertexlist = &corners[3 * f];
    polygons[f].numberofvertices = 3;
    facetList[f].polygonlist = &polygons[f];
    facetList[f].numberofpolygons = 1;
    facetList[f].holelist = nullptr;
    facetList[f].numberofholes = 0;
  }
  in.facetlist = facetList.data();
  in.numberoffacets = int(facets.size());

  // the memory of these lists is ours: take it back before tetgenio would free it
  const auto release = [&in]() {
    in.facetlist = nullptr;
    in.numberoffacets = 0;
  };
  try
  {
    Run("zpcYMJQ", in, out);
  }
  catch (...)
  {
    release();
    throw;
  }
  release();

  // with -J TetGen keeps all input points in front, in their order
  for (std::size_t p = points.size(); p < std::size_t(out.numberofpoints); ++p)
  {
    points.emplace_back(out.pointlist[3 * p], out.pointlist[3 * p + 1], out.pointlist[3 * p + 2]);
  }
  return OrientedTetrahedra(out);
}
} // namespace mmm
