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
#include "run/Output.h"

#include "console/Errors.h"
#include "console/StreamCapture.h"
#include "options/FileNames.h"
#include "itkLabelMeshFileWriter.h"
#include "itkLabelSurfaceMeshFilter.h"
#include "itkOutputFile.h"
#include "itkVTUMeshIO.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
// The writer gets its IO from here. ITK generates no header that registers mesh IOs if none of its own are in use.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileWriter.h"

#include <algorithm>

namespace cli
{
namespace
{
void
WriteMesh(Outcome &                         outcome,
          const itk::LabelTetrahedralMesh * tetrahedra,
          const itk::LabelInterfaceMesh *   surface,
          const itk::LabelMidNodeMesh *     midNodes,
          const std::string &               fileName)
{
  const auto writer = itk::LabelMeshFileWriter::New();
  writer->SetTetrahedra(tetrahedra);
  writer->SetSurface(surface);
  writer->SetMidNodes(midNodes);
  writer->SetFileName(fileName);
  writer->SetMshFormat(outcome.settings.mshFormat);
  writer->SetRAS(outcome.settings.ras);
  writer->SetWriteSpace(outcome.settings.slicerProgress);
  writer->SetOutsideLabel(outcome.filter->GetOutsideLabel());
  writer->SetLabelTable(outcome.input.names.table);
  if (tetrahedra != nullptr)
  {
    for (const CellDataRecord & record : outcome.cellData)
    {
      writer->AddCellData(record.name, record.values);
    }
  }
  writer->Write();
  outcome.files.push_back(fileName);
}

template <typename TMesh>
void
WriteVTU(Outcome & outcome, const TMesh * mesh, const std::string & fileName, itk::VTUMeshIO * io)
{
  io->SetWriteSpace(outcome.settings.slicerProgress);
  const auto writer = itk::MeshFileWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->SetMeshIO(io);
  writer->UseCompressionOn();
  writer->SetFileTypeAsBINARY();
  writer->Update();
  outcome.files.push_back(fileName);
}

void
WriteParticles(Outcome & outcome)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetPointDataNames({ "dimension", "label_a", "label_b", "label_c", "label_d" });
  WriteVTU(outcome, outcome.particles.GetPointer(), outcome.settings.particles, io);
}

void
WriteJunctions(Outcome & outcome)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "curve", "label_count", "label_a", "label_b", "label_c", "label_d" });
  WriteVTU(outcome, outcome.junctions.GetPointer(), outcome.settings.junctions, io);
}

/** ITK's image writers do not notice that a disk is full. */
void
CheckWritten(const ScalarImage & image, const std::string & fileName)
{
  auto reader = itk::ImageFileReader<ScalarImage>::New();
  reader->SetFileName(fileName);
  reader->Update();
  const auto          count = image.GetBufferedRegion().GetNumberOfPixels();
  const float * const written = reader->GetOutput()->GetBufferPointer();
  if (reader->GetOutput()->GetBufferedRegion().GetNumberOfPixels() != count ||
      !std::equal(written, written + count, image.GetBufferPointer()))
  {
    throw Error("the file is incomplete");
  }
}

void
WriteImage(const ScalarImage * image, const std::string & fileName)
{
  StreamCapture capture;
  try
  {
    itk::OutputFile file(fileName);
    auto            writer = itk::ImageFileWriter<ScalarImage>::New();
    writer->SetInput(image);
    writer->SetFileName(file.GetTemporaryName());
    writer->UseCompressionOn();
    writer->Update();
    CheckWritten(*image, file.GetTemporaryName());
    file.Commit();
  }
  catch (const itk::MemoryAllocationError &)
  {
    throw;
  }
  catch (const std::exception &)
  {
    throw Error("cannot write " + fileName + ", the disk may be full: " + DescribeCurrentException());
  }
}
} // namespace

void
WriteMeshes(Outcome & outcome)
{
  const Settings & settings = outcome.settings;
  WriteMesh(outcome,
            settings.surfaceOnly ? nullptr : outcome.tetrahedra.GetPointer(),
            outcome.surface,
            outcome.midNodes,
            settings.output);
  if (!settings.surface.empty())
  {
    WriteMesh(outcome, nullptr, outcome.surface, outcome.midNodes, settings.surface);
  }
  if (!settings.surfacePrefix.empty())
  {
    const auto filter = itk::LabelSurfaceMeshFilter::New();
    filter->SetInput(outcome.surface);
    for (const int label : filter->FindLabels(outcome.surface, outcome.filter->GetOutsideLabel()))
    {
      filter->SetLabel(label);
      filter->Update();
      WriteMesh(outcome,
                nullptr,
                filter->GetOutput(),
                nullptr,
                SurfaceName(settings.surfacePrefix, label, outcome.input.names.NameOf(label)));
    }
  }
  for (std::size_t h = 0; h < outcome.hulls.size(); ++h)
  {
    WriteMesh(outcome, nullptr, outcome.hulls[h]->GetOutput(), nullptr, settings.hulls[h].file);
  }
  if (!settings.particles.empty())
  {
    WriteParticles(outcome);
  }
  if (!settings.junctions.empty())
  {
    WriteJunctions(outcome);
  }
}

void
WriteImages(Outcome & outcome)
{
  const Settings & settings = outcome.settings;
  if (!settings.sizingFile.empty())
  {
    WriteImage(outcome.filter->GetComputedSizingImage(), settings.sizingFile);
    outcome.files.push_back(settings.sizingFile);
  }
  if (!settings.indicatorPrefix.empty())
  {
    for (const int label : outcome.filter->GetLabels())
    {
      outcome.files.push_back(IndicatorName(settings.indicatorPrefix, label));
      WriteImage(outcome.filter->GetIndicatorImage(label), outcome.files.back());
    }
  }
}
} // namespace cli
