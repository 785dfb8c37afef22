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
#include "delaunay/TetGen.h"
#include "mesh/Incidence.h"
#include "base/MakeUnique.h"
#include "base/OutOfMemory.h"

#include "itkMacro.h"

#ifdef MMM_TETGEN_OF_SYSTEM
#  define terminatetetgen TetGensOwnTermination
#endif
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <new>
#include <sstream>
#include <string>

#ifdef MMM_TETGEN_OF_SYSTEM
#  undef terminatetetgen
// Visible to the dynamic linker even where the module is a static library, whose other symbols are hidden.
#  ifdef __GNUC__
__attribute__((visibility("default")))
#  endif
void
terminatetetgen(tetgenmesh *, int code);

/** What TetGen calls when it gives up. Its own frees the mesh and throws, whereupon the mesh's destructor frees it
 * again, and the program crashes. This one, which the dynamic linker finds first, leaves the memory to the destructor.
 */
void
terminatetetgen(tetgenmesh *, int code)
{
  throw code;
}
#endif

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

[[noreturn]] void
ThrowFailure(const std::string & words)
{
  throw TetGenFailure(__FILE__, __LINE__, words, "");
}

/** What went wrong in words; empty if nothing did.
 * \throw itk::MemoryAllocationError */
std::string
Run(const std::string & switches, tetgenio & in, tetgenio & out)
{
  constexpr int      OutOfMemory = 1;
  std::string        arguments = switches;
  std::ostringstream words;
  try
  {
    tetrahedralize(arguments.data(), &in, &out);
    return "";
  }
  catch (const char * assertion)
  {
    words << "its assertion failed: " << assertion;
  }
  catch (int code)
  {
    if (code == OutOfMemory)
    {
      ThrowOutOfMemory("TetGen");
    }
    words << "exit code " << code << ": " << Words(code);
  }
  catch (const std::bad_alloc &)
  {
    ThrowOutOfMemory("TetGen");
  }
  return "TetGen (" + switches + ") stopped, " + words.str() + " Input: " + std::to_string(in.numberofpoints) +
         " points, " + std::to_string(in.numberoffacets) + " facets.";
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
  const Vector     eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
  constexpr double Flatness = 1e-12; // a thickness of a millionth of the length
  return eigenvalues[0] > Flatness * eigenvalues[2];
}

/** TetGen's tetrahedra, each turned to positive orientation: its own varies. The orientation is exact, as that of its
 * own flips is: by a volume that is rounded, flat tetrahedra might be turned against their neighbours. They are sorted
 * by their smallest corners, so that points that are sorted in space make tetrahedra that are sorted in space. */
std::vector<Tetrahedron>
OrientedTetrahedra(const tetgenio & out)
{
  const std::size_t        points = out.numberofpoints;
  const std::size_t        count = out.numberoftetrahedra;
  const Incidence          order(points, count, [&out](std::size_t t) {
    const int * const corners = out.tetrahedronlist + 4 * t;
    return std::array<int, 1>{ { *std::min_element(corners, corners + 4) } };
  });
  std::vector<Tetrahedron> tetrahedra;
  tetrahedra.reserve(count);
  for (std::size_t p = 0; p < points; ++p)
  {
    for (auto t = order.Begin(p); t != order.End(p); ++t)
    {
      Tetrahedron tetrahedron;
      double *    x[4];
      for (int c = 0; c < 4; ++c)
      {
        const int corner = out.tetrahedronlist[4 * std::size_t(*t) + c];
        tetrahedron[c] = PointId(corner);
        x[c] = out.pointlist + std::size_t(3) * corner;
      }
      if (orient3d(x[0], x[1], x[2], x[3]) > 0.0) // the last one is below the others
      {
        std::swap(tetrahedron[2], tetrahedron[3]);
      }
      tetrahedra.push_back(tetrahedron);
    }
  }
  return tetrahedra;
}

