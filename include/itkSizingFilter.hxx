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
#ifndef itkSizingFilter_hxx
#define itkSizingFilter_hxx

namespace itk
{
template <typename TSuperclass, typename TSizingImage>
SizingFilter<TSuperclass, TSizingImage>::SizingFilter()
{
  this->AddOptionalInputName("SizingImage");
  this->AddOptionalInputName("RegionOfInterest");
}

template <typename TSuperclass, typename TSizingImage>
void
SizingFilter<TSuperclass, TSizingImage>::SetSizingImage(const TSizingImage * image)
{
  this->ProcessObject::SetInput("SizingImage", const_cast<TSizingImage *>(image));
}

template <typename TSuperclass, typename TSizingImage>
const TSizingImage *
SizingFilter<TSuperclass, TSizingImage>::GetSizingImage() const
{
  return dynamic_cast<const TSizingImage *>(this->ProcessObject::GetInput("SizingImage"));
}

template <typename TSuperclass, typename TSizingImage>
void
SizingFilter<TSuperclass, TSizingImage>::SetRegionOfInterest(const MaskImageType * mask)
{
  this->ProcessObject::SetInput("RegionOfInterest", const_cast<MaskImageType *>(mask));
}

template <typename TSuperclass, typename TSizingImage>
auto
SizingFilter<TSuperclass, TSizingImage>::GetRegionOfInterest() const -> const MaskImageType *
{
  return dynamic_cast<const MaskImageType *>(this->ProcessObject::GetInput("RegionOfInterest"));
}

template <typename TSuperclass, typename TSizingImage>
void
SizingFilter<TSuperclass, TSizingImage>::SetLabelSizes(const LabelSizesType & sizes)
{
  m_LabelSizes = sizes;
  this->Modified();
}

template <typename TSuperclass, typename TSizingImage>
void
SizingFilter<TSuperclass, TSizingImage>::SetLabelSizes(const std::string & text)
{
  this->SetLabelSizes(mmm::ParseLabelSizeRules(text));
}

template <typename TSuperclass, typename TSizingImage>
mmm::SizingInputs
SizingFilter<TSuperclass, TSizingImage>::GetSizingInputs() const
{
  mmm::SizingInputs inputs;
  inputs.options.epsilon = m_Epsilon;
  inputs.options.chordTolerance = m_ChordTolerance;
  inputs.options.gradientLimit = m_GradientLimit;
  inputs.options.minimumSize = m_MinimumSize;
  inputs.options.maximumSize = m_MaximumSize;
  inputs.options.maximumVolume = m_MaximumVolume;
  inputs.options.labelSizes = m_LabelSizes;
  inputs.options.sizingImageReplaces = m_SizingImageReplaces;
  inputs.options.region.minimumSize = m_RegionMinimumSize;
  inputs.options.region.maximumSize = m_RegionMaximumSize;
  inputs.image = ToFloats(this->GetSizingImage());
  inputs.region = this->GetRegionOfInterest();
  return inputs;
}

template <typename TSuperclass, typename TSizingImage>
void
SizingFilter<TSuperclass, TSizingImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << m_Epsilon << std::endl;
  os << indent << "ChordTolerance: " << m_ChordTolerance << std::endl;
  os << indent << "GradientLimit: " << m_GradientLimit << std::endl;
  os << indent << "MinimumSize: " << m_MinimumSize << std::endl;
  os << indent << "MaximumSize: " << m_MaximumSize << std::endl;
  os << indent << "MaximumVolume: " << m_MaximumVolume << std::endl;
  os << indent << "LabelSizes: " << mmm::ToText(m_LabelSizes) << std::endl;
  os << indent << "SizingImageReplaces: " << (m_SizingImageReplaces ? "On" : "Off") << std::endl;
  os << indent << "RegionMinimumSize: " << m_RegionMinimumSize << std::endl;
  os << indent << "RegionMaximumSize: " << m_RegionMaximumSize << std::endl;
}
} // namespace itk

#endif
