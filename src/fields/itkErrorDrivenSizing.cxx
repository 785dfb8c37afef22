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
#include "itkErrorDrivenSizing.h"

#include "itkVTUMeshIO.h"
#include "mesh/TetrahedronQuality.h"
#include "mesh/TetrahedronRaster.h"

#include "itkContinuousIndex.h"
#include "itkMeshFileReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace itk
{
namespace
{
/** The most times as many tetrahedra as there are: edges get no shorter than a quarter. */
constexpr double MostPerTetrahedron = 64.0;
/** Edges that would be no shorter than this, of those that there are, stay as they are asked for. */
constexpr double ShareThatStays = 0.98;
/** More tetrahedra than this share outside of the image are those of another one. */
constexpr double MostOutside = 0.1;
constexpr float  NoLength = std::numeric_limits<float>::infinity();

using Place = mmm::Vector;
using Corners = std::array<Place, 4>;

Corners
CornersOf(const TetrahedronArrays & mesh, std::size_t t)
{
  Corners corners;
  for (int c = 0; c < 4; ++c)
  {
    const auto & point = mesh.points[mesh.tetrahedra[t][c]];
    corners[c] = Place(point[0], point[1], point[2]);
  }
  return corners;
}

double
MeanEdge(const Corners & corners)
{
  double sum = 0.0;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = 0; b < a; ++b)
    {
      sum += (corners[a] - corners[b]).norm();
    }
  }
  return sum / 6.0;
}

/** Values per volume, evened out: the mean over the tetrahedra of each point, then over the points of each
 * tetrahedron. */
std::vector<double>
EvenedOut(const TetrahedronArrays & mesh, const std::vector<double> & values, const std::vector<double> & volumes)
{
  std::vector<double> sums(mesh.points.size(), 0.0);
  std::vector<double> around(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    for (const auto corner : mesh.tetrahedra[t])
    {
      sums[corner] += values[t];
      around[corner] += volumes[t];
    }
  }
  std::vector<double> even(values.size(), 0.0);
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    for (const auto corner : mesh.tetrahedra[t])
    {
      even[t] += around[corner] > 0.0 ? 0.25 * volumes[t] * sums[corner] / around[corner] : 0.0;
    }
  }
  return even;
}

/** The numbers of tetrahedra that shall take the place of each, if each of these has at most the error `most`. */
double
NumberFor(double error, double most, double power)
{
  return error <= most ? 1.0 : std::min(MostPerTetrahedron, std::pow(error / most, power));
}

/** The largest error of a tetrahedron for which there are so many, or as many as can be. */
double
ErrorFor(const std::vector<double> & errors, double wanted, double power)
{
  constexpr int Halvings = 30;
  double        upper = *std::max_element(errors.begin(), errors.end());
  double        lower = upper * 1e-12;
  for (int n = 0; n < Halvings; ++n)
  {
    const double middle = std::sqrt(lower * upper);
    double       count = 0.0;
    for (const double error : errors)
    {
      count += NumberFor(error, middle, power);
    }
    (count > wanted ? lower : upper) = middle;
  }
  return upper;
}

/** The edge length that each tetrahedron asks for; infinity if its edges may stay as they are. */
std::vector<float>
LengthsFor(const TetrahedronArrays & mesh, const std::vector<double> & errors, double factor, unsigned int order)
{
  const std::size_t   count = errors.size();
  std::vector<double> volumes(count);
  std::vector<double> squares(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const Corners corners = CornersOf(mesh, t);
    volumes[t] = std::abs(mmm::TetrahedronVolume(corners[0], corners[1], corners[2], corners[3]));
    squares[t] = errors[t] * errors[t];
  }
  std::vector<double> even = EvenedOut(mesh, squares, volumes);
  std::transform(even.begin(), even.end(), even.begin(), [](double square) { return std::sqrt(square); });
  // where edges have the length h, an error goes with the power of p + 3/2 of h, the number with that of -3
  const double       power = 3.0 / (order + 1.5);
  const double       most = ErrorFor(even, factor * double(count), power);
  std::vector<float> lengths(count, NoLength);
  for (std::size_t t = 0; t < count; ++t)
  {
    const double share = std::cbrt(1.0 / NumberFor(even[t], most, power));
    if (share < ShareThatStays)
    {
      lengths[t] = float(share * MeanEdge(CornersOf(mesh, t)));
    }
  }
  return lengths;
}

/** The shortest length that is asked for at each voxel. */
class SizeRaster
{
public:
  explicit SizeRaster(const ErrorDrivenSizing::ReferenceImageType * grid)
    : m_Image(ErrorDrivenSizing::ImageType::New())
  {
    m_Image->CopyInformation(grid);
    m_Image->SetRegions(grid->GetLargestPossibleRegion());
    m_Image->Allocate();
    m_Image->FillBuffer(NoLength);
    for (unsigned int a = 0; a < 3; ++a)
    {
      m_Grid.size[a] = int(grid->GetLargestPossibleRegion().GetSize(a));
    }
  }

