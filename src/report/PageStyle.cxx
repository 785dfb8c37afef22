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
#include "report/PageSections.h"

namespace mmm
{
const char * const PageStyle = R"css(
:root {
  --back: #fff; --front: #1c2024; --weak: #5b6470; --line: #d5dae0; --panel: #f5f7f9; --bar: #3f6fa5;
  --edge: rgba(0, 0, 0, .55); --warn: #8a4b00; --picture: #fff;
}
@media (prefers-color-scheme: dark) {
  :root {
    --back: #15181c; --front: #e4e7eb; --weak: #9aa4af; --line: #363d45; --panel: #1e2328; --bar: #6d9fd6;
    --edge: rgba(0, 0, 0, .7); --warn: #f0b35f; --picture: #0b0d0f;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--front); font: 15px/1.5 system-ui, sans-serif; }
main { max-width: 100rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.6rem; margin: 0 0 1rem; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; border-bottom: 1px solid var(--line); }
a { color: var(--bar); }
.figures { display: flex; flex-wrap: wrap; gap: .6rem; margin: 0; }
.figures div { background: var(--panel); border-radius: 6px; padding: .5rem .9rem; }
.figures dt { color: var(--weak); font-size: .8rem; }
.figures dd { margin: 0; font-size: 1.2rem; font-variant-numeric: tabular-nums; }
.warnings { color: var(--warn); margin: 0; padding-left: 1.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: .4rem 0 1.2rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--weak); padding-bottom: .2rem; white-space: nowrap; }
th, td { padding: .15rem .7rem .15rem 0; border-bottom: 1px solid var(--line); text-align: left; }
th { font-weight: 500; vertical-align: bottom; }
thead th { color: var(--weak); font-size: .8rem; line-height: 1.2; }
tbody th { white-space: nowrap; }
#settings td { overflow-wrap: anywhere; }
.n { text-align: right; }
td.n { white-space: nowrap; }
.label { white-space: nowrap; margin-right: .6rem; }
summary { cursor: pointer; margin: .4rem 0; }
.swatch { display: inline-block; width: .8em; height: .8em; margin-right: .4em; border-radius: 2px;
  background: var(--c); border: 1px solid var(--line); }
.bar { display: inline-block; height: .7em; background: var(--bar); border-radius: 2px; min-width: 1px; }
#stages td:nth-child(3), #stages td:nth-child(5) { width: 14rem; }
.legend { display: flex; flex-wrap: wrap; gap: .1rem 1.1rem; list-style: none; margin: .4rem 0 .8rem; padding: 0;
  max-height: 10rem; overflow-y: auto; }
.layers { display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; }
.hint { color: var(--weak); }
[hidden] { display: none; }
.cuts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 1.2rem;
  align-items: start; }
.cut { margin: 0; min-width: 0; }
.cut.large { grid-column: 1 / -1; }
figcaption { color: var(--weak); font-size: .85rem; margin-bottom: .3rem; }
figcaption strong { color: var(--front); }
.frame { position: relative; background: var(--picture); border: 1px solid var(--line); border-radius: 4px;
  overflow: hidden; max-height: 92vh; max-width: 100%; margin: 0 auto; }
.frame svg { display: block; width: 100%; height: 100%; cursor: grab; touch-action: pan-y pinch-zoom; }
.frame svg:focus { outline: 2px solid var(--bar); outline-offset: -2px; }
.side { position: absolute; color: var(--front); font-size: .75rem; padding: 0 .3rem; pointer-events: none;
  text-shadow: 0 0 3px var(--picture), 0 0 3px var(--picture); }
.left { left: 0; top: 50%; }
.right { right: 0; top: 50%; } .top { left: 50%; top: 0; } .bottom { left: 50%; bottom: 0; }
.voxels path { fill: var(--c); fill-opacity: .45; }
.mesh path { fill: var(--c); fill-opacity: .8; stroke: var(--edge); stroke-width: 1.2; }
.edges { fill: none; stroke: var(--edge); stroke-width: .35; pointer-events: none; }
.mesh path, .edges { vector-effect: non-scaling-stroke; stroke-linejoin: round; }
.no-voxels .voxels, .no-mesh .mesh, .no-edges .edges, .off { display: none; }
.tools { margin: .3rem 0; }
.tools button { font: inherit; color: inherit; background: var(--panel); border: 1px solid var(--line);
  border-radius: 4px; min-width: 2.2rem; margin-right: .3rem; cursor: pointer; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 34rem)); gap: 1.5rem; }
.distribution { margin: 0 0 .8rem; }
.histogram { display: inline-block; width: 7rem; height: 1.7rem; vertical-align: bottom; fill: var(--bar); }
.histogram.large { display: block; width: 100%; height: 9rem; border-bottom: 1px solid var(--weak); }
.axis { display: flex; justify-content: space-between; color: var(--weak); font-size: .8rem; }
@media print {
  :root { --back: #fff; --front: #000; --weak: #444; --line: #bbb; --panel: #f3f3f3; --picture: #fff; --bar: #3f6fa5;
    --edge: rgba(0, 0, 0, .55); --warn: #8a4b00; }
  body { font-size: 9.5pt; }
  main { max-width: none; padding: 0; }
  .tools, .layers, .save, input { display: none; }
  .wide { overflow: visible; }
  .cuts { grid-template-columns: 1fr 1fr; }
  .cut, .distribution, tr { break-inside: avoid; }
  h2 { break-after: avoid; }
  .legend { max-height: none; }
  .swatch, .bar, .figures div, svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  th, td { padding-right: .4rem; }
  .histogram { width: 4rem; }
  .histogram.large { width: 100%; }
}
)css";
} // namespace mmm
