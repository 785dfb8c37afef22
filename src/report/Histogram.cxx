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
#include "report/Histogram.h"

#include "report/HTML.h"
#include "report/SvgPath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mmm
{
namespace
{
// In units of the drawing.
constexpr long BarWidth = 10;
constexpr long Gap = 1;
constexpr long Height = 100;

std::string
RangeText(const Histogram & histogram, std::size_t bin)
{
  const double width = (histogram.last - histogram.first) / double(histogram.counts.size());
  return Decimal(histogram.first + width * double(bin), histogram.decimals) + " to " +
         Decimal(histogram.first + width * double(bin + 1), histogram.decimals) + histogram.unit;
}

std::size_t
Sum(const Histogram & histogram)
{
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t(0));
}

std::string
PercentText(const Histogram & histogram, std::size_t bin)
{
  return Decimal(100.0 * double(histogram.counts[bin]) / double(std::max<std::size_t>(Sum(histogram), 1)), 2) + " %";
}

std::string
BarData(const Histogram & histogram, std::size_t bin)
{
  const auto most = std::max<std::size_t>(*std::max_element(histogram.counts.begin(), histogram.counts.end()), 1);
  const long height = std::lround(double(Height) * double(histogram.counts[bin]) / double(most));
  const long left = long(bin) * BarWidth;
  SvgPath    path;
  path.MoveTo({ { left, Height } });
  path.LineTo({ { left, Height - height } });
  path.LineTo({ { left + BarWidth - Gap, Height - height } });
  path.LineTo({ { left + BarWidth - Gap, Height } });
  path.Close();
  return path.GetText();
}

std::string
BeginDrawing(const Histogram & histogram, const std::string & name)
{
  return "<svg class=\"" + name + "\" viewBox=\"0 0 " + std::to_string(long(histogram.counts.size()) * BarWidth - Gap) +
         ' ' + std::to_string(Height) + "\" preserveAspectRatio=\"none\" role=\"img\"><title>" +
         EscapedHTML(Describe(histogram)) + "</title>";
}
} // namespace

std::string
Describe(const Histogram & histogram)
{
  const auto & counts = histogram.counts;
  if (Sum(histogram) == 0)
  {
    return histogram.what + ": none";
  }
  const auto most = std::size_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
  return histogram.what + ": " + PercentText(histogram, most) + " are from " + RangeText(histogram, most) +
         ", more than in any other range";
}

std::string
DrawSmall(const Histogram & histogram)
{
  std::string drawing = BeginDrawing(histogram, "histogram") + "<path d=\"";
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
  {
    // each begins with a move, which would be relative to the last one
    std::string bar = BarData(histogram, bin);
    bar.front() = 'M';
    drawing += bar;
  }
  return drawing + "\"/></svg>";
}

std::string
DrawLarge(const Histogram & histogram)
{
  std::string figure = "<figure class=\"distribution\">\n<figcaption>" + EscapedHTML(histogram.what) +
                       "</figcaption>\n" + BeginDrawing(histogram, "histogram large") + '\n';
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
  {
    const std::string text =
      RangeText(histogram, bin) + ": " + std::to_string(histogram.counts[bin]) + ", " + PercentText(histogram, bin);
    figure += "<path d=\"" + BarData(histogram, bin) + "\"><title>" + EscapedHTML(text) + "</title></path>\n";
  }
  figure += "</svg>\n<div class=\"axis\" aria-hidden=\"true\">";
  for (int part = 0; part <= histogram.parts; ++part)
  {
    const double share = double(part) / histogram.parts;
    figure +=
      "<span>" + Decimal(histogram.first + share * (histogram.last - histogram.first), histogram.decimals) + "</span>";
  }
  return figure + "</div>\n</figure>\n";
}
} // namespace mmm