  /** Lowers the lengths in a tetrahedron. Returns whether its middle is in the image. */
  bool
  Lower(const TetrahedronArrays & mesh, std::size_t t, float length)
  {
    Corners corners; // in voxels, from the first one
    Place   middle = Place::Zero();
    for (int c = 0; c < 4; ++c)
    {
      ContinuousIndex<double, 3> at;
      static_cast<void>(m_Image->TransformPhysicalPointToContinuousIndex(mesh.points[mesh.tetrahedra[t][c]], at));
      for (unsigned int a = 0; a < 3; ++a)
      {
        corners[c][a] = at[a] - double(m_Image->GetLargestPossibleRegion().GetIndex(a));
      }
      middle += 0.25 * corners[c];
    }
    const mmm::Index nearest{
      { int(std::lround(middle[0])), int(std::lround(middle[1])), int(std::lround(middle[2])) }
    };
    if (length < NoLength)
    {
      mmm::VisitIndicesInside(m_Grid.size, corners, 0.0, [&](const mmm::Index & at) { this->LowerAt(at, length); });
    }
    if (!m_Grid.Contains(nearest))
    {
      return false;
    }
    this->LowerAt(nearest, length); // small ones may have no voxel's center in them
    return true;
  }

  ErrorDrivenSizing::ImageType::Pointer
  GetImage() const
  {
    return m_Image;
  }

private:
  void
  LowerAt(const mmm::Index & at, float length)
  {
    float & pixel = m_Image->GetBufferPointer()[m_Grid.Offset(at)];
    pixel = std::min(pixel, length);
  }

  ErrorDrivenSizing::ImageType::Pointer m_Image;
  mmm::Grid                             m_Grid;
};
} // namespace

void
ErrorDrivenSizing::SetErrors(const LabelTetrahedralMesh * mesh, const std::vector<double> & errors)
{
  if (mesh == nullptr)
  {
    itkExceptionMacro("There is no mesh.");
  }
  this->Set(TetrahedronReader(mesh, TetrahedronReader<LabelTetrahedralMesh>::OtherCells::Throw).arrays, errors);
}

void
ErrorDrivenSizing::ReadErrors(const std::string & fileName, const std::string & arrayName)
{
  using ErrorMesh = Mesh<double, 3, DefaultStaticMeshTraits<double, 3, 3, double>>;
  const auto io = VTUMeshIO::New();
  io->SetCellDataNames({ arrayName });
  const auto reader = MeshFileReader<ErrorMesh>::New();
  reader->SetMeshIO(io);
  reader->SetFileName(fileName);
  reader->Update();
  if (io->GetReadCellDataNames() != VTUMeshIO::NamesType{ arrayName })
  {
    itkExceptionMacro("\"" << fileName << "\" has no cell data array '" << arrayName << "'.");
  }
  if (io->GetNumberOfCellPixelComponents() != 1)
  {
    itkExceptionMacro("\"" << fileName << "\": the cell data array '" << arrayName << "' has "
                           << io->GetNumberOfCellPixelComponents() << " numbers for each cell; it has to be one.");
  }
  ErrorMesh::CellDataContainer::Pointer data = reader->GetOutput()->GetCellData();
  reader->GetOutput()->SetCellData(nullptr); // errors are no labels
  TetrahedronReader   tetrahedra(static_cast<const ErrorMesh *>(reader->GetOutput()),
                               TetrahedronReader<ErrorMesh>::OtherCells::LeaveOut);
  std::vector<double> errors;
  errors.reserve(tetrahedra.cellIdentifiers.size());
  for (const auto cell : tetrahedra.cellIdentifiers)
  {
    errors.push_back(data->ElementAt(cell));
  }
  this->Set(std::move(tetrahedra.arrays), std::move(errors));
}

void
ErrorDrivenSizing::Set(TetrahedronArrays arrays, std::vector<double> errors)
{
  if (arrays.tetrahedra.size() != errors.size())
  {
    itkExceptionMacro("There are " << errors.size() << " errors for " << arrays.tetrahedra.size() << " tetrahedra.");
  }
  const auto wrong =
    std::find_if(errors.begin(), errors.end(), [](double error) { return !(error >= 0.0) || std::isinf(error); });
  if (wrong != errors.end())
  {
    itkExceptionMacro("The error of tetrahedron " << wrong - errors.begin() << " is " << *wrong
                                                  << "; it has to be a number of at least 0.");
  }
  if (std::all_of(errors.begin(), errors.end(), [](double error) { return error == 0.0; }))
  {
    itkExceptionMacro("All errors are 0: there is nothing to refine.");
  }
  m_Mesh = std::move(arrays);
  m_Errors = std::move(errors);
  this->Modified();
}

ErrorDrivenSizing::ImageType::Pointer
ErrorDrivenSizing::Compute(const ReferenceImageType * grid) const
{
  if (m_Errors.empty() || grid == nullptr)
  {
    itkExceptionMacro("There are no errors, or there is no image for their grid.");
  }
  if (!(m_Factor > 1.0 && m_Factor <= MostPerTetrahedron))
  {
    itkExceptionMacro("Factor is " << m_Factor << "; it has to be above 1 and at most " << MostPerTetrahedron << '.');
  }
  if (m_Order < 1 || m_Order > 2)
  {
    itkExceptionMacro("Order is " << m_Order << "; it has to be 1 or 2.");
  }
  const auto  lengths = LengthsFor(m_Mesh, m_Errors, m_Factor, m_Order);
  SizeRaster  raster(grid);
  std::size_t outside = 0;
  for (std::size_t t = 0; t < lengths.size(); ++t)
  {
    outside += !raster.Lower(m_Mesh, t, lengths[t]);
  }
  if (double(outside) > MostOutside * double(lengths.size()))
  {
    itkExceptionMacro(<< outside << " of the " << lengths.size()
                      << " tetrahedra with errors are outside of the image: is it a mesh of this image, with points in "
                         "LPS and mm?");
  }
  return raster.GetImage();
}

void
ErrorDrivenSizing::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Errors: " << m_Errors.size() << '\n';
  os << indent << "Factor: " << m_Factor << '\n';
  os << indent << "Order: " << m_Order << '\n';
}
} // end namespace itk
