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
// TetGen's own mesh of the triangles between labels: what the optimizer and other meshes are compared with.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "base/Points.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkTetrahedronArrays.h"
#include "itkVTUMeshIO.h"
#include "mesh/InterfaceMesh.h"

#include "itkMeshFileReader.h"
#include "itkMeshFileWriter.h"

#include <tetgen.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
using Surface = itk::LabelInterfaceMesh;
using Mesh = itk::LabelTetrahedralMesh;

struct Input
{
  std::vector<mmm::Vector> points;
  mmm::InterfaceMesh       interfaces;
  /** By material. */
  std::vector<int> labels;
  mmm::Material    outside;
};

Input
Read(const std::string & fileName, int outsideLabel)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "label_a", "label_b" });
  const auto reader = itk::MeshFileReader<Surface>::New();
  reader->SetMeshIO(io);
  reader->SetFileName(fileName);
  reader->Update();
  const Surface * const surface = reader->GetOutput();

  Input input;
  for (const auto & point : surface->GetPoints()->CastToSTLConstContainer())
  {
    input.points.emplace_back(point[0], point[1], point[2]);
  }
  const auto & sides = surface->GetCellData()->CastToSTLConstContainer();
  input.labels.push_back(outsideLabel);
  for (const auto & pair : sides)
  {
    input.labels.insert(input.labels.end(), { pair[0], pair[1] });
  }
  std::sort(input.labels.begin(), input.labels.end());
  input.labels.erase(std::unique(input.labels.begin(), input.labels.end()), input.labels.end());
  const auto materialOf = [&input](int label) {
    return mmm::Material(std::lower_bound(input.labels.begin(), input.labels.end(), label) - input.labels.begin());
  };
  input.outside = materialOf(outsideLabel);
  for (auto cell = surface->GetCells()->Begin(); cell != surface->GetCells()->End(); ++cell)
  {
    const Surface::CellType & triangle = *cell.Value();
    mmm::Triangle             corners{ {} };
    std::copy(triangle.PointIdsBegin(), triangle.PointIdsEnd(), corners.begin());
    const auto & pair = sides[cell.Index()];
    input.interfaces.triangles.push_back(corners);
    input.interfaces.sides.push_back({ { materialOf(pair[0]), materialOf(pair[1]) } });
  }
  return input;
}

/** Appends TetGen's points to those of the surface. */
std::vector<mmm::Tetrahedron>
Tetrahedralize(Input & input, std::string switches)
{
  tetgenio in;
  tetgenio out;
  in.numberofpoints = int(input.points.size());
  in.pointlist = new REAL[3 * input.points.size()];
  for (std::size_t p = 0; p < input.points.size(); ++p)
  {
    std::copy_n(input.points[p].data(), 3, in.pointlist + 3 * p);
  }
  in.numberoffacets = int(input.interfaces.triangles.size());
  in.facetlist = new tetgenio::facet[input.interfaces.triangles.size()];
  for (std::size_t t = 0; t < input.interfaces.triangles.size(); ++t)
  {
    tetgenio::facet & facet = in.facetlist[t];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    std::copy_n(input.interfaces.triangles[t].begin(), 3, facet.polygonlist->vertexlist);
  }
  tetrahedralize(&switches[0], &in, &out);
  for (int p = in.numberofpoints; p < out.numberofpoints; ++p)
  {
    input.points.emplace_back(out.pointlist[3 * p], out.pointlist[3 * p + 1], out.pointlist[3 * p + 2]);
  }
  std::vector<mmm::Tetrahedron> tetrahedra(out.numberoftetrahedra);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    std::copy_n(out.tetrahedronlist + 4 * t, 4, tetrahedra[t].begin());
    const auto & c = tetrahedra[t];
    if (mmm::TetrahedronVolume(input.points[c[0]], input.points[c[1]], input.points[c[2]], input.points[c[3]]) < 0.0)
    {
      std::swap(tetrahedra[t][2], tetrahedra[t][3]);
    }
  }
  return tetrahedra;
}

void
Write(const Input & input, const std::vector<mmm::Tetrahedron> & tetrahedra, const std::string & fileName)
{
  const auto materials = mmm::LabelByInterfaces(input.interfaces, tetrahedra, input.outside);
  if (!materials)
  {
    itkGenericExceptionMacro("TetGen lost triangles of the surface.");
  }
  itk::TetrahedronArrays inside;
  inside.points = mmm::ToPoints(input.points);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    if ((*materials)[t] != input.outside)
    {
      inside.tetrahedra.push_back(tetrahedra[t]);
      inside.labels.push_back(input.labels[(*materials)[t]]);
    }
  }
  const auto mesh = Mesh::New();
  itk::FillMesh(inside, mesh.GetPointer());
  const auto writer = itk::MeshFileWriter<Mesh>::New();
  writer->SetMeshIO(itk::VTUMeshIO::New());
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->SetFileTypeAsBINARY();
  writer->Update();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: tetgen-mesh SURFACE.vtu MESH.vtu [SWITCHES [OUTSIDE_LABEL]]\n";
    return 2;
  }
  try
  {
    Input      input = Read(argv[1], argc > 4 ? std::atoi(argv[4]) : 0);
    const auto tetrahedra = Tetrahedralize(input, argc > 3 ? argv[3] : "zpYq1.4Q");
    Write(input, tetrahedra, argv[2]);
    std::cout << input.points.size() << " points" << std::endl;
    return EXIT_SUCCESS;
  }
  catch (const std::exception & error)
  {
    std::cerr << "tetgen-mesh: " << error.what() << std::endl;
  }
  catch (int code)
  {
    std::cerr << "tetgen-mesh: TetGen stopped with exit code " << code << std::endl;
  }
  return EXIT_FAILURE;
}
