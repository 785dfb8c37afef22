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
// Tensors: the order of their components, and the axes that they are told along.
#include "itkVolumeFileReader.h"
#include "support/TestNifti.h"

#include "itkImageFileReader.h" // registers ITK's formats
#include "itkMacro.h"
#include "itkTetrahedronCell.h"
#include "itkTetrahedronImageSampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace
{
using Tensor = itk::VolumeFileReader::TensorImageType::PixelType;
using Components = std::array<double, 6>;

class TensorVolume : public testing::Test
{
public:
  TensorVolume()
    : m_Folder(std::filesystem::temp_directory_path() /
               ("tensors-" + std::to_string(std::hash<std::string>()(
                               testing::UnitTest::GetInstance()->current_test_info()->name()))))
  {
    std::filesystem::create_directories(m_Folder);
  }

  ~TensorVolume() override { std::filesystem::remove_all(m_Folder); }

  std::string
  Path(const std::string & name) const
  {
    return (m_Folder / name).string();
  }

  /** 6 x 5 x 4 voxels with the components of all of them in the file's order. */
  std::string
  WriteNifti(TestNifti nifti, const std::string & name, const Components & components) const
  {
    const std::size_t voxels = 6 * 5 * 4;
    nifti.SetVoxels<float>(16, 0.0f, 0.0f);
    const std::int16_t dim[8] = { 5, 6, 5, 4, 1, 6, 1, 1 };
    for (int d = 0; d < 8; ++d)
    {
      nifti.Set<std::int16_t>(40 + 2 * d, dim[d]);
    }
    nifti.Set<std::int16_t>(68, 1005);
    nifti.bytes.resize(352 + 6 * voxels * sizeof(float));
    for (std::size_t n = 0; n < 6 * voxels; ++n)
    {
      nifti.Set<float>(352 + sizeof(float) * n, static_cast<float>(components[n / voxels]));
    }
    nifti.Write(this->Path(name));
    return this->Path(name);
  }

  std::string
  WriteNrrd(const std::string & name, const std::string & space, const Components & components) const
  {
    std::ofstream stream(this->Path(name), std::ios::binary);
    stream << "NRRD0005\ntype: float\ndimension: 4\n"
           << space << "\nsizes: 6 3 3 3\nkinds: 3D-symmetric-matrix domain domain domain\nendian: little\n"
           << "encoding: text\n\n";
    for (int n = 0; n < 27; ++n)
    {
      for (const double component : components)
      {
        stream << component << ' ';
      }
    }
    return this->Path(name);
  }

  static itk::VolumeFileReader::TensorImageType::Pointer
  Read(const std::string & fileName, bool inVoxelAxes = false)
  {
    const auto reader = itk::VolumeFileReader::New();
    reader->GlobalWarningDisplayOff();
    reader->SetFileName(fileName);
    reader->SetTensorsInVoxelAxes(inVoxelAxes);
    EXPECT_TRUE(reader->HasTensors());
    const auto image = reader->ReadTensors();
    reader->GlobalWarningDisplayOn();
    return image;
  }

  /** xx, xy, xz, yy, yz, zz of all voxels. */
  static void
  ExpectTensors(const itk::VolumeFileReader::TensorImageType & image, const Components & expected)
  {
    const std::size_t count = image.GetBufferedRegion().GetNumberOfPixels();
    for (const std::size_t n : { std::size_t{ 0 }, count / 2, count - 1 })
    {
      for (unsigned int c = 0; c < 6; ++c)
      {
        EXPECT_NEAR(image.GetBufferPointer()[n][c], expected[c], 1e-5) << "component " << c << " of voxel " << n;
      }
    }
  }

protected:
  std::filesystem::path m_Folder;
};

const std::string Directions = "\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\nspace origin: (10,20,30)";
} // namespace

