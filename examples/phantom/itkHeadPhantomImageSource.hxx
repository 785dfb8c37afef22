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
#ifndef itkHeadPhantomImageSource_hxx
#define itkHeadPhantomImageSource_hxx

#include "phantom/HeadPhantom.h"

#include "itkImageScanlineIterator.h"
#include "itkTotalProgressReporter.h"

namespace itk
{
template <typename TOutputImage>
HeadPhantomImageSource<TOutputImage>::HeadPhantomImageSource()
{
  m_Origin[0] = -90.0;
  m_Origin[1] = -114.0;
  m_Origin[2] = -92.0;
  m_Direction.SetIdentity();
  this->DynamicMultiThreadingOn();
  this->ThreaderUpdateProgressOff();
}

template <typename TOutputImage>
void
HeadPhantomImageSource<TOutputImage>::GenerateOutputInformation()
{
  OutputImageType * output = this->GetOutput();
  output->SetLargestPossibleRegion(OutputImageRegionType(m_Size));
  output->SetSpacing(m_Spacing);
  output->SetOrigin(m_Origin);
  output->SetDirection(m_Direction);
}

template <typename TOutputImage>
void
HeadPhantomImageSource<TOutputImage>::DynamicThreadedGenerateData(const OutputImageRegionType & region)
{
  OutputImageType *     output = this->GetOutput();
  TotalProgressReporter progress(this, output->GetRequestedRegion().GetNumberOfPixels());
  PointType             point;

  for (ImageScanlineIterator<TOutputImage> it(output, region); !it.IsAtEnd(); it.NextLine())
  {
    for (auto index = it.GetIndex(); !it.IsAtEndOfLine(); ++it, ++index[0])
    {
      output->TransformIndexToPhysicalPoint(index, point);
      it.Set(static_cast<PixelType>(mmm::HeadPhantomTissue(mmm::Vector(point[0], point[1], point[2]))));
    }
    progress.Completed(region.GetSize(0));
  }
}

template <typename TOutputImage>
void
HeadPhantomImageSource<TOutputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << m_Size << std::endl;
  os << indent << "Spacing: " << m_Spacing << std::endl;
  os << indent << "Origin: " << m_Origin << std::endl;
  os << indent << "Direction: " << m_Direction << std::endl;
}
} // namespace itk

#endif
