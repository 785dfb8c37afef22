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
// How well a mesh is conditioned: iterations of conjugate gradients for a current from the mesh's lowest to its highest
// point.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "base/Points.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkTetrahedronArrays.h"
#include "itkVTUMeshIO.h"
#include "mesh/TetrahedronQuality.h"

#include "itkMeshFileReader.h"

#include ITK_EIGEN(Sparse)

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
using Mesh = itk::LabelTetrahedralMesh;
using Reader = itk::TetrahedronReader<Mesh>;
using Matrix = Eigen::SparseMatrix<double>;

/** The share of the height where the current enters, and where it leaves. */
constexpr double EndShare = 0.05;

/** Conductivity 1 in one label, `contrast` in all others. */
Matrix
AssembleStiffness(const std::vector<mmm::Vector> & points,
                  const itk::TetrahedronArrays &   mesh,
                  int                              poorConductor,
                  double                           contrast)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    const auto &        corners = mesh.tetrahedra[t];
    const mmm::Vector & origin = points[corners[0]];
    Eigen::Matrix3d     edges;
    for (int c = 0; c < 3; ++c)
    {
      edges.row(c) = (points[corners[c + 1]] - origin).transpose();
    }
    // the gradients of the four linear basis functions
    Eigen::Matrix<double, 3, 4> gradients;
    gradients.rightCols<3>() = edges.inverse();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    const double weight = std::abs(edges.determinant()) / 6.0 * (mesh.labels[t] == poorConductor ? 1.0 : contrast);
    const Eigen::Matrix4d element = weight * gradients.transpose() * gradients;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        entries.emplace_back(int(corners[i]), int(corners[j]), element(i, j));
      }
    }
  }
  Matrix stiffness(points.size(), points.size());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

/** Fixes the potential of points at 0. */
void
Ground(Matrix & stiffness, const std::vector<char> & isGround)
{
  for (Eigen::Index column = 0; column < stiffness.outerSize(); ++column)
  {
    for (Matrix::InnerIterator entry(stiffness, column); entry; ++entry)
    {
      if (isGround[entry.row()] || isGround[entry.col()])
      {
        entry.valueRef() = entry.row() == entry.col() ? 1.0 : 0.0;
      }
    }
  }
}

void
Measure(const std::string & fileName, int poorConductor, double contrast)
{
  const auto reader = itk::MeshFileReader<Mesh>::New();
  reader->SetMeshIO(itk::VTUMeshIO::New());
  reader->SetFileName(fileName);
  reader->Update();
  const auto mesh = Reader(reader->GetOutput(), Reader::OtherCells::LeaveOut).arrays;
  const auto points = mmm::ToVectors(mesh.points);

  Matrix stiffness = AssembleStiffness(points, mesh, poorConductor, contrast);
  // what the current enters and leaves by must not depend on the mesh: the upper and the lower end of the body
  double lowest = 1e300;
  double highest = -1e300;
  for (const auto & corners : mesh.tetrahedra)
  {
    for (const auto p : corners)
    {
      lowest = std::min(lowest, points[p][2]);
      highest = std::max(highest, points[p][2]);
    }
  }
  const double      margin = EndShare * (highest - lowest);
  std::vector<char> isGround(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    isGround[p] = points[p][2] < lowest + margin;
  }
  Ground(stiffness, isGround);
  Eigen::VectorXd current = Eigen::VectorXd::Zero(stiffness.rows());
  for (const auto & c : mesh.tetrahedra)
  {
    const double z = 0.25 * (points[c[0]] + points[c[1]] + points[c[2]] + points[c[3]])[2];
    if (z > highest - margin)
    {
      const double volume = mmm::TetrahedronVolume(points[c[0]], points[c[1]], points[c[2]], points[c[3]]);
      for (const auto p : c)
      {
        current[p] += std::abs(volume) / 4.0;
      }
    }
  }
  current /= current.sum();

  using Solver = Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Eigen::DiagonalPreconditioner<double>>;
  Solver solver;
  solver.setTolerance(1e-8);
  solver.setMaxIterations(20000);
  const auto            begin = std::chrono::steady_clock::now();
  const Eigen::VectorXd potential = solver.compute(stiffness).solve(current);
  const double          seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cout << fileName << ": " << points.size() << " points, " << mesh.tetrahedra.size() << " tetrahedra, "
            << solver.iterations() << " iterations in " << seconds << " s, relative residual " << solver.error()
            << ", resistance " << potential.dot(current) << std::endl;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: conditioning POOR_CONDUCTOR_LABEL CONTRAST MESH.vtu...\n";
    return 2;
  }
  try
  {
    for (int n = 3; n < argc; ++n)
    {
      Measure(argv[n], std::atoi(argv[1]), std::atof(argv[2]));
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception & error)
  {
    std::cerr << "conditioning: " << error.what() << std::endl;
  }
  return EXIT_FAILURE;
}