TEST_F(TensorVolume, NiftiHasTheLowerTriangleInRAS)
{
  // xx, xy, yy, xz, yz, zz
  for (const char * const name : { "x.nii", "x.nii.gz" })
  {
    const auto image = Read(this->WriteNifti({}, name, { 1, 2, 4, 3, 5, 6 }));
    ExpectTensors(*image, { 1, 2, -3, 4, -5, 6 });
    EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(), (itk::Size<3>{ { 6, 5, 4 } }));
    EXPECT_NEAR(image->GetSpacing()[2], 3.0, 1e-6);
    // the header's 10, 20, 30 in RAS
    EXPECT_NEAR(image->GetOrigin()[0], -10.0, 1e-5);
    EXPECT_NEAR(image->GetOrigin()[1], -20.0, 1e-5);
  }
}

TEST_F(TensorVolume, NiftiAlongVoxelsTurnsWithThem)
{
  TestNifti nifti;
  // the first axis goes to the front, the second one to the left
  nifti.SetSform({ 0, -2, 0, 10, 1, 0, 0, 20, 0, 0, 3, 30 });
  // in LPS, the first axis is -y and the second one x
  ExpectTensors(*Read(this->WriteNifti(nifti, "x.nii", { 1, 2, 4, 3, 5, 6 }), true), { 4, -2, 5, 1, -3, 6 });
}

TEST_F(TensorVolume, NrrdHasItsMeasurementFrame)
{
  const Components upper{ 1, 2, 3, 4, 5, 6 };
  ExpectTensors(*Read(this->WriteNrrd("lps.nrrd", "space: left-posterior-superior" + Directions, upper)), upper);
  const auto ras = Read(this->WriteNrrd("ras.nrrd", "space: right-anterior-superior" + Directions, upper));
  ExpectTensors(*ras, { 1, 2, -3, 4, -5, 6 });
  EXPECT_NEAR(ras->GetOrigin()[0], -10.0, 1e-6);
  // the first axis of the components is y of the space, the second one -x
  const std::string frame = "\nmeasurement frame: (0,1,0) (-1,0,0) (0,0,1)";
  ExpectTensors(*Read(this->WriteNrrd("frame.nrrd", "space: left-posterior-superior" + Directions + frame, upper)),
                { 4, -2, -5, 1, 3, 6 });
}

TEST_F(TensorVolume, AreSampledAsMatrices)
{
  const auto image =
    Read(this->WriteNrrd("x.nrrd", "space: left-posterior-superior" + Directions, { 1, 2, 3, 4, 5, 6 }));
  const auto   mesh = itk::LabelTetrahedralMesh::New();
  const double points[][3] = { { 10, 20, 30 }, { 11, 20, 30 }, { 10, 22, 30 }, { 10, 20, 33 } };
  itk::LabelTetrahedralMesh::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TetrahedronCell<itk::LabelTetrahedralMesh::CellType>);
  for (unsigned int c = 0; c < 4; ++c)
  {
    mesh->SetPoint(c, itk::Point<double, 3>(points[c]));
    cell->SetPointId(c, c);
  }
  mesh->SetCell(0, cell);
  const auto sampler = itk::TetrahedronImageSampler::New();
  sampler->SetMesh(mesh);
  const auto                  values = sampler->SampleTensors(image);
  const std::array<double, 9> expected{ { 1, 2, 3, 2, 4, 5, 3, 5, 6 } };
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t c = 0; c < expected.size(); ++c)
  {
    EXPECT_NEAR(values[c], expected[c], 1e-5) << c;
  }
}

TEST_F(TensorVolume, OtherFilesHaveNone)
{
  TestNifti().Write(this->Path("x.nii"));
  const auto reader = itk::VolumeFileReader::New();
  reader->SetFileName(this->Path("x.nii"));
  EXPECT_FALSE(reader->HasTensors());
  EXPECT_THROW(reader->ReadTensors(), itk::ExceptionObject);
  reader->SetFileName(this->Path("none.nii"));
  EXPECT_THROW(reader->HasTensors(), itk::ExceptionObject);
  // a file that ends early
  std::filesystem::resize_file(this->WriteNifti({}, "short.nii", { 1, 2, 4, 3, 5, 6 }), 2000);
  reader->SetFileName(this->Path("short.nii"));
  EXPECT_THROW(reader->ReadTensors(), itk::ExceptionObject);
}
