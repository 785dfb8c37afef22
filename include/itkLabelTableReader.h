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
#ifndef itkLabelTableReader_h
#define itkLabelTableReader_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingLabels.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

#include <string>

namespace itk
{
/** \class LabelTableReader
 * \brief Reads the names and colors of labels from the tables that other programs have of them.
 *
 * By what is in the file: `.tsv` of BIDS (columns index, name, color), FreeSurfer's color table, `.ctbl` of 3D Slicer,
 * a label description of ITK-SNAP, `.json` (`{"3": "gray matter"}`, `{"3": {"name": "gray matter", "color":
 * "#cd3e4e"}}`,
 * `{"gray matter": 3}`; also as member `LabelMap` or `labels`), or lines with label and name. Of a `.seg.nrrd` of 3D
 * Slicer it reads the header; its labels are those that VolumeFileReader gives. Text is UTF-8.
 *
 * A broken table gives an ExceptionObject: the file, the line, what is wrong there.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT LabelTableReader : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelTableReader);

  using Self = LabelTableReader;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelTableReader);

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  void
  Read();

  /** What was read, by label. */
  itkGetConstReferenceMacro(LabelTable, mmm::LabelTable);

  /** The file that has the names of an image's labels, where a standard says so: the image itself, if it is a
   * `.seg.nrrd`; for an image whose name ends with `dseg`, as BIDS has it, `dseg.tsv` or a `dseg.json` with a
   * `LabelMap`, of the same name or with fewer entities, in its folder or above, up to the data set's. Empty if there
   * is none. */
  static std::string
  FindFileFor(const std::string & imageFileName);

protected:
  LabelTableReader() = default;
  ~LabelTableReader() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string     m_FileName;
  mmm::LabelTable m_LabelTable;
};
} // end namespace itk

#endif