/** Points and facets as TetGen takes them, each facet with its number as marker. */
struct FacetInput
{
  FacetInput(const std::vector<Vector> & points, const std::vector<Triangle> & facets)
    : m_Facets(facets.size())
    , m_Polygons(facets.size())
    , m_Corners(3 * facets.size())
    , m_Markers(facets.size())
  {
    SetPoints(io, points);
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      std::copy(facets[f].begin(), facets[f].end(), m_Corners.begin() + 3 * f);
      m_Polygons[f].vertexlist = &m_Corners[3 * f];
      m_Polygons[f].numberofvertices = 3;
      m_Facets[f].polygonlist = &m_Polygons[f];
      m_Facets[f].numberofpolygons = 1;
      m_Facets[f].holelist = nullptr;
      m_Facets[f].numberofholes = 0;
      m_Markers[f] = int(f);
    }
    io.facetlist = m_Facets.data();
    io.facetmarkerlist = m_Markers.data();
    io.numberoffacets = int(facets.size());
  }
  ~FacetInput()
  {
    // the memory of these lists is ours: take it back before tetgenio would free it
    io.facetlist = nullptr;
    io.facetmarkerlist = nullptr;
    io.numberoffacets = 0;
  }
  FacetInput(const FacetInput &) = delete;
  FacetInput &
  operator=(const FacetInput &) = delete;

  tetgenio io;

private:
  std::vector<tetgenio::facet>   m_Facets;
  std::vector<tetgenio::polygon> m_Polygons;
  std::vector<int>               m_Corners;
  std::vector<int>               m_Markers;
};
} // namespace

std::vector<Tetrahedron>
DelaunayTetrahedralization(const std::vector<Vector> & points)
{
  if (!FillSpace(points))
  {
    itkGenericExceptionMacro("No tetrahedra between " << points.size() << " points: they lie in one plane.");
  }
  // where it trips over the order in which it takes points, it may not over the one in which they are given
  std::string failure;
  for (const char * const switches : { "zJQ", "zJQb0" })
  {
    tetgenio in;
    tetgenio out;
    SetPoints(in, points);
    failure = Run(switches, in, out);
    if (failure.empty())
    {
      return OrientedTetrahedra(out);
    }
  }
  ThrowFailure(failure);
}

std::vector<Tetrahedron>
ConstrainedTetrahedralization(std::vector<Vector> & points, const std::vector<Triangle> & facets)
{
  FacetInput        in(points, facets);
  tetgenio          out;
  const std::string failure = Run("zpcYMJQ", in.io, out);
  if (!failure.empty())
  {
    ThrowFailure(failure);
  }

  // with -J TetGen keeps all input points in front, in their order
  for (std::size_t p = points.size(); p < std::size_t(out.numberofpoints); ++p)
  {
    points.emplace_back(out.pointlist[3 * p], out.pointlist[3 * p + 1], out.pointlist[3 * p + 2]);
  }
  return OrientedTetrahedra(out);
}

std::string
DescribeIntersections(const std::vector<Vector> & points, const std::vector<Triangle> & facets)
{
  constexpr int Listed = 10;
  FacetInput    in(points, facets);
  tetgenio      out;
  if (!Run("zpdQ", in.io, out).empty() || out.numberoftrifaces == 0 || out.trifacemarkerlist == nullptr)
  {
    return "";
  }
  std::vector<int> numbers(out.trifacemarkerlist, out.trifacemarkerlist + out.numberoftrifaces);
  MakeUnique(numbers);
  std::ostringstream text;
  text << " Facets that intersect others, by their number among the triangles of the surface: ";
  for (std::size_t n = 0; n < numbers.size() && n < Listed; ++n)
  {
    text << (n > 0 ? ", " : "") << numbers[n];
  }
  text << (numbers.size() > Listed ? " and more, " : " (") << numbers.size() << " in all"
       << (numbers.size() > Listed ? "." : ").");
  return text.str();
}
} // namespace mmm
